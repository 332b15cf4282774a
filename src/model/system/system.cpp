#include "model/system/system.hpp"

#include "base/dense.hpp"
#include "base/error.hpp"
#include "model/scene/contact_faces.hpp"
#include "model/scene/default_penalty.hpp"
#include "model/scene/joins.hpp"
#include "model/scene/region.hpp"
#include "model/scene/ties.hpp"
#include "model/scene/turning.hpp"
#include "model/system/path_norm.hpp"
#include "nurbs/constants.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace signorini::model {

namespace {

/// Whether a face collapses to a point, in 3D also to a line: the scatter of its control points has too few directions.
template <int D> bool is_collapsed(const Scene<D>& scene, const FaceReference& face) {
  const nurbs::Discretization& space = scene.bodies[face.body].body->space();
  const MatrixX all = space.points();
  const std::vector<int> functions = space.face_functions(face.side);
  MatrixX points(D, functions.size());
  for (std::size_t i = 0; i < functions.size(); ++i) points.col(static_cast<Eigen::Index>(i)) = all.col(functions[i]);
  const MatrixX arms = points.colwise() - points.rowwise().mean().eval();
  const double size = (all.rowwise().maxCoeff() - all.rowwise().minCoeff()).norm();
  const VectorX squares = dense::symmetric_eigenvalues(arms * arms.transpose());
  return squares(1) <= std::pow(nurbs::same_place * size, 2); // of the D − 1 largest ones the least
}

/// Throws Error if a list of a contact's faces has one twice or a collapsed one, or if they do not form one surface.
template <int D> void check_list(const Scene<D>& scene, const Faces& faces, const Message& list) {
  for (auto face = faces.begin(); face != faces.end(); ++face)
    require(std::find(faces.begin(), face, *face) == face, "model.contact.face_twice",
            {{"list", list}, {"face", face_message(scene, *face)}});
  for (const FaceReference& face : faces)
    require(!is_collapsed(scene, face), "model.contact.collapsed",
            {{"list", list}, {"face", face_message(scene, face)}});
  if (faces.size() > 1) surface_of(scene, faces, list);
}

template <int D> void check_faces(const Scene<D>& scene, const Contact<D>& contact) {
  check_list(scene, contact.slave, Message("model.contact.slave", {{"name", contact.name}}));
  const auto* master = std::get_if<Faces>(&contact.master);
  if (!master) return;
  check_list(scene, *master, Message("model.contact.master", {{"name", contact.name}}));
  for (const FaceReference& face : contact.slave)
    require(!master->contains(face), "model.scene.own_face", {{"contact", contact.name}});
}

/// The scene, with default penalties and resolved joins. Throws Error if it has no body, or parts that do not fit.
template <int D> const Scene<D>& completed(Scene<D>& scene) {
  require(!scene.bodies.empty(), "model.scene.no_body");
  for (const auto& named : scene.bodies)
    require(named.body->kind() == scene.kind, "model.scene.kind", {{"body", named.name}});
  resolve_joins(scene);
  for (const Contact<D>& contact : scene.contacts) check_faces(scene, contact);
  set_default_penalties(scene);
  return scene;
}

/// Median of the elements' lengths, of surfaces of their shorter sides, at their middles: of meshes that are graded
/// towards the contact it is the size there, on which few tiny elements have no effect.
template <int D> double middle_size(const contact::Surface<D>& face) {
  std::vector<double> sizes;
  contact::FaceGeometry<D> point;
  for (int e = 0; e < face.elements(); ++e) {
    contact::FaceCoordinates<D> xi, length;
    for (int a = 0; a < D - 1; ++a) {
      const auto [from, to] = face.interval(e, a);
      xi(a) = (from + to) / 2;
      length(a) = to - from;
    }
    face.locate(e, xi, 1, point);
    for (int a = 0; a < D - 1; ++a) length(a) *= point.tangent[a].norm();
    sizes.push_back(length.minCoeff());
  }
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  return *middle;
}

template <int D> contact::Master<D> master_of(const Scene<D>& scene, const Contact<D>& contact) {
  const double opposite = middle_size(surface_of(scene, contact.slave));
  if (const auto* faces = std::get_if<Faces>(&contact.master)) return {surface_of(scene, *faces), opposite};
  const int obstacle = std::get<ObstacleReference>(contact.master).obstacle;
  const auto turn = turn_of(scene, obstacle);
  return {scene.obstacles[obstacle], turn ? std::optional(turn->turning) : std::nullopt, opposite};
}

template <int D> contact::Formulations<D> make_contacts(const Scene<D>& scene) {
  contact::Formulations<D> contacts;
  for (const Contact<D>& contact : scene.contacts)
    contacts.push_back(contact::make_formulation<D>(
        contact.method, {surface_of(scene, contact.slave), master_of(scene, contact), contact.points,
                         scene.kind == solid::Kind::axisymmetric, contact.where, contact.start, contact.bonded,
                         contact.adaptive_points}));
  return contacts;
}

/// Removes regions, which may refer to objects that exist only during construction.
template <int D> Scene<D> without_regions(Scene<D> scene) {
  for (Contact<D>& contact : scene.contacts) contact.where = contact.bonded = {};
  return scene;
}

} // namespace

