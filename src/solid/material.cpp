#include "solid/material.hpp"

#include "base/error.hpp"

#include <cmath>

namespace signorini::solid {

namespace {

ElasticConstants elastic_constants(double youngs_modulus, double poissons_ratio) {
  require(std::isfinite(youngs_modulus) && youngs_modulus > 0,
          "E must be a positive number (Young's modulus, force per area), got ", youngs_modulus);
  require(poissons_ratio > -1 && poissons_ratio < 0.5,
          "nu must lie in (-1, 0.5) (Poisson's ratio; 0.5 is incompressible, ",
          "which a displacement formulation cannot take: try 0.49), got ", poissons_ratio);
  const double mu = youngs_modulus / (2 * (1 + poissons_ratio));
  return {youngs_modulus, poissons_ratio, 2 * mu * poissons_ratio / (1 - 2 * poissons_ratio), mu};
}

/// ε = sym(F − I)
template <int D> Mat<D> small_strain(const Mat<D>& deformation) {
  return 0.5 * (deformation + deformation.transpose()) - Mat<D>::Identity();
}

} // namespace

NeoHookean neo_hookean(double youngs_modulus, double poissons_ratio) {
  return {elastic_constants(youngs_modulus, poissons_ratio)};
}

LinearElastic linear_elastic(double youngs_modulus, double poissons_ratio) {
  return {elastic_constants(youngs_modulus, poissons_ratio)};
}

const ElasticConstants& constants(const Material& material) {
  return std::visit([](const auto& law) -> const ElasticConstants& { return law; }, material);
}

Mat<3> in_space(const Mat<2>& deformation, double hoop) {
  Mat<3> f = Mat<3>::Zero();
  f.topLeftCorner<2, 2>() = deformation;
  f(2, 2) = hoop;
  return f;
}

template <int D> double energy(const NeoHookean& material, const Mat<D>& deformation) {
  const double log_j = std::log(deformation.determinant());
  // tr C − 3 = Σ F_ij² − D, as the missing diagonal entries of C are 1
  return 0.5 * material.lambda * log_j * log_j + 0.5 * material.mu * (deformation.squaredNorm() - D) -
         material.mu * log_j;
}

template <int D> Mat<D> first_piola_stress(const NeoHookean& material, const Mat<D>& deformation) {
  const double log_j = std::log(deformation.determinant());
  return material.mu * deformation + (material.lambda * log_j - material.mu) * deformation.inverse().transpose();
}

template <int D> Mat<3> cauchy_stress(const NeoHookean& material, const Mat<D>& deformation) {
  Mat<3> f = Mat<3>::Identity();
  f.topLeftCorner<D, D>() = deformation;
  const double j = f.determinant();
  return (material.lambda * std::log(j) / j) * Mat<3>::Identity() +
         (material.mu / j) * (f * f.transpose() - Mat<3>::Identity());
}

template <int D> double energy(const LinearElastic& material, const Mat<D>& deformation) {
  const Mat<D> strain = small_strain<D>(deformation);
  return 0.5 * material.lambda * strain.trace() * strain.trace() + material.mu * strain.squaredNorm();
}

template <int D> Mat<D> first_piola_stress(const LinearElastic& material, const Mat<D>& deformation) {
  const Mat<D> strain = small_strain<D>(deformation);
  return material.lambda * strain.trace() * Mat<D>::Identity() + 2 * material.mu * strain;
}

template <int D> Mat<3> cauchy_stress(const LinearElastic& material, const Mat<D>& deformation) {
  Mat<3> f = Mat<3>::Identity();
  f.topLeftCorner<D, D>() = deformation;
  return first_piola_stress<3>(material, f);
}

template <int D> double energy(const Material& material, const Mat<D>& deformation) {
  return std::visit([&](const auto& law) { return energy<D>(law, deformation); }, material);
}

template <int D> Mat<D> first_piola_stress(const Material& material, const Mat<D>& deformation) {
  return std::visit([&](const auto& law) { return first_piola_stress<D>(law, deformation); }, material);
}

template <int D> Mat<3> cauchy_stress(const Material& material, const Mat<D>& deformation) {
  return std::visit([&](const auto& law) { return cauchy_stress<D>(law, deformation); }, material);
}

template double energy<2>(const NeoHookean&, const Mat<2>&);
template double energy<3>(const NeoHookean&, const Mat<3>&);
template Mat<2> first_piola_stress<2>(const NeoHookean&, const Mat<2>&);
template Mat<3> first_piola_stress<3>(const NeoHookean&, const Mat<3>&);
template Mat<3> cauchy_stress<2>(const NeoHookean&, const Mat<2>&);
template Mat<3> cauchy_stress<3>(const NeoHookean&, const Mat<3>&);
template double energy<2>(const LinearElastic&, const Mat<2>&);
template double energy<3>(const LinearElastic&, const Mat<3>&);
template Mat<2> first_piola_stress<2>(const LinearElastic&, const Mat<2>&);
template Mat<3> first_piola_stress<3>(const LinearElastic&, const Mat<3>&);
template Mat<3> cauchy_stress<2>(const LinearElastic&, const Mat<2>&);
template Mat<3> cauchy_stress<3>(const LinearElastic&, const Mat<3>&);
template double energy<2>(const Material&, const Mat<2>&);
template double energy<3>(const Material&, const Mat<3>&);
template Mat<2> first_piola_stress<2>(const Material&, const Mat<2>&);
template Mat<3> first_piola_stress<3>(const Material&, const Mat<3>&);
template Mat<3> cauchy_stress<2>(const Material&, const Mat<2>&);
template Mat<3> cauchy_stress<3>(const Material&, const Mat<3>&);

} // namespace signorini::solid
