#include "model/checks/clearance.hpp"

#include "base/error.hpp"
#include "model/checks/constants.hpp"
#include "model/checks/outline.hpp"
#include "model/constants.hpp"
#include "model/scene/element_size.hpp"
#include "model/scene/thickness.hpp"

#include <algorithm>
#include <limits>

namespace signorini::model {

namespace {

double size_of(const MatrixX& points) {
  return (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm();
}

template <int D> bool encloses(const solid::Body<D>& body, const Vec<D>& x) {
  return Outline<D>(body.space(), body.space().points()).winding(x) > 0.5;
}

/// In percent, rounded to one decimal.
double percent(double part) {
  return std::round(1000 * part) / 10;
}

/// The deepest point of a contact.
template <int D> struct Overlap {
  double depth; ///< at most 0 without overlap, −∞ without a point
  Vec<D> position;
  std::size_t point; ///< its number
  double width;      ///< of the part that overlaps: diagonal of the box around its points
};

/// The gaps of all points; of a set only where parts are near, as its evaluation has found them.
template <int D>
std::vector<double> near_gaps(const contact::Formulation<D>& contact, const contact::History<D>& history) {
  if (!contact.master().set()) return contact::gaps(contact, history);
  std::vector<double> gaps;
  for (std::size_t i = 0; i < history.points.size(); ++i) {
    const contact::Projection<D>& found = history.points[i].projection;
    gaps.push_back(found.foot == contact::Foot::none ? std::numeric_limits<double>::infinity()
                                                     : found.gap - contact.parameters().offset(i, history));
  }
  return gaps;
}

/// Among all points that act: the mean gap of a multiplier may be open although some of its points are deep in the
/// master.
template <int D> Overlap<D> overlap_of(const contact::Formulation<D>& contact, const contact::History<D>& history) {
  const double shim = std::max(0.0, contact.parameters().offset(history.changes)); // on purpose
  const std::vector<double> gaps = near_gaps(contact, history), &overlap = contact.parameters().overlap;
  Overlap<D> deepest{-std::numeric_limits<double>::infinity(), Vec<D>::Zero(), 0, 0};
  Vec<D> low = Vec<D>::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    if (!acts(contact.points(), history, i)) continue; // its position is unknown
    const double depth = overlap.empty() ? -gaps[i] - shim : overlap[i];
    const Vec<D>& position = history.results[i].position;
    if (depth > deepest.depth) deepest = {depth, position, i, 0};
    if (depth <= 0) continue;
    low = low.cwiseMin(position);
    high = high.cwiseMax(position);
  }
  if (deepest.depth > 0) deepest.width = (high - low).norm();
  return deepest;
}

/// Mean strain that closes an overlap, in the softer body: two springs of stiffness E/L in series, of which L is the
/// thickness or, where it is less, the width of the part that overlaps, at least an element: below a local overlap
/// strain decays over its width.
template <int D>
double closing_strain(const Scene<D>& scene, const Contact<D>& contact, const Faces* master,
                      const Overlap<D>& deepest) {
  const double width = std::max(deepest.width, element_size(scene, contact.slave, 2));
  double compliance = 0, softest = std::numeric_limits<double>::infinity();
  for (const Faces* faces : {&contact.slave, master}) {
    if (!faces) continue;
    const double modulus = youngs_modulus(scene, *faces);
    compliance += std::min(thickness(scene, *faces), width) / modulus;
    softest = std::min(softest, modulus);
  }
  return deepest.depth / compliance / softest;
}

/// True if a rigid-body motion that no support prevents can part the faces of a contact at a point with a normal: their
/// overlap then moves a body without strain.
template <int D> bool can_part(System<D>& system, const Contact<D>& contact, const Vec<D>& normal) {
  const auto parts = [&](const UnconstrainedMotion& free, const Faces& faces) {
    for (const FaceReference& face : faces)
      if (face.body == free.body)
        for (const int function : system.scene.bodies[face.body].body->space().face_functions(face.side))
          if (std::abs(free.motion.template segment<D>(D * function).dot(normal)) > parting) return true;
    return false;
  };
  const auto* master = std::get_if<Faces>(&contact.master);
  for (const UnconstrainedMotion& free : system.unconstrained())
    if (parts(free, contact.slave) || (master && parts(free, *master))) return true;
  if (master) return false;
  const int obstacle = std::get<ObstacleReference>(contact.master).obstacle;
  return std::ranges::any_of(system.unconstrained_obstacles(),
                             [&](const UnconstrainedObstacle& free) { return free.obstacle == obstacle; });
}

/// Warns of an overlap, with the contact's master in words, if closing it strains a body.
template <int D>
void warn_of_strain(System<D>& system, std::size_t k, const Overlap<D>& deepest, std::vector<Message>& warnings) {
  const Contact<D>& contact = system.scene.contacts[k];
  if (contact.start.interference || deepest.depth <= 0) return;
  const auto* master = std::get_if<Faces>(&contact.master);
  const double strain = closing_strain(system.scene, contact, master, deepest);
  const contact::Formulation<D>& formulation = *system.contacts[k];
  if (strain <= meant_strain ||
      can_part(system, contact, normal_at(formulation.points(), formulation.slave(), deepest.point)))
    return;
  warnings.push_back(Message("model.warning.overlap", {{"contact", contact.name},
                                                       {"slave", faces_message(system.scene, contact.slave)},
                                                       {"master", master ? faces_message(system.scene, *master)
                                                                         : Message("model.clearance.obstacle")},
                                                       {"depth", deepest.depth},
                                                       {"at", deepest.position},
                                                       {"strain", 100 * strain}}));
}

/// Throws Error for two bodies that overlap too deeply.
template <int D>
void check_overlap(const Scene<D>& scene, const Contact<D>& contact, const Faces& master, const Overlap<D>& deepest) {
  const double depth = deepest.depth, behind = thickness(scene, master);
  const double part = depth / thinner_body(scene, contact);
  const double most = contact.start.interference ? whole_depth : mistaken_overlap;
  if (part <= most) return;
  // If the slave lies behind the master's body, the opposite face was probably meant.
  const std::string other = nurbs::name_of({master.front().side.direction, !master.front().side.at_end});
  fail("model.clearance.overlap", {{"contact", contact.name},
                                   {"slave", faces_message(scene, contact.slave)},
                                   {"master", faces_message(scene, master)},
                                   {"depth", depth},
                                   {"at", deepest.position},
                                   {"percent", percent(part)},
                                   {"most", percent(most)},
                                   {"hint", master.size() == 1 && depth > whole_depth * behind
                                                ? Message("model.clearance.wrong_face", {{"face", other}})
                                                : Message("model.clearance.apart")}});
}

/// True if a face may lie this deep inside an obstacle. For thin bodies 1 % of the size exceeds the thickness.
template <int D> bool is_shallow(const Scene<D>& scene, const Contact<D>& contact, double depth) {
  if (depth <= 0) return true;
  const double thick = thickness(scene, contact.slave);
  if (contact.start.interference) return depth <= whole_depth * thick;
  const double size = size_of(scene.bodies[contact.slave.front().body].body->space().points());
  return depth < obstacle_overlap * size && depth < mistaken_overlap * thick;
}

/// The point of a slave face that is closest to a rigid master: its distance, and the cosine between the outward
/// normals of both.
template <int D> struct Nearest {
  double gap = std::numeric_limits<double>::infinity();
  double cosine = -1;
  Vec<D> position = Vec<D>::Zero();
};

template <int D> Nearest<D> nearest_of(const contact::Formulation<D>& contact, const contact::History<D>& history) {
  Nearest<D> nearest;
  contact::FacePoint<D> foot;
  for (std::size_t i = 0; i < contact.points().size(); ++i) {
    if (!acts(contact.points(), history, i)) continue;
    const Vec<D>& x = history.results[i].position;
    const contact::Projection<D> found = contact.master().project(x, history.points[i].projection, foot);
    if (found.foot != contact::Foot::regular || std::abs(found.gap) >= std::abs(nearest.gap)) continue;
    if (contact::FaceCoordinates<D> rate; contact.master().fade(found.xi, rate) < 1) continue; // beyond an open end
    nearest = {found.gap, normal_at(contact.points(), contact.slave(), i).dot(contact.master().normal(foot)), x};
  }
  return nearest;
}

/// What may be wrong with an obstacle that contains a body.
template <int D> Message remedy_for(const contact::Obstacle<D>& obstacle) {
  if (std::holds_alternative<nurbs::Patch>(obstacle)) return Message("model.clearance.reverse_patch");
  if (std::holds_alternative<contact::Plane<D>>(obstacle)) return Message("model.clearance.reverse_plane");
  if (std::holds_alternative<contact::LevelSet<D>>(obstacle)) return Message("model.clearance.change_sign");
  return Message(full_radius<D>(obstacle) == 0 ? "model.clearance.full" : "model.clearance.hollow");
}

} // namespace

template <int D>
std::vector<Message> check_clearance(System<D>& system, const std::vector<contact::History<D>>& histories) {
  const Scene<D>& scene = system.scene;
  std::vector<Message> warnings;
  for (std::size_t k = 0; k < system.contacts.size(); ++k) {
    const Contact<D>& contact = scene.contacts[k];
    if (!contact.start.active) continue;
    const Overlap<D> deepest = overlap_of(*system.contacts[k], histories[k]);
    const NamedBody<D>& named = scene.bodies[contact.slave.front().body];
    if (const auto* face = std::get_if<Faces>(&contact.master)) {
      check_overlap(scene, contact, *face, deepest);
      warn_of_strain(system, k, deepest, warnings);
      continue;
    }
    const contact::Obstacle<D>& obstacle = scene.obstacles[std::get<ObstacleReference>(contact.master).obstacle];
    require(is_shallow(scene, contact, deepest.depth), "model.clearance.inside",
            {{"contact", contact.name},
             {"body", named.name},
             {"depth", deepest.depth},
             {"at", deepest.position},
             {"hint", remedy_for<D>(obstacle)}});
    // A body that touches a plane of wrong orientation has zero gaps, but its middle lies behind the plane.
    if (const auto* plane = std::get_if<contact::Plane<D>>(&obstacle)) {
      const Vec<D> middle = named.body->space().points().rowwise().mean();
      require(plane->normal.dot(middle - plane->point) > 0, "model.clearance.middle",
              {{"contact", contact.name}, {"body", named.name}, {"at", middle}});
    }
    if (const auto* ball = std::get_if<contact::Ball<D>>(&obstacle); ball && !ball->hollow)
      require(!encloses(*named.body, ball->center), "model.clearance.center",
              {{"contact", contact.name}, {"body", named.name}, {"center", ball->center}});
    // Where they are closest, a face and an obstacle that face the same way are a body behind the obstacle or, if they
    // are less apart than the body is thick, an obstacle in the body.
    const Nearest<D> nearest = nearest_of(*system.contacts[k], histories[k]);
    require(nearest.cosine < behind_cosine || nearest.gap > thickness(scene, contact.slave) / 2,
            "model.clearance.behind",
            {{"contact", contact.name},
             {"slave", faces_message(scene, contact.slave)},
             {"at", nearest.position},
             {"distance", std::abs(nearest.gap)},
             {"hint", remedy_for<D>(obstacle)}});
    warn_of_strain(system, k, deepest, warnings);
  }
  return warnings;
}

template std::vector<Message> check_clearance<2>(System<2>&, const std::vector<contact::History<2>>&);
template std::vector<Message> check_clearance<3>(System<3>&, const std::vector<contact::History<3>>&);

} // namespace signorini::model
