#include "contact/point/crossing.hpp"

#include <algorithm>

namespace signorini::contact {

template <int D>
bool has_crossed(const Master<D>& before, const Master<D>& now, const Vec<D>& from, const Vec<D>& to,
                 const Vec<D>& outward, const Projection<D>& seed, double allowed, const Lookout<D>& lookout) {
  FaceGeometry<D> foot, point;
  FacePoint<D> foot_before;
  Projection<D> found = now.project(to, seed, foot, lookout);
  if (found.foot != Foot::regular || found.gap <= 0 || now.normal(foot).dot(outward) <= back_to_back) return false;
  // A point that was pressed in leaves the master on the same side, where its face may have folded over.
  const Projection<D> start = before.project(from, found, point, lookout);
  if (start.foot == Foot::regular && start.gap < allowed && before.normal(point).dot(now.normal(foot)) > 0)
    return false;
  before.locate(found.point(), foot_before);
  const Vec<D> way = (from - foot_before.position) - (to - foot.position);
  const double length = way.norm();
  // The gap changes by at most the distance moved, so steps of the gap's length cannot miss the master.
  for (double s = std::max(found.gap, length / crossing_pieces); s < length;
       s += std::max(found.gap, length / crossing_pieces)) {
    found = now.project(to + (s / length) * way, found, point, lookout);
    if (found.foot == Foot::regular && found.gap < allowed) return true;
  }
  return false;
}

template bool has_crossed<2>(const Master<2>&, const Master<2>&, const Vec<2>&, const Vec<2>&, const Vec<2>&,
                             const Projection<2>&, double, const Lookout<2>&);
template bool has_crossed<3>(const Master<3>&, const Master<3>&, const Vec<3>&, const Vec<3>&, const Vec<3>&,
                             const Projection<3>&, double, const Lookout<3>&);

} // namespace signorini::contact
