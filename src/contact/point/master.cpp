#include "contact/point/master.hpp"

#include "contact/point/slip.hpp"

#include <algorithm>
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
Master<D>::Master(Obstacle<D> obstacle, std::optional<Turning<D>> turning, double opposite)
    : rigid_(true), turning_(std::move(turning)) {
  if (const auto* patch = std::get_if<nurbs::Patch>(&obstacle)) {
    surface_.emplace(*patch);
    surface_->extend(end_extension, end_extension * opposite);
    boxes_.update(*surface_);
    displacements_.resize(D * surface_->functions());
  } else {
    shape_ = std::move(obstacle);
  }
}

/// A bound as of move() on the rotation from another one. Seen from the master, a point x moves by at most
/// ‖ΔR‖ |x − c − t|.
template <int D>
double Master<D>::turned(const Mat<D>& before, const Eigen::Matrix<double, D, Eigen::Dynamic>& opposite) const {
  const double change = (turn_ - before).norm();
  const Vec<D> center = turning_->center + translation_;
  return change == 0 ? 0 : change * std::sqrt((opposite.colwise() - center).colwise().squaredNorm().maxCoeff());
}

/// x as seen from an obstacle that neither moves nor turns.
template <int D> Vec<D> Master<D>::pulled_back(const Vec<D>& x) const {
  const Vec<D> own = x - translation_;
  return turning_ ? Vec<D>(own + turn_.transpose() * (own - turning_->center)) : own;
}

template <int D>
double Master<D>::move(const double* displacement, const Eigen::Matrix<double, D, Eigen::Dynamic>& opposite) {
  if (!rigid_) {
    const double distance = surface_->move(displacement);
    boxes_.update(*surface_);
    return distance;
  }
  const Vec<D> to = Eigen::Map<const Vec<D>>(displacement);
  double distance = (to - translation_).norm();
  translation_ = to;
  if (turning_) {
    const Mat<D> before = turn_;
    turn_ = Eigen::Map<const Mat<D>>(displacement + D) / turning_->arm;
    distance += turned(before, opposite);
  }
  if (surface_ && distance > 0) {
    for (std::size_t i = 0; i < displacements_.size(); ++i) displacements_[i] = displacement[i % D];
    if (turning_) {
      Eigen::Map<Eigen::Matrix<double, D, Eigen::Dynamic>> all(displacements_.data(), D, surface_->functions());
      all += turn_ * (surface_->reference().colwise() - turning_->center);
    }
    surface_->move(displacements_.data());
    boxes_.update(*surface_);
  }
  return distance;
}

template <int D>
double Master<D>::moved_since(const Master& before, const Eigen::Matrix<double, D, Eigen::Dynamic>& opposite) const {
  if (!rigid_) return surface_->moved_since(*before.surface_);
  return (translation_ - before.translation_).norm() + (turning_ ? turned(before.turn_, opposite) : 0);
}

/// Geometry of order 2 of a closed-form shape at point.xi.
template <int D> void Master<D>::place(FaceGeometry<D>& point) const {
  point.element = 0;
  with_shape<D>(*shape_, [&](const auto& shape) { contact::locate(shape, point); });
  if (turning_) {
    const auto turn = [&](Vec<D>& vector, const Vec<D>& arm) { vector += turn_ * arm; };
    turn(point.position, point.position - turning_->center);
    for (auto& tangent : point.tangent) turn(tangent, Vec<D>(tangent));
    for (auto& second : point.second) turn(second, Vec<D>(second));
  }
  point.position += translation_;
}

template <int D>
Projection<D> Master<D>::project(const Vec<D>& x, const Projection<D>& seed, FaceGeometry<D>& point) const {
  if (!shape_) return contact::project(*surface_, boxes_, x, seed, point);
  with_shape<D>(*shape_, [&](const auto& shape) { find_closest(shape, pulled_back(x), point); });
  place(point);
  return {Foot::regular, 0, 0, point.xi, (x - point.position).dot(normal(point)), point.last};
}

template <int D> Vec<D> Master<D>::normal(const FaceGeometry<D>& point) const {
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
  if (!turning_) return;
  // X − c = Rᵀ (x − t − c),  X_,α = Rᵀ τ_α
  const double scale = 1 / turning_->arm;
  const Vec<D> arm = scale * (pulled_back(point.position) - turning_->center);
  std::copy_n(arm.data(), D, point.value.begin() + 1);
  for (std::size_t a = 0; a < D - 1 && order > 0; ++a) {
    const Vec<D> rate = scale * (point.tangent[a] + turn_.transpose() * point.tangent[a]);
    std::copy_n(rate.data(), D, point.derivative[a].begin() + 1);
  }
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

template class Master<2>;
template class Master<3>;

} // namespace signorini::contact
