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

namespace {

/// Internal variables of a point with the initial ones and places for trial values where there are none.
struct Completed {
  Completed(const Material& material, const Memory& given) : memory(given) {
    if (memory.committed.empty()) memory.committed = material.initial_values(3);
    if (!memory.trial.empty() || memory.committed.empty()) return;
    scratch.resize(memory.committed.size());
    memory.trial = scratch;
  }
  std::vector<double> scratch;
  Memory memory;
};

} // namespace

double Material::energy(const Mat<3>& f, const Memory& memory) const {
  return at_point_.energy(law(), f, Completed(*this, memory).memory);
}

Mat<3> Material::stress(const Mat<3>& f, const Memory& memory) const {
  return at_point_.stress(law(), f, Completed(*this, memory).memory);
}

Moduli Material::moduli(const Mat<3>& f, const Memory& memory) const {
  return at_point_.moduli(law(), f, Completed(*this, memory).memory);
}

Account Material::account(const Mat<3>& f, std::span<const double> values) const {
  return at_point_.account(law(), f, values.empty() ? initial_values(3) : values);
}

Mat<3> Material::cauchy_stress(const Mat<3>& f, const Memory& memory) const {
  const Mat<3> p = stress(f, memory);
  // σ = P Fᵀ/J
  return small_strains_ ? p : Mat<3>(p * f.transpose() / f.determinant());
}

double Material::thickness_stretch(const Mat<2>& f, const Memory& memory) const {
  if (linear_) {
    const Mat<3> strained = in_space<2>(f);
    return 1 - stress(strained)(2, 2) / moduli(strained)(8, 8);
  }
  const std::span<const double> committed = memory.committed.empty() ? initial_values(2) : memory.committed;
  const PointMemory own{committed.data(), nullptr, static_cast<int>(committed.size()), memory.duration};
  const double stretch =
      f.determinant() > 0 ? solid::thickness_stretch(respond<2>(), law(), constants_.poissons_ratio, f, own) : 0;
  return stretch > 0 ? stretch : 1;
}

} // namespace signorini::solid
