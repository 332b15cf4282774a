#include "contact/point/unfold.hpp"

#include "contact/constants.hpp"

#include <cmath>

namespace signorini::contact {

namespace {

template <int D> Vec<D> unit_normal(const Surface<D>& surface, int element, const FaceCoordinates<D>& xi) {
  FaceGeometry<D> point;
  surface.locate(element, xi, 1, point);
  return outward(surface, point).normalized();
}

/// True if the normal jumps at a border.
template <int D>
bool is_kink(const Surface<D>& surface, int element, const FaceCoordinates<D>& xi, const Entry<D>& beyond) {
  if (smoothly_adjacent(surface, element, beyond.element)) return false;
  return (unit_normal(surface, element, xi) - unit_normal(surface, beyond.element, beyond.xi)).norm() >= same_place;
}

template <int D> Vec<D> place(const Surface<D>& surface, int element, const FaceCoordinates<D>& xi) {
  FaceGeometry<D> point;
  surface.locate(element, xi, 0, point);
  return point.position;
}

} // namespace

template <int D>
std::vector<Kink<D>> kinks_between(const Surface<D>& surface, const FaceGeometry<D>& foot,
                                   const FaceCoordinates<D>& slip) {
  if (D == 3) return {};
  const int target = surface.find_element(slip);
  if (target == foot.element) return {};
  struct Way {
    int element;
    bool at_end; ///< of the element, where it leads
    std::vector<Kink<D>> kinks = {};
  };
  Way ways[] = {{foot.element, false}, {foot.element, true}};
  for (int moves = 0; moves < surface.elements(); ++moves)
    for (Way& way : ways) {
      if (way.element < 0) continue;
      FaceCoordinates<D> xi = FaceCoordinates<D>::Zero();
      xi(0) = surface.interval(way.element, 0)[way.at_end];
      const Entry<D> beyond = across(surface, way.element, 0, way.at_end, xi);
      if (beyond.element >= 0 && is_kink(surface, way.element, xi, beyond))
        way.kinks.push_back({{way.element, 0, way.at_end, xi}, beyond});
      way = {beyond.element, !beyond.at_end, std::move(way.kinks)};
      if (way.element == target) return std::move(way.kinks);
    }
  return {};
}

namespace {

/// Chords from a place to a slip point across kinks, from the one with number `first` on.
template <int D>
double chords(const Surface<D>& surface, const std::vector<Kink<D>>& kinks, std::size_t first, Vec<D> from,
              const FaceCoordinates<D>& slip) {
  double length = 0;
  for (std::size_t k = first; k < kinks.size(); ++k) {
    const Vec<D> kink = place(surface, kinks[k].near.element, kinks[k].near.xi);
    length += (kink - from).norm();
    from = kink;
  }
  return length + (place(surface, surface.find_element(slip), slip) - from).norm();
}

} // namespace

template <int D>
void locate_slip(const Faces<D>& faces, const MasterPoint<D>& slip, const FaceGeometry<D>& foot, FacePoint<D>& point) {
  const Surface<D>* accepted = faces.accepted.surface();
  const std::vector<Kink<D>> kinks = accepted ? kinks_between(*accepted, foot, slip.xi) : std::vector<Kink<D>>{};
  if (kinks.empty()) return faces.master.locate(slip, point);
  const Entry<D>& border = kinks.front().near;
  const double length = chords(*accepted, kinks, 1, place(*accepted, border.element, border.xi), slip.xi);
  FaceGeometry<D> before;
  accepted->locate(border.element, border.xi, 1, before);
  const double way = (border.at_end ? length : -length) / before.tangent[0].norm();
  faces.master.surface()->locate(border.element, border.xi, 1, point);
  faces.master.functions(point, 1);
  point.position += way * point.tangent[0];
  for (int a = 0; a < faces.master.functions_on(border.element); ++a) point.value[a] += way * point.derivative[0][a];
}

template <int D> double way_to_corner(const Master<D>& master, const FaceGeometry<D>& foot, const Vec<D>& slip_point) {
  if (D == 3 || slip_point == foot.position) return 0;
  const double along = (foot.position - slip_point).dot(foot.tangent[0]);
  const Surface<D>& surface = *master.surface();
  return std::copysign(1, along) * surface.sheet_data(surface.sheet(foot.element)).orientation;
}

template <int D> double way_length(const Master<D>& master, const FaceGeometry<D>& foot, const MasterPoint<D>& slip) {
  const Surface<D>* surface = master.surface();
  if (surface) return chords(*surface, kinks_between(*surface, foot, slip.xi), 0, foot.position, slip.xi);
  FacePoint<D> point;
  master.locate(slip, point);
  return (point.position - foot.position).norm();
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template std::vector<Kink<D>> kinks_between(const Surface<D>&, const FaceGeometry<D>&, const FaceCoordinates<D>&);   \
  template void locate_slip(const Faces<D>&, const MasterPoint<D>&, const FaceGeometry<D>&, FacePoint<D>&);            \
  template double way_to_corner(const Master<D>&, const FaceGeometry<D>&, const Vec<D>&);                              \
  template double way_length(const Master<D>&, const FaceGeometry<D>&, const MasterPoint<D>&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::contact
