#include "solid/linear_elastic.hpp"
#include "solid/neo_hookean.hpp"

#include "differences.hpp"
#include "nurbs/random_patch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace signorini::solid {
namespace material_test {

using nurbs::test::Random;
using nurbs::test::uniform;

/// A deformation gradient with J in [0.3, 3].
Mat<3> random_deformation(Random& random) {
  for (;;) {
    Mat<3> f = Mat<3>::Identity();
    for (double& entry : f.reshaped()) entry += uniform(random, -0.8, 0.8);
    if (f.determinant() > 0.3 && f.determinant() < 3) return f;
  }
}

template <class Make> void stress_and_moduli_are_derivatives(Make make) {
  Random random(1);
  for (int trial = 0; trial < 100; ++trial) {
    const auto law = make(uniform(random, 0.1, 10), uniform(random, -0.5, 0.49));
    const Material material = law;
    const Mat<3> f = random_deformation(random), p = material.stress(f);
    const Moduli moduli = law.moduli(f);
    const double scale = p.norm() + law.mu;
    for (int entry = 0; entry < 9; ++entry) {
      const int i = entry / 3, k = entry % 3;
      const auto moved = [&](double h) {
        Mat<3> result = f;
        result(i, k) += h;
        return result;
      };
      const auto energy = [&](double h) { return material.energy(moved(h)); };
      const auto stress = [&](double h) { return material.stress(moved(h)); };
      EXPECT_NEAR(signorini::test::derivative<double>(energy, 1e-3), p(i, k), 1e-8 * scale);
      const Mat<3> slope = signorini::test::derivative<Mat<3>>(stress, 1e-3).transpose();
      EXPECT_LT((slope.reshaped() - moduli.col(entry)).norm(), 1e-7 * moduli.norm());
    }
    EXPECT_LT((moduli - moduli.transpose()).norm(), 1e-14 * moduli.norm());
    // σ = P Fᵀ/J; σ = P at small strains
    const Mat<3> pushed = material.linear() ? p : Mat<3>(p * f.transpose() / f.determinant());
    EXPECT_LT((material.cauchy_stress(f) - pushed).norm(), 1e-13 * (1 + pushed.norm()));
  }
}

TEST(Material, StressAndModuliAreDerivatives) {
  stress_and_moduli_are_derivatives(neo_hookean);
  stress_and_moduli_are_derivatives(linear_elastic);
}

/// σ = (λ/J) ln J I + (μ/J)(F Fᵀ − I); plane strain has σ₃₃ = (λ/J) ln J.
TEST(Material, CauchyStressOfNeoHookeHasItsClosedForm) {
  Random random(2);
  const NeoHookean rubber = neo_hookean(2, 0.3);
  for (int trial = 0; trial < 20; ++trial) {
    const Mat<3> space = random_deformation(random);
    for (const Mat<3>& f : {space, in_space<2>(space.topLeftCorner<2, 2>())}) {
      const double j = f.determinant();
      if (!(j > 0.1)) continue;
      const Mat<3> expected = rubber.lambda * std::log(j) / j * Mat<3>::Identity() +
                              rubber.mu / j * (f * f.transpose() - Mat<3>::Identity());
      EXPECT_LT((Material(rubber).cauchy_stress(f) - expected).norm(), 1e-13 * (1 + expected.norm()));
    }
  }
}

TEST(Material, PlaneStrainOfLinearElasticityHasOutOfPlaneStress) {
  const LinearElastic steel = linear_elastic(2, 0.3);
  const Mat<2> plane = Vec<2>(1.2, 0.7).asDiagonal();
  EXPECT_NEAR(Material(steel).cauchy_stress(in_space<2>(plane))(2, 2), steel.lambda * (plane.trace() - 2), 1e-15);
}

TEST(Material, SmallStrainsFollowHooke) {
  const NeoHookean material = neo_hookean(3, 0.25);
  EXPECT_DOUBLE_EQ(material.mu, 1.2);
  EXPECT_DOUBLE_EQ(material.lambda, 1.2);
  Mat<3> strain;
  strain << 2, 0.5, -1, 0.5, -1, 0.3, -1, 0.3, 0.7;
  strain *= 1e-7;
  // σ = λ tr ε I + 2 μ ε
  const Mat<3> hooke = material.lambda * strain.trace() * Mat<3>::Identity() + 2 * material.mu * strain;
  EXPECT_NEAR((Material(material).cauchy_stress(Mat<3>::Identity() + strain) - hooke).norm(), 0, 1e-12);
  EXPECT_NEAR((linear_elastic(3, 0.25).stress(Mat<3>::Identity() + strain) - hooke).norm(), 0, 1e-15);
}

TEST(Material, ErrorsNameTheConstant) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (double modulus : {0.0, -1.0, nan, infinity}) {
    EXPECT_ERROR(neo_hookean(modulus, 0.3), "solid.material.youngs_modulus");
    EXPECT_ERROR(linear_elastic(modulus, 0.3), "solid.material.youngs_modulus");
  }
  for (double ratio : {0.5, 0.7, -1.0, nan}) {
    EXPECT_ERROR(neo_hookean(1, ratio), "solid.material.poissons_ratio");
    EXPECT_ERROR(linear_elastic(1, ratio), "solid.material.poissons_ratio");
  }
}

} // namespace material_test
} // namespace signorini::solid
