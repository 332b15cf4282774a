#include "contact/point/crossing.hpp"

#include <algorithm>

namespace signorini::contact {

template <int D>
bool has_crossed(const Master<D>& before, const Master<D>& now, const Vec<D>& from, const Vec<D>& to,
                 const Vec<D>& outward, const Projection<D>& seed, double allowed) {
  FaceGeometry<D> foot, point;
  FacePoint<D> foot_before;
  Projection<D> found = now.project(to, seed, foot);
  if (found.foot != Foot::regular || found.gap <= 0 || now.normal(foot).dot(outward) <= back_to_back) return false;
  // A point that was pressed in leaves the master on the same side, where its face may have folded over.
  const Projection<D> start = before.project(from, found, point);
  if (start.foot == Foot::regular && start.gap < allowed && before.normal(point).dot(now.normal(foot)) > 0)
    return false;
  before.locate(found.point(), foot_before);
  const Vec<D> way = (from - foot_before.position) - (to - foot.position);
  const double length = way.norm();
  // The gap changes by at most the distance moved, so steps of the gap's length cannot miss the master.
  for (double s = std::max(found.gap, length / crossing_pieces); s < length;
       s += std::max(found.gap, length / crossing_pieces)) {
    found = now.project(to + (s / length) * way, found, point);
    if (found.foot == Foot::regular && found.gap < allowed) return true;
  }
  return false;
}

template <int D>
bool has_passed_through(const Master<D>& before, const Master<D>& now, const Vec<D>& from, const Vec<D>& to,
                        const Projection<D>& seed, const Projection<D>& last, bool touching, double allowed,
                        const Lookout<D>& lookout) {
  FaceGeometry<D> front, carried, point;
  const Projection<D> first = before.project(from, seed, front, lookout);
  if (first.foot != Foot::regular) return false;
  now.locate(first, carried);
  const Vec<D> normal = now.normal(carried);
  const auto depth_of = [&](const FaceGeometry<D>& foot) {
    return crossing_depth * lookout.set->thickness[lookout.set->reference.sheet(foot.element)];
  };
  if ((to - carried.position).dot(normal) >= allowed - depth_of(carried)) return false;
  if (last.foot == Foot::regular) {
    now.locate(last, point);
    const double facing = now.normal(point).dot(normal);
    if (touching || last.gap > 0) return facing < -back_to_back;
  }
  if (touching) return false;
  const Vec<D> way = (from - front.position) - (to - carried.position);
  Projection<D> found = first;
  for (int k = 1; k < crossing_pieces; ++k) {
    found = now.project(to + (static_cast<double>(k) / crossing_pieces) * way, found, point, lookout);
    if (found.foot == Foot::regular && found.gap < allowed - depth_of(point)) return true;
  }
  return false;
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template bool has_crossed(const Master<D>&, const Master<D>&, const Vec<D>&, const Vec<D>&, const Vec<D>&,           \
                            const Projection<D>&, double);                                                             \
  template bool has_passed_through(const Master<D>&, const Master<D>&, const Vec<D>&, const Vec<D>&,                   \
                                   const Projection<D>&, const Projection<D>&, bool, double, const Lookout<D>&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::contact
