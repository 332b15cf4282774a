#include "contact/rigid/rigid_motion.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::contact {

/// A bound on the rotation from another one. Seen from the master, a point x moves by at most ‖ΔR‖ |x − c − t|.
template <int D> double RigidMotion<D>::turned(const Mat<D>& before, const PointColumns<D>& opposite) const {
  const double change = (turn_ - before).norm();
  const Vec<D> center = turning_->center + translation_;
  return change == 0 ? 0 : change * std::sqrt((opposite.colwise() - center).colwise().squaredNorm().maxCoeff());
}

template <int D> double RigidMotion<D>::move(const double* displacement, const PointColumns<D>& opposite) {
  const RigidMotion before = *this;
  translation_ = Eigen::Map<const Vec<D>>(displacement);
  if (turning_) turn_ = Eigen::Map<const Mat<D>>(displacement + D) / turning_->arm;
  return moved_since(before, opposite);
}

template <int D> double RigidMotion<D>::moved_since(const RigidMotion& before, const PointColumns<D>& opposite) const {
  return (translation_ - before.translation_).norm() + (turning_ ? turned(before.turn_, opposite) : 0);
}

template <int D> Vec<D> RigidMotion<D>::pulled_back(const Vec<D>& x) const {
  const Vec<D> own = x - translation_;
  return turning_ ? Vec<D>(own + turn_.transpose() * (own - turning_->center)) : own;
}

template <int D> void RigidMotion<D>::place(FaceGeometry<D>& point) const {
  if (turning_) {
    const auto turn = [&](Vec<D>& vector, const Vec<D>& arm) { vector += turn_ * arm; };
    turn(point.position, point.position - turning_->center);
    for (auto& tangent : point.tangent) turn(tangent, Vec<D>(tangent));
    for (auto& second : point.second) turn(second, Vec<D>(second));
  }
  point.position += translation_;
}

template <int D> PointColumns<D> RigidMotion<D>::displacements(const PointColumns<D>& points) const {
  PointColumns<D> all = translation_.replicate(1, points.cols());
  if (turning_) all += turn_ * (points.colwise() - turning_->center);
  return all;
}

template <int D> void RigidMotion<D>::functions(FacePoint<D>& point, int order) const {
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

template class RigidMotion<2>;
template class RigidMotion<3>;

} // namespace signorini::contact
