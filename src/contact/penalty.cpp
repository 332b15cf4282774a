#include "contact/penalty.hpp"

namespace signorini::contact {

namespace {

template <int D> using Row = Eigen::Matrix<double, 1, LocalForce<D>::columns>;
template <int D> using Block = Eigen::Matrix<double, D, LocalForce<D>::columns>;

/// Index of x_,αβ in FacePoint::second.
constexpr std::size_t second_index(int alpha, int beta) {
  return static_cast<std::size_t>(alpha + beta);
}

/// |xˢ_,1| or |xˢ_,1 × xˢ_,2| and its derivative, which only touches the slave tangents' columns.
template <int D> double slave_measure(const LocalGeometry<D>& geometry, Row<D>& derivative) {
  derivative.setZero();
  constexpr int column = LocalForce<D>::slave_tangent_column;
  const Vec<D>& a = geometry.slave_tangent[0];
  if constexpr (D == 2) {
    const double length = a.norm();
    derivative.template segment<D>(column) = a.transpose() / length;
    return length;
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

} // namespace

template <int D> void penalty_force(const PenaltyLaw& law, const LocalGeometry<D>& geometry, LocalForce<D>& result) {
  using Force = LocalForce<D>;
  constexpr int tangents = D - 1;
  const FacePoint<D>& master = *geometry.master;
  const Vec<D>& n = geometry.normal;
  const double g = geometry.gap;

  // δg = n̄·(δxˢ − δx̄ᵐ)
  Row<D> gap_row = Row<D>::Zero();
  gap_row.template segment<D>(0) = n.transpose();
  gap_row.template segment<D>(Force::master_column) = -n.transpose();

  Block<D> normal_rows = Block<D>::Zero(); // δn̄
  result.shift.setZero();
  if (geometry.foot == Foot::corner) {
    // n̄ = (xˢ − x̄ᵐ)/g with a fixed vertex:  δn̄ = (I − n̄ n̄ᵀ)(δxˢ − δx̄ᵐ)/g
    const Mat<D> projector = (Mat<D>::Identity() - n * n.transpose()) / g;
    normal_rows.template middleCols<D>(0) = projector;
    normal_rows.template middleCols<D>(Force::master_column) = -projector;
  } else {
    // [τ_α·τ_β − g n̄·x_,αβ] δξ̄^β = (δxˢ − δx̄ᵐ)·τ_α + g n̄·δτ_α   (thesis A.17, A.18)
    Mat<tangents> metric, hessian;
    for (int a = 0; a < tangents; ++a)
      for (int b = 0; b < tangents; ++b) {
        metric(a, b) = master.tangent[static_cast<std::size_t>(a)].dot(master.tangent[static_cast<std::size_t>(b)]);
        hessian(a, b) = metric(a, b) - g * n.dot(master.second[second_index(a, b)]);
      }
    Eigen::Matrix<double, tangents, Force::columns> right = Eigen::Matrix<double, tangents, Force::columns>::Zero();
    for (int a = 0; a < tangents; ++a) {
      const auto tau = master.tangent[static_cast<std::size_t>(a)].transpose();
      right.row(a).template segment<D>(0) = tau;
      right.row(a).template segment<D>(Force::master_column) = -tau;
      right.row(a).template segment<D>(Force::tangent_column + D * a) = g * n.transpose();
    }
    result.shift.noalias() = hessian.inverse() * right;

    // δn̄ = −τ^α n̄·(δτ_α + x_,αβ δξ̄^β),  τ^α = m^{αβ} τ_β
    const Mat<tangents> inverse_metric = metric.inverse();
    for (int a = 0; a < tangents; ++a) {
      Row<D> turn = Row<D>::Zero();
      for (int b = 0; b < tangents; ++b) turn += n.dot(master.second[second_index(a, b)]) * result.shift.row(b);
      turn.template segment<D>(Force::tangent_column + D * a) += n.transpose();
      Vec<D> contravariant = Vec<D>::Zero();
      for (int b = 0; b < tangents; ++b)
        contravariant += inverse_metric(a, b) * master.tangent[static_cast<std::size_t>(b)];
      normal_rows.noalias() -= contravariant * turn;
    }
  }

  // t_N = −ε_N g,  δ(t_N n̄) = −ε_N δg n̄ + t_N δn̄
  result.pressure = -law.normal * g;
  Vec<D> traction = result.pressure * n;
  Block<D> traction_rows = result.pressure * normal_rows - (law.normal * n) * gap_row;

  result.state = ContactState::stick;
  result.friction.setZero();
  if (law.friction > 0 && geometry.slip_point) {
    // Trial t_T = ε_T (xᵐ(ξ̄) − xᵐ(ξ_sl)) (thesis 3.74), both on the current master
    const Vec<D> trial = law.tangential * (master.position - *geometry.slip_point);
    Block<D> trial_rows = Block<D>::Zero();
    trial_rows.template middleCols<D>(Force::master_column).diagonal().setConstant(law.tangential);
    trial_rows.template middleCols<D>(Force::slip_column).diagonal().setConstant(-law.tangential);
    for (int a = 0; a < tangents; ++a)
      trial_rows.noalias() += (law.tangential * master.tangent[static_cast<std::size_t>(a)]) * result.shift.row(a);

    const double magnitude = trial.norm(), limit = law.friction * result.pressure;
    if (magnitude <= limit) {
      result.friction = trial;
      traction_rows -= trial_rows;
    } else {
      // t_T = μ t_N n_T,  δt_T = μ δt_N n_T + μ t_N/|t| (I − n_T n_Tᵀ) δt   (thesis 3.76)
      result.state = ContactState::slip;
      const Vec<D> direction = trial / magnitude;
      result.friction = limit * direction;
      traction_rows += (law.friction * law.normal * direction) * gap_row;
      const Mat<D> projector = (limit / magnitude) * (Mat<D>::Identity() - direction * direction.transpose());
      traction_rows.noalias() -= projector * trial_rows;
    }
    traction -= result.friction;
  }

  Row<D> measure_row;
  result.measure = slave_measure(geometry, measure_row);
  result.force = result.measure * traction;
  result.tangent = result.measure * traction_rows;
  result.tangent.noalias() += traction * measure_row;
}

template void penalty_force<2>(const PenaltyLaw&, const LocalGeometry<2>&, LocalForce<2>&);
template void penalty_force<3>(const PenaltyLaw&, const LocalGeometry<3>&, LocalForce<3>&);

} // namespace signorini::contact
