#include "contact/point/local.hpp"

#include <numbers>

namespace signorini::contact {

template <int D> double slave_measure(const LocalGeometry<D>& geometry, LocalRow<D>& derivative) {
  derivative.setZero();
  constexpr int column = LocalForce<D>::slave_tangent_column;
  const Vec<D>& a = geometry.slave_tangent[0];
  if constexpr (D == 2) {
    const double length = a.norm();
    derivative.template segment<D>(column) = a.transpose() / length;
    if (!geometry.revolved) return length;
    // m = 2πr |a|,  δm = 2πr δ|a| + 2π|a| δr
    constexpr double turn = 2 * std::numbers::pi;
    derivative *= turn * geometry.slave(0);
    derivative(0) = turn * length;
    return turn * geometry.slave(0) * length;
  } else {
    const Vec<D>& b = geometry.slave_tangent[1];
    const Vec<D> product = a.cross(b);
    const double area = product.norm();
    const Vec<D> unit = product / area;
    // δ|a×b| = (b×n)·δa + (n×a)·δb
    derivative.template segment<D>(column) = b.cross(unit).transpose();
    derivative.template segment<D>(column + D) = unit.cross(a).transpose();
    return area;
  }
}

template <int D> GapRows<D> gap_rows(const LocalGeometry<D>& geometry, LocalShift<D>& shift) {
  using Force = LocalForce<D>;
  constexpr int tangents = D - 1;
  const FacePoint<D>& master = *geometry.master;
  const Vec<D>& n = geometry.normal;
  const double g = geometry.gap;

  // δg = n̄·(δxˢ − δx̄ᵐ)
  GapRows<D> rows{LocalRow<D>::Zero(), LocalBlock<D>::Zero()};
  rows.gap.template segment<D>(0) = n.transpose();
  rows.gap.template segment<D>(Force::master_column) = -n.transpose();

  shift.setZero();
  if (geometry.foot != Foot::regular) {
    // n̄ = (xˢ − x̄ᵐ)/g with a fixed vertex:  δn̄ = (I − n̄ n̄ᵀ)(δxˢ − δx̄ᵐ)/g
    const Mat<D> projector = (Mat<D>::Identity() - n * n.transpose()) / g;
    rows.normal.template middleCols<D>(0) = projector;
    rows.normal.template middleCols<D>(Force::master_column) = -projector;
    if (geometry.foot == Foot::edge) {
      // The foot moves along the kink:  [τ·τ − g n̄·x_,ββ] δξ̄ = (δxˢ − δx̄ᵐ)·τ + g n̄·δτ,  and δn̄ loses τ δξ̄ with δx̄ᵐ.
      const int b = geometry.along;
      const Vec<D>& tau = master.tangent[b];
      LocalRow<D> right = LocalRow<D>::Zero();
      right.template segment<D>(0) = tau.transpose();
      right.template segment<D>(Force::master_column) = -tau.transpose();
      right.template segment<D>(Force::tangent_column + D * b) = g * n.transpose();
      shift.row(b) = right / (tau.squaredNorm() - g * n.dot(master.second[b + b]));
      rows.normal.noalias() -= (projector * tau) * shift.row(b);
    }
  } else {
    Eigen::Matrix<double, D, tangents> basis; // τ_α
    for (int a = 0; a < tangents; ++a) basis.col(a) = master.tangent[a];
    Mat<tangents> curvature; // n̄·x_,αβ
    for (int a = 0; a < tangents; ++a)
      for (int b = 0; b < tangents; ++b) curvature(a, b) = n.dot(master.second[a + b]);
    const Mat<tangents> metric = basis.transpose() * basis;

    // [τ_α·τ_β − g n̄·x_,αβ] δξ̄^β = (δxˢ − δx̄ᵐ)·τ_α + g n̄·δτ_α   [theory 5.1]
    const Mat<tangents> inverse = (metric - g * curvature).inverse();
    const Eigen::Matrix<double, tangents, D> along = inverse * basis.transpose();
    shift.template leftCols<D>() = along;
    shift.template middleCols<D>(Force::master_column) = -along;
    for (int a = 0; a < tangents; ++a)
      shift.template middleCols<D>(Force::tangent_column + D * a) = (g * inverse.col(a)) * n.transpose();

    // δn̄ = −τ^α n̄·(δτ_α + x_,αβ δξ̄^β),  τ^α = m^{αβ} τ_β
    const Eigen::Matrix<double, D, tangents> dual = basis * metric.inverse(), turn = dual * curvature;
    const Mat<D> by_position = turn * along;
    rows.normal.template leftCols<D>() = -by_position;
    rows.normal.template middleCols<D>(Force::master_column) = by_position;
    for (int a = 0; a < tangents; ++a)
      rows.normal.template middleCols<D>(Force::tangent_column + D * a) =
          -(turn * (g * inverse.col(a)) + dual.col(a)) * n.transpose();
  }
  return rows;
}

template <int D> Vec<D> slip_of(const LocalGeometry<D>& geometry) {
  const Vec<D> chord = geometry.master->position - *geometry.slip_point; // both on the current master
  if constexpr (D == 2)
    if (geometry.way != 0) return geometry.way * chord.norm() * Vec<D>(-geometry.normal(1), geometry.normal(0));
  return chord;
}

template <int D>
void turn_slip(const LocalGeometry<D>& geometry, const GapRows<D>& rows, double factor, LocalBlock<D>& slip) {
  if constexpr (D == 2) {
    if (geometry.way == 0) return;
    // δv = s (J n̄ δ|x̄ᵐ − xᵐ(ξ_sl)| + |x̄ᵐ − xᵐ(ξ_sl)| J δn̄)
    const Vec<D> chord = geometry.master->position - *geometry.slip_point;
    const LocalRow<D> longer = chord.normalized().transpose() * slip;
    const Vec<D>& n = geometry.normal;
    const double length = factor * chord.norm();
    slip.row(0) = geometry.way * (-n(1) * longer - length * rows.normal.row(1));
    slip.row(1) = geometry.way * (n(0) * longer + length * rows.normal.row(0));
  }
}

template <int D>
LocalBlock<D> slip_rows(const LocalGeometry<D>& geometry, const GapRows<D>& rows, const LocalShift<D>& shift) {
  LocalBlock<D> slip = LocalBlock<D>::Zero();
  slip.template middleCols<D>(LocalForce<D>::master_column).setIdentity();
  slip.template middleCols<D>(LocalForce<D>::slip_column).diagonal().setConstant(-1);
  for (int a = 0; a < D - 1; ++a) slip.noalias() += geometry.master->tangent[a] * shift.row(a);
  turn_slip(geometry, rows, 1, slip);
  return slip;
}

template <int D>
void fade_area(const LocalGeometry<D>& geometry, const LocalShift<D>& shift, double& measure, LocalRow<D>& derivative) {
  if (geometry.fade == 1) return;
  derivative *= geometry.fade;
  derivative.noalias() += measure * geometry.fade_rate.transpose() * shift;
  measure *= geometry.fade;
}

template double slave_measure<2>(const LocalGeometry<2>&, LocalRow<2>&);
template double slave_measure<3>(const LocalGeometry<3>&, LocalRow<3>&);
template void fade_area<2>(const LocalGeometry<2>&, const LocalShift<2>&, double&, LocalRow<2>&);
template void fade_area<3>(const LocalGeometry<3>&, const LocalShift<3>&, double&, LocalRow<3>&);
template GapRows<2> gap_rows<2>(const LocalGeometry<2>&, LocalShift<2>&);
template GapRows<3> gap_rows<3>(const LocalGeometry<3>&, LocalShift<3>&);
template Vec<2> slip_of(const LocalGeometry<2>&);
template Vec<3> slip_of(const LocalGeometry<3>&);
template void turn_slip(const LocalGeometry<2>&, const GapRows<2>&, double, LocalBlock<2>&);
template void turn_slip(const LocalGeometry<3>&, const GapRows<3>&, double, LocalBlock<3>&);
template LocalBlock<2> slip_rows(const LocalGeometry<2>&, const GapRows<2>&, const LocalShift<2>&);
template LocalBlock<3> slip_rows(const LocalGeometry<3>&, const GapRows<3>&, const LocalShift<3>&);

} // namespace signorini::contact
