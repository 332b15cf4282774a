#include "solid/material.hpp"

#include "differences.hpp"
#include "nurbs/random_patch.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace signorini::solid {
namespace material_test {

using nurbs::test::Random;
using nurbs::test::uniform;

/// A deformation gradient with J in [0.3, 3].
template <int D> Mat<D> random_deformation(Random& random) {
  for (;;) {
    Mat<D> f = Mat<D>::Identity();
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) f(i, j) += uniform(random, -0.8, 0.8);
    if (f.determinant() > 0.3 && f.determinant() < 3) return f;
  }
}

template <int D, class Make> void stress_is_the_energys_derivative(Make make) {
  Random random(1);
  for (int trial = 0; trial < 100; ++trial) {
    const Material material = make(uniform(random, 0.1, 10), uniform(random, -0.5, 0.49));
    const Mat<D> f = random_deformation<D>(random), p = first_piola_stress<D>(material, f);
    const double scale = p.norm() + constants(material).mu;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) {
        const auto along = [&](double h) {
          Mat<D> moved = f;
          moved(i, j) += h;
          return energy<D>(material, moved);
        };
        EXPECT_NEAR(signorini::test::derivative<double>(along, 1e-3), p(i, j), 1e-8 * scale);
      }
    // σ = P Fᵀ/J; at small strains they are one
    const Mat<3> cauchy = cauchy_stress<D>(material, f);
    const bool small = std::holds_alternative<LinearElastic>(material);
    const Mat<D> pushed = small ? p : Mat<D>(p * f.transpose() / f.determinant());
    EXPECT_NEAR((cauchy.template topLeftCorner<D, D>() - pushed).norm(), 0, 1e-13 * (1 + pushed.norm()));
  }
}

TEST(Material, StressIsTheEnergysDerivativeInThePlane) {
  stress_is_the_energys_derivative<2>(neo_hookean);
  stress_is_the_energys_derivative<2>(linear_elastic);
}
TEST(Material, StressIsTheEnergysDerivativeInSpace) {
  stress_is_the_energys_derivative<3>(neo_hookean);
  stress_is_the_energys_derivative<3>(linear_elastic);
}

TEST(Material, PlaneStrainIsTheSpaceLawWithUnitStretchAcross) {
  Random random(2);
  const NeoHookean rubber = neo_hookean(2, 0.3);
  const LinearElastic steel = linear_elastic(2, 0.3);
  for (int trial = 0; trial < 20; ++trial) {
    const Mat<2> plane = random_deformation<2>(random);
    const Mat<3> space = in_space(plane, 1);
    for (const Material& material : {Material(rubber), Material(steel)}) {
      EXPECT_NEAR(energy<2>(material, plane), energy<3>(material, space), 1e-14);
      EXPECT_NEAR((cauchy_stress<2>(material, plane) - cauchy_stress<3>(material, space)).norm(), 0, 1e-13);
    }
    const double j = plane.determinant();
    EXPECT_NEAR(cauchy_stress<2>(rubber, plane)(2, 2), rubber.lambda * std::log(j) / j, 1e-14);
    EXPECT_NEAR(cauchy_stress<2>(steel, plane)(2, 2), steel.lambda * (plane.trace() - 2), 1e-14);
  }
}

TEST(Material, SmallStrainsAreHookes) {
  const NeoHookean material = neo_hookean(3, 0.25);
  EXPECT_DOUBLE_EQ(material.mu, 1.2);
  EXPECT_DOUBLE_EQ(material.lambda, 1.2);
  Mat<3> strain;
  strain << 2, 0.5, -1, 0.5, -1, 0.3, -1, 0.3, 0.7;
  strain *= 1e-7;
  // σ = λ tr ε I + 2 μ ε
  const Mat<3> hooke = material.lambda * strain.trace() * Mat<3>::Identity() + 2 * material.mu * strain;
  EXPECT_NEAR((cauchy_stress<3>(material, Mat<3>::Identity() + strain) - hooke).norm(), 0, 1e-12);
  EXPECT_NEAR((cauchy_stress<3>(linear_elastic(3, 0.25), Mat<3>::Identity() + strain) - hooke).norm(), 0, 1e-15);
}

TEST(Material, ErrorsNameTheConstant) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (double modulus : {0.0, -1.0, nan, infinity}) {
    EXPECT_ERROR(neo_hookean(modulus, 0.3), "E must be a positive");
    EXPECT_ERROR(linear_elastic(modulus, 0.3), "E must be a positive");
  }
  for (double ratio : {0.5, 0.7, -1.0, nan}) {
    EXPECT_ERROR(neo_hookean(1, ratio), "nu must lie in (-1, 0.5)");
    EXPECT_ERROR(linear_elastic(1, ratio), "nu must lie in (-1, 0.5)");
  }
}

} // namespace material_test
} // namespace signorini::solid