template <int D>
System<D>::System(Scene<D> given)
    : contacts(make_contacts(completed(given))), ties(make_ties(given)), scene(without_regions(std::move(given))),
      unknowns(scene, contacts, ties), drives(scene, unknowns), followers(scene, unknowns, drives),
      springs(scene, unknowns), assembly(scene, unknowns, contacts, ties, followers, springs) {
  // Other shapes have rounding errors of the points that touch them (near_point.hpp).
  for (const auto& obstacle : scene.obstacles)
    if (const auto* patch = std::get_if<nurbs::Patch>(&obstacle))
      size = std::max(size, patch->points().cwiseAbs().maxCoeff());
  for (const auto& named : scene.bodies) {
    const MatrixX points = named.body->space().points();
    size = std::max(size, points.cwiseAbs().maxCoeff());
    const Vec<D> middle = points.rowwise().mean();
    const double radius = (points.colwise() - middle).colwise().norm().maxCoeff();
    extent = std::max(extent, 2 * radius);
  }
  for (std::size_t k = 0; k < contacts.size(); ++k)
    stiffness.push_back(contact_stiffness(scene, with_regions(scene.contacts[k], *contacts[k], size)));
}

template <int D> State<D> System<D>::start() const {
  State<D> state{VectorX::Zero(unknowns.dofs()), drives.start(), VectorX::Zero(unknowns.dofs()), 1, {}, {}};
  for (const auto& contact : contacts)
    state.contacts.emplace_back(contact->points(), contact->multipliers(), !contact->bonds().empty());
  for (const auto& named : scene.bodies) state.internal.push_back(solid::initial_values(*named.body));
  return state;
}

template <int D> void System<D>::commit(State<D>& present, const State<D>& accepted) {
  for (std::size_t k = 0; k < contacts.size(); ++k)
    contacts[k]->commit(present.contacts[k], accepted.contacts[k], present.penalty_factor);
}

template <int D> void System<D>::return_to_accepted(const State<D>& accepted) {
  assembly.move(accepted.displacement);
  for (const auto& contact : contacts) contact->return_to_accepted();
}

template <int D> void System<D>::settle(State<D>& accepted) {
  for (std::size_t k = 0; k < contacts.size(); ++k) contacts[k]->settle(accepted.contacts[k]);
  assembly.forget_contacts();
}

template <int D> const std::vector<UnconstrainedMotion>& System<D>::unconstrained() {
  if (!unconstrained_) unconstrained_ = unconstrained_motions(scene, unknowns);
  return *unconstrained_;
}

template <int D> const std::vector<UnconstrainedObstacle>& System<D>::unconstrained_obstacles() {
  if (!unconstrained_obstacles_) unconstrained_obstacles_ = model::unconstrained_obstacles(scene, unknowns);
  return *unconstrained_obstacles_;
}

template <int D> const VectorX& System<D>::path_weights() {
  if (!path_weights_) path_weights_ = model::path_weights(scene, unknowns);
  return *path_weights_;
}

template struct System<2>;
template struct System<3>;

} // namespace signorini::model
