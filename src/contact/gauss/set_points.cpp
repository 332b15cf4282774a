#include "contact/gauss/set_points.hpp"

#include <algorithm>
#include <limits>

namespace signorini::contact {

namespace {

/// The gap below which a law acts at a point.
template <int D> double touching(const Formulation<D>& contact, std::size_t i, const Trial<D>& trial) {
  return contact.parameters().offset(i, trial.present) + reach(*contact.parameters().law);
}

/// A point that is open in the accepted state cannot be deeper than by its motion and that of the set since then: parts
/// of its own body that are farther away do not matter.
template <int D> double farthest(const Formulation<D>& contact, std::size_t i, const Trial<D>& trial) {
  if (!contact.parameters().active(trial.accepted.changes)) return std::numeric_limits<double>::infinity();
  const Projection<D>& before = trial.accepted.points[i].projection;
  const double depth = before.foot == Foot::none ? 0 : std::max(-before.gap, 0.0);
  const double moved = (trial.present.results[i].position - trial.accepted.results[i].position).norm();
  return moved + contact.faces().moved + depth + std::max(touching(contact, i, trial), 0.0);
}

/// By how much more other bodies are looked for, the length of an element, which keeps points clear for a while.
template <int D> double margin(const Formulation<D>& contact, std::size_t i) {
  return contact.master().set()->lengths[contact.slave().sheet(contact.points().list[i].element)];
}

} // namespace

template <int D> Lookout<D> lookout(const Formulation<D>& contact, std::size_t i, const Trial<D>& trial) {
  Lookout<D> from = lookout(contact.faces(), contact.points(), i);
  if (!from.set) return from;
  from.sight.reach = farthest(contact, i, trial);
  from.farthest = from.sight.reach + margin(contact, i);
  return from;
}

template <int D> double cleared_in_set(const Formulation<D>& contact, std::size_t i, const Trial<D>& trial) {
  const Projection<D>& projection = trial.present.points[i].projection;
  const PointResult<D>& result = trial.present.results[i];
  const bool found = projection.foot != Foot::none;
  if (result.beyond || (found && !result.settled)) return 0;
  const double touches = touching(contact, i, trial);
  if (found && !(projection.gap > touches)) return 0;
  const Lookout<D> from = lookout(contact, i, trial);
  const double nearest = found ? projection.gap : from.farthest;
  // Parts of its own body that the point may see later count as well.
  const double in_sight = contact.master().distance_in_sight(result.position, from.sight, nearest) - touches;
  return in_sight > 0 ? contact.faces().travel + in_sight : 0;
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template Lookout<D> lookout(const Formulation<D>&, std::size_t, const Trial<D>&);                                    \
  template double cleared_in_set(const Formulation<D>&, std::size_t, const Trial<D>&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::contact
