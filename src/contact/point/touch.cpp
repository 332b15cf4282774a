#include "contact/point/touch.hpp"

#include <cmath>

namespace signorini::contact {

double touch_fraction(double before, double now) {
  return before <= 0 ? 0 : before / (before - now);
}

template <int D>
std::optional<MasterPoint<D>> touch_point(const Master<D>& before, const Master<D>& now, const Touching<D>& from,
                                          const Touching<D>& to, const Projection<D>& seed, const Lookout<D>& lookout) {
  FaceGeometry<D> foot;
  const Projection<D> first = before.project(from.position, seed, foot, lookout);
  if (first.foot == Foot::none) return {};
  const double distance = first.gap - from.offset;
  if (distance <= 0) return first.point();
  // The point's place in the accepted state, carried along by the master: its gap and foot are the same.
  FaceGeometry<D> carried;
  now.locate(first, carried);
  Vec<D> start = carried.position + (from.position - foot.position);
  if (first.foot == Foot::regular) start = carried.position + first.gap * now.normal(carried);
  Projection<D> found = first;
  const auto distance_at = [&](double s) {
    found = now.project(start + s * (to.position - start), found, foot, lookout);
    return found.gap - from.offset - s * (to.offset - from.offset);
  };
  double ahead = distance_at(1);
  if (found.foot == Foot::none || ahead >= 0) return {};
  // Regula falsi between an open and a closed place; on a plane its first trial is exact.
  double low = 0, high = 1, behind = distance;
  for (int trial = 0; trial < most_touch_trials; ++trial) {
    const double s = low + (high - low) * touch_fraction(behind, ahead);
    const double here = distance_at(s);
    if (found.foot == Foot::none) return {};
    if (std::abs(here) <= touch_tolerance * distance) break;
    (here > 0 ? low : high) = s;
    (here > 0 ? behind : ahead) = here;
  }
  return found.point();
}

template std::optional<MasterPoint<2>> touch_point(const Master<2>&, const Master<2>&, const Touching<2>&,
                                                   const Touching<2>&, const Projection<2>&, const Lookout<2>&);
template std::optional<MasterPoint<3>> touch_point(const Master<3>&, const Master<3>&, const Touching<3>&,
                                                   const Touching<3>&, const Projection<3>&, const Lookout<3>&);

} // namespace signorini::contact
