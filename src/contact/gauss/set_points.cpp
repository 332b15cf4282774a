#include "contact/gauss/set_points.hpp"

#include "contact/constants.hpp"
#include "contact/point/crossing.hpp"

#include <algorithm>
#include <limits>
#include <optional>

namespace signorini::contact {

namespace {

/// The gap below which a law acts at a point.
template <int D> double touching(const Formulation<D>& contact, std::size_t i, const History<D>& present) {
  return contact.parameters().offset(i, present) + reach(*contact.parameters().law);
}

/// Points that overlap with other bodies from the start are found by these being looked for farther away, by the length
/// of an element.
template <int D> Reach reach_of(const Formulation<D>& contact, int element, double own) {
  return {own, own + contact.master().set()->lengths[contact.slave().sheet(element)]};
}

} // namespace

/// A point that is open in the accepted state cannot be deeper in a part than by its motion relative to it since then.
template <int D> Lookout<D> lookout(const Formulation<D>& contact, std::size_t i, const Trial<D>& trial) {
  Lookout<D> from = lookout(contact.faces(), contact.points(), i);
  if (!from.set) return from;
  if (!contact.parameters().active(trial.accepted.changes)) {
    from.sight.reach = {};
    return from;
  }
  // One that its state holds closed keeps its foot at any distance.
  if (trial.controls.fixed(static_cast<int>(i)) != FixedContactState::free) return from;
  const Projection<D>& before = trial.accepted.points[i].projection;
  const double depth = before.foot == Foot::none ? 0 : std::max(-before.gap, 0.0);
  from.sight.moved = trial.present.results[i].position - trial.accepted.results[i].position;
  from.sight.reach = reach_of(contact, contact.points().list[i].element,
                              depth + std::max(touching(contact, i, trial.present), 0.0) + trial.controls.guessed);
  from.farthest = from.sight.reach.others + contact.master().boxes().relative_motion(from.sight.moved);
  return from;
}

namespace {

/// The largest gap at which a point of an element touches, at least zero; none if a point has a foot.
template <int D>
std::optional<double> largest_touching(const Formulation<D>& contact, int element, const History<D>& present,
                                       const History<D>& accepted) {
  const ContactPoints<D>& points = contact.points();
  if (!contact.parameters().active(accepted.changes)) return std::nullopt;
  const std::size_t first = points.starts[element], last = points.starts[element + 1];
  const bool watched = is_watched(present, first) || is_watched(accepted, first);
  // Points without a past have no foot, and touch at one gap.
  double own = watched ? 0 : std::max(touching(contact, first, present), 0.0);
  for (std::size_t i = first; i < last && watched; ++i) {
    if (!acts(points, present, i)) continue;
    if (present.points[i].projection.foot != Foot::none || accepted.points[i].projection.foot != Foot::none)
      return std::nullopt;
    own = std::max(own, touching(contact, i, present));
  }
  return own;
}

template <int D> bool is_alone(const Formulation<D>& contact, int element, const Reach& reach) {
  const Master<D>& master = contact.master();
  const Surroundings& around = master.set()->surroundings;
  return master.boxes().is_alone(*master.surface(), around.numbers[element], reach, around[element]);
}

} // namespace

template <int D>
bool is_alone(const Formulation<D>& contact, int element, const History<D>& present, const History<D>& accepted,
              double guessed) {
  const auto own = largest_touching(contact, element, present, accepted);
  return own && is_alone(contact, element, reach_of(contact, element, *own + guessed));
}

template <int D> bool is_far(const Formulation<D>& contact, int element, const History<D>& accepted, double distance) {
  const auto own = largest_touching(contact, element, accepted, accepted);
  if (!own) return false;
  Reach reach = reach_of(contact, element, *own + distance);
  reach.own = std::min(reach.own, near_elements * contact.master().set()->lengths[contact.slave().sheet(element)]);
  return is_alone(contact, element, reach);
}

template <int D> bool has_no_past(const Formulation<D>& contact, int element, const History<D>& present) {
  const ContactPoints<D>& points = contact.points();
  const std::size_t first = points.starts[element], last = points.starts[element + 1];
  if (!is_watched(present, first)) return true;
  return contact.parameters().overlap.empty() &&
         std::all_of(present.points.begin() + first, present.points.begin() + last,
                     [](const PointHistory<D>& point) { return !point.slips && point.worn == 0; });
}

template <int D>
bool has_passed_through(const Formulation<D>& contact, std::size_t i, const History<D>& present,
                        const History<D>& accepted, double moved) {
  const Faces<D>& faces = contact.faces();
  const Vec<D>&before = accepted.results[i].position, &now = present.results[i].position;
  const double offset = contact.parameters().offset(i, present), farther = std::max(offset, 0.0);
  Lookout<D> from = lookout(faces, contact.points(), i);
  Sight<D> near = from.sight;
  near.reach = {farther, farther};
  near.moved = now - before;
  if (!faces.master.boxes().sees_any(now, near)) return false;
  from.farthest = from.sight.reach.own = farther + (now - before).norm() + moved;
  return has_passed_through(faces.accepted, faces.master, before, now, accepted.points[i].projection,
                            present.points[i].projection, touches(present.results[i].state), std::min(0.0, offset),
                            from);
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template Lookout<D> lookout(const Formulation<D>&, std::size_t, const Trial<D>&);                                    \
  template bool is_alone(const Formulation<D>&, int, const History<D>&, const History<D>&, double);                    \
  template bool is_far(const Formulation<D>&, int, const History<D>&, double);                                         \
  template bool has_no_past(const Formulation<D>&, int, const History<D>&);                                            \
  template bool has_passed_through(const Formulation<D>&, std::size_t, const History<D>&, const History<D>&, double);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::contact
