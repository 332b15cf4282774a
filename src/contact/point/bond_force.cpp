#include "contact/point/bond_force.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::contact {

template <int D> double Bond<D>::opening() const {
  if (!closed) return apart.norm();
  // |Δ|² − g² = |s|² + 2 g n̄·s with s = Δ − g n̄, without the cancellation of |Δ|² and g²
  const Vec<D> along = apart - gap * normal;
  return std::sqrt(std::max(0.0, along.squaredNorm() + 2 * gap * normal.dot(along)));
}

template <int D> LocalRow<D> opening_row(const Bond<D>& bond, bool about_spring) {
  using Force = LocalForce<D>;
  LocalRow<D> row = LocalRow<D>::Zero();
  const double opening = bond.opening();
  if (opening == 0) return row; // multiplied by Δ or by a damage rate at k's maximum
  // δ δδ = Δ·(δxˢ − δxᵐ(ξ⁰)) − g n̄·(δxˢ − δx̄ᵐ)
  const Vec<D> apart = bond.apart / opening, normal = bond.gap / opening * bond.normal;
  const int bonded = about_spring ? Force::master_column : Force::slip_column;
  const int foot = about_spring ? Force::slip_column : Force::master_column;
  row.template segment<D>(0) = (apart - normal).transpose();
  row.template segment<D>(bonded) = -apart.transpose();
  row.template segment<D>(foot) = normal.transpose();
  return row;
}

template <int D>
void spring_force(const Bond<D>& bond, const Separation& separation, double measure, LocalForce<D>& result) {
  result.shift.setZero();
  result.force = -measure * separation.stiffness * bond.apart;
  // −δ(k Δ) = −k δΔ − Δ k′ δδ
  result.tangent = (-measure * separation.rate * bond.apart) * opening_row(bond, true);
  result.tangent.template middleCols<D>(0).diagonal().array() -= measure * separation.stiffness;
  result.tangent.template middleCols<D>(LocalForce<D>::master_column).diagonal().array() +=
      measure * separation.stiffness;
}

template <int D>
void relief_force(const Bond<D>& bond, const Separation& separation, const LocalGeometry<D>& geometry,
                  LocalForce<D>& result) {
  const GapRows<D> rows = gap_rows(geometry, result.shift);
  const double measure = geometry.reference_measure, traction = measure * separation.stiffness * bond.gap;
  result.force = traction * bond.normal;
  // δ(k g n̄) = k δg n̄ + k g δn̄ + g n̄ k′ δδ
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
