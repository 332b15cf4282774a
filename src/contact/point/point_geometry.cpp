#include "contact/point/point_geometry.hpp"

namespace signorini::contact {

template <int D>
bool find_foot(const Master<D>& master, PointHistory<D>& point, PointResult<D>& result, FacePoint<D>& foot,
               const Lookout<D>& from) {
  foot.settled = true;
  result.beyond = !from.set && master.is_beyond_ends(result.position);
  if (result.beyond)
    point.projection.foot = Foot::none; // the start of a later search stays
  else
    point.projection = master.project(result.position, point.projection, foot, from);
  const bool found = point.projection.foot != Foot::none;
  if (!found && point.projection.element >= 0) result.beyond = true; // otherwise nothing is near
  result.settled = foot.settled;
  return found;
}

template <int D>
Vec<D> contact_normal(const Master<D>& master, const Projection<D>& projection, const FaceGeometry<D>& foot,
                      const Vec<D>& position) {
  return projection.foot == Foot::regular ? master.normal(foot) : Vec<D>((position - foot.position) / projection.gap);
}

template <int D>
LocalGeometry<D> point_geometry(const ContactPoints<D>& points, std::size_t i, const Faces<D>& faces,
                                const Vec<D>& position, const Projection<D>& projection, const FacePoint<D>& foot) {
  LocalGeometry<D> geometry;
  geometry.slave = position;
  geometry.slave_tangent = tangents(points, faces.slave, i);
  geometry.master = &foot;
  geometry.foot = projection.foot;
  geometry.along = projection.along;
  geometry.gap = projection.gap;
  geometry.normal = contact_normal(faces.master, projection, foot, position);
  geometry.slip_point = nullptr;
  geometry.axis = points.axis(i);
  geometry.revolved = points.revolved;
  geometry.reference_measure = points.list[i].reference_area;
  geometry.fade = faces.master.fade(projection.xi, geometry.fade_rate);
  return geometry;
}

template <int D>
double slave_measure(const ContactPoints<D>& points, const Surface<D>& slave, std::size_t i, const Vec<D>& position) {
  LocalGeometry<D> geometry;
  geometry.slave = position;
  geometry.slave_tangent = tangents(points, slave, i);
  geometry.revolved = points.revolved;
  LocalRow<D> derivative;
  return slave_measure(geometry, derivative);
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
  template bool find_foot(const Master<D>&, PointHistory<D>&, PointResult<D>&, FacePoint<D>&, const Lookout<D>&);      \
  template Vec<D> contact_normal(const Master<D>&, const Projection<D>&, const FaceGeometry<D>&, const Vec<D>&);       \
  template LocalGeometry<D> point_geometry(const ContactPoints<D>&, std::size_t, const Faces<D>&, const Vec<D>&,       \
                                           const Projection<D>&, const FacePoint<D>&);                                 \
  template double slave_measure(const ContactPoints<D>&, const Surface<D>&, std::size_t, const Vec<D>&);               \
  template std::vector<std::array<std::size_t, 2>> pieces(const ContactPoints<D>&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::contact
