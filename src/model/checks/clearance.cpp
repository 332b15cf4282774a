#include "model/checks/clearance.hpp"

#include "base/error.hpp"
#include "base/index.hpp"
#include "model/checks/outline.hpp"
#include "model/constants.hpp"
#include "model/thickness.hpp"

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
};

/// Of all points that act: the mean gap of a multiplier may be open although some of its points are deep in the master.
template <int D> Overlap<D> overlap_of(const contact::Formulation<D>& contact, const contact::History<D>& history) {
  const double shim = std::max(0.0, contact.offset(history)); // on purpose
  const std::vector<double> gaps = contact.gaps(history);
  Overlap<D> deepest{-std::numeric_limits<double>::infinity(), Vec<D>::Zero()};
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    if (!acts(contact.points(), history, i)) continue; // its position is unknown
    const double depth = contact.overlap().empty() ? -gaps[i] - shim : contact.overlap()[i];
    if (depth > deepest.depth) deepest = {depth, history.results[i].position};
  }
  return deepest;
}

/// Checks two bodies that overlap; returns a warning, or nothing.
template <int D>
Message check_overlap(const Scene<D>& scene, const Contact<D>& contact, const Faces& master,
                      const Overlap<D>& deepest) {
  const double depth = deepest.depth, behind = thickness(scene, master);
  const double part = depth / std::min(thickness(scene, contact.slave), behind);
  if (part <= meant_overlap) return {};
  const Message slave_face = faces_message(scene, contact.slave), master_face = faces_message(scene, master);
  // If the slave lies behind the master's body, the opposite face was probably meant.
  const std::string other = nurbs::name_of({master.front().side.direction, !master.front().side.at_end});
  const double most = contact.start.interference ? whole_depth : mistaken_overlap;
  require(part <= most, "model.clearance.overlap",
          {{"contact", contact.name},
           {"slave", slave_face},
           {"master", master_face},
           {"depth", depth},
           {"at", deepest.position},
           {"percent", percent(part)},
           {"most", percent(most)},
           {"hint", master.size() == 1 && depth > whole_depth * behind
                        ? Message("model.clearance.wrong_face", {{"face", other}})
                        : Message("model.clearance.apart")}});
  if (contact.start.interference) return {};
  return Message("model.warning.overlap", {{"contact", contact.name},
                                           {"slave", slave_face},
                                           {"master", master_face},
                                           {"depth", depth},
                                           {"at", deepest.position},
                                           {"percent", percent(part)}});
}

/// Whether a face may lie this deep inside an obstacle. For thin bodies 1 % of the size exceeds the thickness.
template <int D> bool is_shallow(const Scene<D>& scene, const Contact<D>& contact, double depth) {
  if (depth <= 0) return true;
  const double thick = thickness(scene, contact.slave);
  if (contact.start.interference) return depth <= whole_depth * thick;
  const double size = size_of(scene.bodies[at(contact.slave.front().body)].body->space().points());
  return depth < obstacle_overlap * size && depth < mistaken_overlap * thick;
}

/// What may be wrong with an obstacle that contains a body.
template <int D> Message cure(const contact::Obstacle<D>& obstacle) {
  if (std::holds_alternative<nurbs::Patch>(obstacle)) return Message("model.clearance.reverse_patch");
  if (std::holds_alternative<contact::Plane<D>>(obstacle)) return Message("model.clearance.reverse_plane");
  if (std::holds_alternative<contact::LevelSet<D>>(obstacle)) return Message("model.clearance.change_sign");
  const bool hollow = std::visit(
      [](const auto& shape) {
        if constexpr (requires { shape.hollow; }) return shape.hollow;
        return false;
      },
      obstacle);
  return Message(hollow ? "model.clearance.full" : "model.clearance.hollow");
}

} // namespace

template <int D>
std::vector<Message> check_clearance(const Scene<D>& scene, const contact::Formulations<D>& contacts,
                                     const std::vector<contact::History<D>>& histories) {
  std::vector<Message> warnings;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const Contact<D>& contact = scene.contacts[k];
    if (!contact.start.active) continue;
    const Overlap<D> deepest = overlap_of(*contacts[k], histories[k]);
    const NamedBody<D>& named = scene.bodies[at(contact.slave.front().body)];
    if (const auto* face = std::get_if<Faces>(&contact.master)) {
      if (deepest.depth > 0)
        if (const Message warning = check_overlap(scene, contact, *face, deepest); !warning.code.empty())
          warnings.push_back(warning);
      continue;
    }
    const contact::Obstacle<D>& obstacle = scene.obstacles[at(std::get<ObstacleReference>(contact.master).obstacle)];
    require(is_shallow(scene, contact, deepest.depth), "model.clearance.inside",
            {{"contact", contact.name},
             {"body", named.name},
             {"depth", deepest.depth},
             {"at", deepest.position},
             {"hint", cure<D>(obstacle)}});
    // A body that touches a plane of wrong orientation has zero gaps, but its middle lies behind the plane.
    if (const auto* plane = std::get_if<contact::Plane<D>>(&obstacle)) {
      const Vec<D> middle = named.body->space().points().rowwise().mean();
      require(plane->normal.dot(middle - plane->point) > 0, "model.clearance.middle",
              {{"contact", contact.name}, {"body", named.name}, {"at", middle}});
    }
    if (const auto* ball = std::get_if<contact::Ball<D>>(&obstacle); ball && !ball->hollow)
      require(!encloses(*named.body, ball->center), "model.clearance.center",
              {{"contact", contact.name}, {"body", named.name}, {"center", ball->center}});
  }
  return warnings;
}

template std::vector<Message> check_clearance<2>(const Scene<2>&, const contact::Formulations<2>&,
                                                 const std::vector<contact::History<2>>&);
template std::vector<Message> check_clearance<3>(const Scene<3>&, const contact::Formulations<3>&,
                                                 const std::vector<contact::History<3>>&);

} // namespace signorini::model
