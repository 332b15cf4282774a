#include "contact/point/bond_force.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::contact {

namespace {

/// δn of a split bond in the columns of τ_α, for the scalar product with a vector: −(τ^α·a) n·δτ_α.
template <int D> LocalRow<D> turn_row(const Bond<D>& bond, const Vec<D>& along) {
  LocalRow<D> row = LocalRow<D>::Zero();
  Eigen::Matrix<double, D, D - 1> basis; // τ_α
  for (int a = 0; a < D - 1; ++a) basis.col(a) = bond.split->tangent[a];
  const Eigen::Matrix<double, D, D - 1> dual = basis * (basis.transpose() * basis).inverse(); // τ^α
  for (int a = 0; a < D - 1; ++a)
    row.template segment<D>(LocalForce<D>::tangent_column + D * a) = -dual.col(a).dot(along) * bond.normal.transpose();
  return row;
}

/// δΔ_n = n·(δxˢ − δxᵐ(ξ⁰)) + Δ·δn of a split bond
template <int D> LocalRow<D> lift_row(const Bond<D>& bond) {
  LocalRow<D> row = turn_row(bond, bond.apart);
  row.template segment<D>(0) = bond.normal.transpose();
  row.template segment<D>(LocalForce<D>::master_column) = -bond.normal.transpose();
  return row;
}

/// δm = 2 Δ_n (Δ_n δδ/δ − δΔ_n)/δ²
template <int D> LocalRow<D> mix_row(const Bond<D>& bond, const LocalRow<D>& opening) {
  const double u = bond.opening(), lift = bond.normal.dot(bond.apart);
  return (2 * lift / (u * u)) * (lift / u * opening - lift_row(bond));
}

} // namespace

template <int D> double Bond<D>::opening() const {
  if (split) {
    const double lift = normal.dot(apart);
    return std::sqrt(weight * (apart - lift * normal).squaredNorm() + lift * lift);
  }
  if (!closed) return apart.norm();
  // |Δ|² − g² = |s|² + 2 g n̄·s with s = Δ − g n̄, without the cancellation of |Δ|² and g²
  const Vec<D> along = apart - gap * normal;
  return std::sqrt(weight * std::max(0.0, along.squaredNorm() + 2 * gap * normal.dot(along)));
}

template <int D> double Bond<D>::mix() const {
  if (!split) return closed ? 1 : 0;
  const double lift = normal.dot(apart), sheared = weight * (apart - lift * normal).squaredNorm();
  return sheared > 0 ? sheared / (sheared + lift * lift) : 0;
}

template <int D> Vec<D> Bond<D>::pull() const {
  if (!split) return weight * apart;
  return weight * apart + ((1 - weight) * normal.dot(apart)) * normal;
}

template <int D> LocalRow<D> opening_row(const Bond<D>& bond, bool about_spring) {
  using Force = LocalForce<D>;
  LocalRow<D> row = LocalRow<D>::Zero();
  const double opening = bond.opening();
  if (opening == 0) return row; // multiplied by Δ or by a damage rate at k's maximum
  // δ δδ = v·(δxˢ − δxᵐ(ξ⁰)) − b² g n̄·(δxˢ − δx̄ᵐ),   v = b² Δ;   split: + (1 − b²) Δ_n Δ·δn
  const Vec<D> apart = bond.pull() / opening, normal = bond.weight * bond.gap / opening * bond.normal;
  const int bonded = about_spring ? Force::master_column : Force::slip_column;
  const int foot = about_spring ? Force::slip_column : Force::master_column;
  row.template segment<D>(0) = (apart - normal).transpose();
  row.template segment<D>(bonded) = -apart.transpose();
  row.template segment<D>(foot) = normal.transpose();
  if (bond.split) row += ((1 - bond.weight) * bond.normal.dot(bond.apart) / opening) * turn_row(bond, bond.apart);
  return row;
}

template <int D>
void spring_force(const Bond<D>& bond, const Separation& separation, double measure, LocalForce<D>& result) {
  const Vec<D> pull = bond.pull();
  const LocalRow<D> opening = opening_row(bond, true);
  const double stiffness = measure * separation.stiffness;
  result.shift.setZero();
  result.force = -measure * separation.stiffness * pull;
  // −δ(k v) = −k δv − v (k_δ δδ + k_m δm)
  result.tangent = (-measure * separation.rate * pull) * opening;
  result.tangent.template middleCols<D>(0).diagonal().array() -= stiffness * bond.weight;
  result.tangent.template middleCols<D>(LocalForce<D>::master_column).diagonal().array() += stiffness * bond.weight;
  if (!bond.split) return;
  if (bond.opening() > 0) result.tangent.noalias() -= (measure * separation.of_mix * pull) * mix_row(bond, opening);
  // δv = b² δΔ + (1 − b²) (n δΔ_n + Δ_n δn)
  const double rest = stiffness * (1 - bond.weight), lift = bond.normal.dot(bond.apart);
  result.tangent.noalias() -= (rest * bond.normal) * lift_row(bond);
  for (int i = 0; i < D; ++i) result.tangent.row(i) -= (rest * lift) * turn_row(bond, Vec<D>(Vec<D>::Unit(i)));
}

template <int D>
void relief_force(const Bond<D>& bond, const Separation& separation, const LocalGeometry<D>& geometry,
                  LocalForce<D>& result) {
  const GapRows<D> rows = gap_rows(geometry, result.shift);
  const double measure = geometry.reference_measure * bond.weight;
  const double traction = measure * separation.stiffness * bond.gap;
  result.force = traction * bond.normal;
  // δ(k b² g n̄) = b² (k δg n̄ + k g δn̄ + g n̄ k′ δδ)
  result.tangent = traction * rows.normal;
  result.tangent.noalias() += (measure * separation.stiffness * bond.normal) * rows.gap;
  result.tangent.noalias() += (measure * separation.rate * bond.gap * bond.normal) * opening_row(bond, false);
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template struct Bond<D>;                                                                                             \
  template LocalRow<D> opening_row(const Bond<D>&, bool);                                                              \
  template void spring_force(const Bond<D>&, const Separation&, double, LocalForce<D>&);                               \
  template void relief_force(const Bond<D>&, const Separation&, const LocalGeometry<D>&, LocalForce<D>&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::contact
