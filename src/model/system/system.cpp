#include "model/system/system.hpp"

#include "base/error.hpp"
#include "model/scene/check.hpp"
#include "model/scene/contact_faces.hpp"
#include "model/scene/default_penalty.hpp"
#include "model/scene/joins.hpp"
#include "model/scene/region.hpp"
#include "model/scene/thickness.hpp"
#include "model/scene/ties.hpp"
#include "model/scene/turning.hpp"
#include "model/system/path_norm.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace signorini::model {

namespace {

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

template <int D>
contact::Master<D> master_of(const Scene<D>& scene, const Contact<D>& contact, const contact::Surface<D>& slave) {
  const double opposite = middle_size(slave);
  if (is_set(contact)) {
    const Groups connected = connected_bodies(scene, true);
    contact::SetParts parts;
    for (const FaceReference& face : contact.slave) {
      parts.bodies.push_back(connected.leader(face.body));
      parts.thickness.push_back(thickness(scene, face));
    }
    const std::size_t count = contact.slave.size();
    if (!contact.apart.empty()) parts.apart.assign(count * count, false);
    for (const auto& [i, k] : contact.apart) parts.apart[i * count + k] = parts.apart[k * count + i] = true;
    return {slave, opposite, std::move(parts)};
  }
  if (const auto* faces = std::get_if<Faces>(&contact.master)) return {surface_of(scene, *faces), opposite};
  const int obstacle = std::get<ObstacleReference>(contact.master).obstacle;
  const auto turn = turn_of(scene, obstacle);
  return {scene.obstacles[obstacle], turn ? std::optional(turn->turning) : std::nullopt, opposite};
}

/// An Error of the formulation names the contact.
template <int D> auto make_contact(const Scene<D>& scene, const Contact<D>& contact) {
  const contact::Surface<D> slave = slave_of(scene, contact);
  contact::ContactSetting<D> setting{slave,          master_of(scene, contact, slave),
                                     contact.points, scene.kind == solid::Kind::axisymmetric,
                                     contact.where,  contact.start,
                                     contact.bonded, contact.adaptive_points};
  try {
    return contact.own ? contact.own(std::move(setting))
                       : contact::make_formulation<D>(contact.method, std::move(setting));
  } catch (const Error& error) {
    fail("model.scene.contact", {{"contact", contact.name}, {"problem", error.message()}});
  }
}

template <int D> contact::Formulations<D> make_contacts(const Scene<D>& scene) {
  contact::Formulations<D> contacts;
  for (const Contact<D>& contact : scene.contacts) contacts.push_back(make_contact(scene, contact));
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
    : contacts(make_contacts(complete(given))), ties(make_ties(given)), scene(without_regions(std::move(given))),
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
  State<D> state{VectorX::Zero(unknowns.dofs()), drives.start(), VectorX::Zero(unknowns.dofs()), 1, 0, false, {}, {}};
  for (const auto& contact : contacts) state.contacts.own().push_back(initial_history(*contact));
  for (const auto& named : scene.bodies) state.internal.push_back(solid::initial_values(*named.body));
  return state;
}

template <int D> void System<D>::commit(State<D>& present, const State<D>& accepted) {
  std::vector<contact::History<D>>& histories = present.contacts.own();
  for (std::size_t k = 0; k < contacts.size(); ++k)
    contacts[k]->commit(histories[k], accepted.contacts[k], present.penalty_factor);
}

template <int D> void System<D>::return_to_accepted(const State<D>& accepted) {
  assembly.move(accepted.displacement);
  for (const auto& contact : contacts) contact->return_to_accepted();
}

template <int D> void System<D>::settle(State<D>& accepted) {
  std::vector<contact::History<D>>& histories = accepted.contacts.own();
  for (std::size_t k = 0; k < contacts.size(); ++k) contacts[k]->settle(histories[k]);
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
