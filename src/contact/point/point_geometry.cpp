#include "contact/point/point_geometry.hpp"

namespace signorini::contact {

template <int D>
LocalGeometry<D> point_geometry(const ContactPoints<D>& points, std::size_t i, const Surface<D>& slave,
                                const Master<D>& master, const Vec<D>& position, const Projection<D>& projection,
                                const FacePoint<D>& foot) {
  LocalGeometry<D> geometry;
  geometry.slave = position;
  geometry.slave_tangent = tangents(points, slave, i);
  geometry.master = &foot;
  geometry.foot = projection.foot;
  geometry.along = projection.along;
  geometry.gap = projection.gap;
  geometry.normal =
      projection.foot == Foot::regular ? master.normal(foot) : Vec<D>((position - foot.position) / projection.gap);
  geometry.slip_point = nullptr;
  geometry.revolved = points.revolved;
  geometry.reference_measure = points.list[i].reference_area;
  geometry.fade = master.fade(projection.xi, geometry.fade_rate);
  return geometry;
}

template <int D> std::vector<std::array<std::size_t, 2>> pieces(const ContactPoints<D>& points) {
  constexpr std::size_t count = contact_pieces<D>;
  const auto& list = points.list;
  std::vector<std::array<std::size_t, 2>> result;
  for (std::size_t i = 1, first = 0; i <= list.size(); ++i)
    if (i == list.size() || (list[i].element != list[i - 1].element && (i - first) * count >= list.size())) {
      result.push_back({first, i});
      first = i;
    }
  return result;
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template LocalGeometry<D> point_geometry(const ContactPoints<D>&, std::size_t, const Surface<D>&, const Master<D>&,  \
                                           const Vec<D>&, const Projection<D>&, const FacePoint<D>&);                  \
  template std::vector<std::array<std::size_t, 2>> pieces(const ContactPoints<D>&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::contact
