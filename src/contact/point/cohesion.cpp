#include "contact/point/cohesion.hpp"

#include "base/error.hpp"
#include "contact/constants.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace signorini::contact {

namespace {

Separation separate_exponentially(const Cohesion& law, double opening, double largest) {
  const double peak = strongest_opening(law), most = std::max(opening, largest), x = most / peak;
  if (x > broken_opening) return {0, 0, 1, 0, law.energy};
  // k = k₀ exp(−x),  k₀ = e σ_c/δ_c,  ∫T dδ − ½ T δ = G_c [1 − (1 + x + x²/2) exp(−x)]
  const double left = std::exp(-x), stiffness = std::numbers::e * law.strength / peak * left;
  const bool opens = opening >= largest;
  return {stiffness, opens ? -stiffness / peak : 0, 1 - left, opens ? left / peak : 0,
          law.energy * (1 - (1 + x + x * x / 2) * left)};
}

Separation separate_linearly(const Cohesion& law, double opening, double largest) {
  const double first = strongest_opening(law), last = 2 * law.energy / law.strength;
  const double most = std::max({opening, largest, first});
  if (most >= last) return {0, 0, 1, 0, law.energy};
  // T = σ_c (δ_f − δ)/(δ_f − δ₀),  k = T/δ,  ∫T dδ − ½ T δ = ½ (σ_c δ − T δ₀)
  const double slope = law.strength / (last - first), traction = slope * (last - most);
  const bool opens = opening >= std::max(largest, first);
  const double rate = opens ? -slope * last / (most * most) : 0;
  return {traction / most, rate, 1 - traction / most / law.stiffness, -rate / law.stiffness,
          0.5 * (law.strength * most - traction * first)};
}

} // namespace

void check(const Cohesion& law) {
  require(std::isfinite(law.strength) && law.strength > 0, "contact.cohesion.strength", {{"value", law.strength}});
  require(std::isfinite(law.energy) && law.energy > 0, "contact.cohesion.energy", {{"value", law.energy}});
  if (law.softening == Softening::exponential) return;
  require(std::isfinite(law.stiffness) && law.stiffness > 0, "contact.cohesion.stiffness", {{"value", law.stiffness}});
  // δ_f > δ₀:  K > σ_c²/(2 G_c)
  const double least = law.strength * law.strength / (2 * law.energy);
  require(law.stiffness > least, "contact.cohesion.snap_back", {{"stiffness", law.stiffness}, {"least", least}});
}

double strongest_opening(const Cohesion& law) {
  return law.softening == Softening::exponential ? law.energy / (std::numbers::e * law.strength)
                                                 : law.strength / law.stiffness;
}

Separation separate(const Cohesion& law, double opening, double largest) {
  return law.softening == Softening::exponential ? separate_exponentially(law, opening, largest)
                                                 : separate_linearly(law, opening, largest);
}

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
