#include "solid/linear_elastic.hpp"

namespace signorini::solid {

LinearElastic linear_elastic(double youngs_modulus, double poissons_ratio) {
  return {elastic_constants(youngs_modulus, poissons_ratio)};
}

double LinearElastic::energy(const Mat<3>& f) const {
  return 0.5 * stress(f).cwiseProduct(f - Mat<3>::Identity()).sum();
}

Mat<3> LinearElastic::stress(const Mat<3>& f) const {
  const Mat<3> strain = 0.5 * (f + f.transpose()) - Mat<3>::Identity();
  return lambda * strain.trace() * Mat<3>::Identity() + 2 * mu * strain;
}

Moduli LinearElastic::moduli(const Mat<3>&) const {
  Moduli result;
  // ∂P_ik/∂F_jl = λ δ_ik δ_jl + μ (δ_ij δ_kl + δ_il δ_kj)
  for (int row = 0; row < 9; ++row)
    for (int column = 0; column < 9; ++column) {
      const int i = row / 3, k = row % 3, j = column / 3, l = column % 3;
      result(row, column) = lambda * (i == k && j == l) + mu * ((row == column) + (i == l && k == j));
    }
  return result;
}

template Material::Material(LinearElastic);

} // namespace signorini::solid
