#include "solid/material.hpp"

#include "base/error.hpp"

#include <cmath>

namespace signorini::solid {

ElasticConstants elastic_constants(double youngs_modulus, double poissons_ratio) {
  require(std::isfinite(youngs_modulus) && youngs_modulus > 0, "solid.material.youngs_modulus",
          {{"value", youngs_modulus}});
  require(poissons_ratio > -1 && poissons_ratio < 0.5, "solid.material.poissons_ratio", {{"value", poissons_ratio}});
  const double mu = youngs_modulus / (2 * (1 + poissons_ratio));
  return {youngs_modulus, poissons_ratio, 2 * mu * poissons_ratio / (1 - 2 * poissons_ratio), mu};
}

double Material::energy(const Mat<3>& f, std::span<const double> committed) const {
  return energy_(law(), f, committed.empty() ? initial_ : committed);
}

Mat<3> Material::stress(const Mat<3>& f, std::span<const double> committed) const {
  std::vector<double> trial(initial_.size());
  return stress_(law(), f, committed.empty() ? initial_ : committed, trial);
}

Mat<3> Material::cauchy_stress(const Mat<3>& f, std::span<const double> committed) const {
  const Mat<3> p = stress(f, committed);
  // σ = P Fᵀ/J
  return linear_ ? p : Mat<3>(p * f.transpose() / f.determinant());
}

} // namespace signorini::solid
