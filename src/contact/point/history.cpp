#include "contact/point/history.hpp"

#include <algorithm>

namespace signorini::contact {

template <int D>
History<D>::History(const ContactPoints<D>& of, int count, bool bonded)
    : points(of.size()), results(of.size()), multipliers(count), multiplier_results(count),
      bonds(bonded ? of.size() : 0) {
  for (std::size_t i = 0; i < of.size(); ++i) results[i].position = of.reference[i];
  watch_all(*this);
  if (of.sparse > 0) sparse.resize(of.list.back().element + 1, 0);
}

template <int D> Resultant<D> resultant(const History<D>& history) {
  Resultant<D> sum;
  for (const std::size_t i : watched_points(history)) {
    const PointResult<D>& point = history.results[i];
    sum.max_wear = std::max(sum.max_wear, history.points[i].worn);
    sum.force += point.force;
    if (point.state == ContactState::open) continue;
    sum.max_pressure = std::max(sum.max_pressure, point.pressure);
    sum.max_penetration = std::max(sum.max_penetration, -point.gap);
    ++sum.active;
    if (point.state == ContactState::slip) ++sum.slipping;
  }
  return sum;
}

template <int D> int constraints(const History<D>& history) {
  return static_cast<int>(history.multipliers.empty() ? history.results.size() : history.multipliers.size());
}

template <int D> Constraint constraint(const History<D>& history, int index) {
  const auto of = [](const auto& result) { return Constraint{result.state, result.beyond, result.gap}; };
  return history.multipliers.empty() ? of(history.results[index]) : of(history.multiplier_results[index]);
}

template <int D> double memory(const History<D>& history) {
  return static_cast<double>(
      history.points.capacity() * sizeof(PointHistory<D>) + history.results.capacity() * sizeof(PointResult<D>) +
      history.bonds.capacity() * sizeof(PointBond<D>) + history.multipliers.capacity() * sizeof(MultiplierHistory<D>) +
      history.multiplier_results.capacity() * sizeof(MultiplierResult<D>));
}

template <int D> void look_everywhere(History<D>& history) {
  for (PointHistory<D>& point : history.points) point.cleared = 0;
  for (MultiplierHistory<D>& multiplier : history.multipliers) multiplier.cleared = 0;
}

template <int D> void forget_touches(History<D>& present, const History<D>& accepted) {
  for (std::size_t i = 0; i < present.points.size(); ++i) present.points[i].slips = accepted.points[i].slips;
  for (MultiplierHistory<D>& multiplier : present.multipliers) multiplier.touch.setZero();
}

template <int D> void change(History<D>& history, const Changes& changes) {
  history.changes = changes;
  look_everywhere(history);
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template struct History<D>;                                                                                          \
  template Resultant<D> resultant(const History<D>&);                                                                  \
  template int constraints(const History<D>&);                                                                         \
  template Constraint constraint(const History<D>&, int);                                                              \
  template double memory(const History<D>&);                                                                           \
  template void look_everywhere(History<D>&);                                                                          \
  template void forget_touches(History<D>&, const History<D>&);                                                        \
  template void change(History<D>&, const Changes&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::contact
