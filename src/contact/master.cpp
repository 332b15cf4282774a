#include "contact/master.hpp"

#include "contact/slip.hpp"

namespace signorini::contact {

template <int D> Master<D>::Master(Surface<D> face) : rigid_(false), surface_(std::move(face)) {
  boxes_.update(*surface_);
  previous_ = surface_->points();
}

template <int D> Master<D>::Master(Obstacle<D> obstacle) : rigid_(true) {
  if (const auto* patch = std::get_if<nurbs::Patch>(&obstacle)) {
    surface_.emplace(*patch);
    boxes_.update(*surface_);
    displacements_.resize(static_cast<std::size_t>(D * surface_->functions()));
  } else {
    shape_ = std::move(obstacle);
  }
}

template <int D> double Master<D>::move(const double* displacement) {
  if (!rigid_) {
    surface_->move(displacement);
    boxes_.update(*surface_);
    // A surface point is a convex combination of control points: none moves farther than the farthest of those.
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

/// Geometry of order 2 of a shape in closed form at point.xi.
template <int D> void Master<D>::place(FacePoint<D>& point) const {
  point.element = 0;
  if (const auto* plane = std::get_if<Plane<D>>(&*shape_))
    contact::locate(*plane, point);
  else
    contact::locate(std::get<Ball<D>>(*shape_), point);
  point.position += translation_;
}

template <int D>
Projection<D> Master<D>::project(const Vec<D>& x, const Projection<D>& seed, FacePoint<D>& point) const {
  if (!shape_) return contact::project(*surface_, boxes_, x, seed, point);
  const Vec<D> own = x - translation_;
  const auto* plane = std::get_if<Plane<D>>(&*shape_);
  point.xi(0) = plane ? closest(*plane, own) : closest(std::get<Ball<D>>(*shape_), own);
  place(point);
  return {Foot::regular, 0, point.xi, (x - point.position).dot(normal(point))};
}

template <int D> Vec<D> Master<D>::normal(const FacePoint<D>& point) const {
  if (!shape_) return surface_->outward(point.tangent).normalized();
  return Vec<D>(point.tangent[0](1), -point.tangent[0](0)).normalized();
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
    surface_->locate(surface_->direction(0).find_element(xi(0)), xi, 0, point);
  }
  functions(point, 0);
}

template <int D>
FaceCoordinates<D> Master<D>::advance(const FaceCoordinates<D>& slip, const FacePoint<D>& foot, double length) const {
  if (!shape_) return FaceCoordinates<D>(advance_slip(*surface_, slip(0), foot, length));
  if (const auto* plane = std::get_if<Plane<D>>(&*shape_))
    return FaceCoordinates<D>(contact::advance_slip(*plane, slip(0), foot.xi(0), length));
  return FaceCoordinates<D>(contact::advance_slip(std::get<Ball<D>>(*shape_), slip(0), foot.xi(0), length));
}

template class Master<2>;

} // namespace signorini::contact
