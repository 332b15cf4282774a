#include "contact/point/master.hpp"

#include "contact/constants.hpp"
#include "contact/point/slip.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace signorini::contact {

namespace {

/// Calls what(shape) with the closed-form shape; `obstacle` must not be a patch.
template <int D, class What> auto with_shape(const Obstacle<D>& obstacle, const What& what) {
  if (const auto* ball = std::get_if<Ball<D>>(&obstacle)) return what(*ball);
  if (const auto* level_set = std::get_if<LevelSet<D>>(&obstacle)) return what(*level_set);
  if constexpr (D == 3) {
    if (const auto* cylinder = std::get_if<Cylinder>(&obstacle)) return what(*cylinder);
    if (const auto* torus = std::get_if<Torus>(&obstacle)) return what(*torus);
  }
  return what(std::get<Plane<D>>(obstacle));
}

} // namespace

template <int D> Master<D>::Master(Surface<D> face, double opposite) : rigid_(false), surface_(std::move(face)) {
  surface_->extend(end_extension, end_extension * opposite);
  boxes_.update(*surface_);
}

template <int D>
Master<D>::Master(Surface<D> face, double opposite, SetParts parts)
    : rigid_(false), surface_(face), boxes_(parts.bodies) {
  surface_->extend(end_extension, end_extension * opposite);
  boxes_.update(*surface_);
  std::vector<double> lengths(parts.bodies.size(), 0.0);
  for (int e = 0; e < surface_->elements(); ++e)
    lengths[surface_->sheet(e)] = std::max(lengths[surface_->sheet(e)], std::sqrt(boxes_.diagonal2(e)));
  set_ = std::make_shared<const FaceSet<D>>(
      FaceSet<D>{std::move(parts), *surface_, std::move(lengths), find_surroundings(face, *surface_)});
}

template <int D>
Master<D>::Master(Obstacle<D> obstacle, std::optional<Turning<D>> turning, double opposite)
    : rigid_(true), motion_(std::move(turning)) {
  if (const auto* patch = std::get_if<nurbs::Patch>(&obstacle)) {
    surface_.emplace(*patch);
    surface_->extend(end_extension, end_extension * opposite);
    boxes_.update(*surface_);
  } else {
    shape_ = std::move(obstacle);
  }
}

template <int D> double Master<D>::move(const double* displacement, const PointColumns<D>& opposite) {
  double distance = 0;
  if (!rigid_)
    distance = surface_->move(displacement);
  else if (distance = motion_.move(displacement, opposite); surface_ && distance > 0)
    surface_->move(motion_.displacements(surface_->reference()).data());
  if (surface_ && (!rigid_ || distance > 0)) boxes_.update(*surface_);
  return distance;
}

template <int D> double Master<D>::moved_since(const Master& before, const PointColumns<D>& opposite) const {
  return rigid_ ? motion_.moved_since(before.motion_, opposite) : distance_moved(*before.surface_, *surface_);
}

/// Geometry of order 2 of a closed-form shape at point.xi.
template <int D> void Master<D>::place(FaceGeometry<D>& point) const {
  point.element = 0;
  with_shape<D>(*shape_, [&](const auto& shape) { contact::locate(shape, point); });
  motion_.place(point);
}

template <int D>
Projection<D> Master<D>::project(const Vec<D>& x, const Projection<D>& seed, FaceGeometry<D>& point,
                                 const Lookout<D>& from) const {
  if (!shape_) {
    Projection<D> found = contact::project(*surface_, boxes_, x, seed, point, from);
    // A closest part that a point does not touch shields the parts behind it.
    if (from.set && found.element >= 0 && !set_->touch(from.sheet, surface_->sheet(found.element)))
      found.foot = Foot::none;
    return found;
  }
  with_shape<D>(*shape_, [&](const auto& shape) { find_closest(shape, motion_.pulled_back(x), point); });
  place(point);
  return {Foot::regular, 0, 0, point.xi, (x - point.position).dot(normal(point)), point.last};
}

template <int D> Vec<D> Master<D>::normal(const FaceGeometry<D>& point) const {
  return (shape_ ? normal_of<D>(point.tangent) : outward(*surface_, point)).normalized();
}

template <int D> double Master<D>::fade(const FaceCoordinates<D>& xi, FaceCoordinates<D>& rate) const {
  if (surface_) return surface_->sheet_data(surface_->sheet_at(xi)).extension.fade(xi, rate);
  rate.setZero();
  return 1;
}

template <int D> void Master<D>::functions(FacePoint<D>& point, int order) const {
  if (rigid_) return motion_.functions(point, order);
  surface_->functions(point, order);
}

template <int D> void Master<D>::locate(const MasterPoint<D>& at, FacePoint<D>& point) const {
  if (shape_) {
    point.xi = at.xi;
    point.last = at.last;
    place(point);
  } else {
    surface_->locate(surface_->find_element(at.xi), at.xi, 0, point);
  }
  functions(point, 0);
}

template <int D> void Master<D>::locate(const Projection<D>& projection, FaceGeometry<D>& point) const {
  if (!shape_) return surface_->locate(projection.element, projection.xi, 2, point);
  point.xi = projection.xi;
  point.last = projection.last;
  place(point);
}

template <int D>
MasterPoint<D> Master<D>::advance(const MasterPoint<D>& slip, const FaceGeometry<D>& foot, double length) const {
  if (!shape_) return advance_slip(*surface_, slip.xi, foot, length);
  return with_shape<D>(*shape_, [&]<class Shape>(const Shape& shape) -> MasterPoint<D> {
    if constexpr (std::is_same_v<Shape, LevelSet<D>>)
      return advance_slip(shape, slip, foot, length);
    else
      return advance_slip(shape, slip.xi, foot, length);
  });
}

template <int D>
MasterPoint<D> Master<D>::along_normal(const Vec<D>& goal, const Vec<D>& normal, Projection<D> closest,
                                       const Lookout<D>& from) const {
  FaceGeometry<D> found;
  Vec<D> near = goal;
  for (int k = 0; k < slip_corrections; ++k) {
    closest = project(near, closest, found, from);
    const Vec<D> error = goal - found.position;
    near += error - normal.dot(error) * normal;
  }
  return closest.point();
}

template class Master<2>;
template class Master<3>;

} // namespace signorini::contact
