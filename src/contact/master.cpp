#include "contact/master.hpp"

#include "contact/slip.hpp"

namespace signorini::contact {

namespace {

/// Calls what(shape) with the closed-form shape; `obstacle` must not be a patch.
template <int D, class What> auto with_shape(const Obstacle<D>& obstacle, const What& what) {
  if (const auto* ball = std::get_if<Ball<D>>(&obstacle)) return what(*ball);
  if constexpr (D == 3)
    if (const auto* cylinder = std::get_if<Cylinder>(&obstacle)) return what(*cylinder);
  return what(std::get<Plane<D>>(obstacle));
}

} // namespace

template <int D> Master<D>::Master(Surface<D> face) : rigid_(false), surface_(std::move(face)) {
  surface_->extend(end_extension);
  boxes_.update(*surface_);
  previous_ = surface_->points();
}

template <int D> Master<D>::Master(Obstacle<D> obstacle) : rigid_(true) {
  if (const auto* patch = std::get_if<nurbs::Patch>(&obstacle)) {
    surface_.emplace(*patch);
    surface_->extend(end_extension);
    boxes_.update(*surface_);
    displacements_.resize(at(D * surface_->functions()));
  } else {
    shape_ = std::move(obstacle);
  }
}

template <int D> double Master<D>::move(const double* displacement) {
  if (!rigid_) {
    surface_->move(displacement);
    boxes_.update(*surface_);
    // A surface point is a convex combination of control points, so their largest displacement is a bound.
    const double distance = std::sqrt((surface_->points() - previous_).colwise().squaredNorm().maxCoeff());
    previous_ = surface_->points();
    return distance;
  }
  const Vec<D> to = Eigen::Map<const Vec<D>>(displacement);
  const double distance = (to - translation_).norm();
  translation_ = to;
  if (surface_ && distance > 0) {
    for (std::size_t i = 0; i < displacements_.size(); ++i) displacements_[i] = displacement[i % D];
    surface_->move(displacements_.data());
    boxes_.update(*surface_);
  }
  return distance;
}

/// Geometry of order 2 of a closed-form shape at point.xi.
template <int D> void Master<D>::place(FacePoint<D>& point) const {
  point.element = 0;
  with_shape<D>(*shape_, [&](const auto& shape) { contact::locate(shape, point); });
  point.position += translation_;
}

template <int D>
Projection<D> Master<D>::project(const Vec<D>& x, const Projection<D>& seed, FacePoint<D>& point) const {
  if (!shape_) return contact::project(*surface_, boxes_, x, seed, point);
  point.xi = with_shape<D>(*shape_, [&](const auto& shape) { return closest(shape, Vec<D>(x - translation_)); });
  place(point);
  return {Foot::regular, 0, 0, point.xi, (x - point.position).dot(normal(point))};
}

template <int D> Vec<D> Master<D>::normal(const FacePoint<D>& point) const {
  return (shape_ ? normal_of<D>(point.tangent) : surface_->outward(point.tangent)).normalized();
}

template <int D> double Master<D>::fade(const FaceCoordinates<D>& xi, FaceCoordinates<D>& rate) const {
  if (surface_) return surface_->fade(xi, rate);
  rate.setZero();
  return 1;
}

template <int D> void Master<D>::functions(FacePoint<D>& point, int order) const {
  if (!rigid_) return surface_->functions(point, order);
  point.value[0] = 1;
  for (auto& derivative : point.derivative) derivative[0] = 0;
}

template <int D> void Master<D>::locate(const FaceCoordinates<D>& xi, FacePoint<D>& point) const {
  if (shape_) {
    point.xi = xi;
    place(point);
  } else {
    surface_->locate(surface_->find_element(xi), xi, 0, point);
  }
  functions(point, 0);
}

template <int D> void Master<D>::locate(const Projection<D>& projection, FacePoint<D>& point) const {
  if (!shape_) return surface_->locate(projection.element, projection.xi, 2, point);
  point.xi = projection.xi;
  place(point);
}

template <int D>
FaceCoordinates<D> Master<D>::advance(const FaceCoordinates<D>& slip, const FacePoint<D>& foot, double length) const {
  if (!shape_) return advance_slip(*surface_, slip, foot, length);
  return with_shape<D>(*shape_, [&](const auto& shape) { return advance_slip(shape, slip, foot, length); });
}

template class Master<2>;
template class Master<3>;

} // namespace signorini::contact
