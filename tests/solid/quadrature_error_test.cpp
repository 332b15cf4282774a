// Errors of volumes and areas by Gauss points, against closed forms.

#include "nurbs/plan.hpp"
#include "solid/material.hpp"
#include "solid/neo_hookean.hpp"
#include "solid/quadrature.hpp"
#include "solid/quadrature_error.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace signorini::solid {
namespace quadrature_error_test {

/// A rectangle of width 1 whose control points at its right end have the weight w.
nurbs::Discretization rectangle(double w, int elements) {
  const nurbs::Patch patch =
      nurbs::make_patch({nurbs::KnotVector::single(1), nurbs::KnotVector::single(1)},
                        (MatrixX(2, 4) << 0, 1, 0, 1, 0, 0, 1, 1).finished(), (VectorX(4) << 1, w, 1, w).finished());
  return {patch, nurbs::test::plan_of({elements, 1}, "north", "N1")};
}

/// x = w ξ/W with W = 1 − ξ + w ξ, hence dx/dξ = w/W², and the area is ∫ w/W² dξ = 1.
double error_of(double w, int points) {
  const QuadratureRule rule = gauss_legendre(points, 0, 1);
  double area = 0;
  for (std::size_t q = 0; q < rule.points.size(); ++q) {
    const double weight = 1 - rule.points[q] + w * rule.points[q];
    area += rule.weights[q] * w / (weight * weight);
  }
  return area - 1;
}

TEST(VolumeError, IsThatOfTheGaussPoints) {
  for (const double w : {3.0, 10.0, 50.0, 0.02}) {
    const nurbs::Discretization space = rectangle(w, 1);
    EXPECT_NEAR(weight_ratio(space), std::max(w, 1 / w), 1e-12);
    EXPECT_NEAR(volume_error(space), std::abs((1 + error_of(w, 2)) / (1 + error_of(w, 4)) - 1), 1e-12) << w;
  }
  EXPECT_GT(volume_error(rectangle(50, 1)), 0.3);
  EXPECT_EQ(weight_ratio(rectangle(1, 2)), 1);
  EXPECT_LT(volume_error(rectangle(1, 2)), 1e-14);
}

TEST(VolumeError, FallsWithRefinement) {
  // Two points per direction: of fourth order
  const double coarse = volume_error(rectangle(5, 8)), fine = volume_error(rectangle(5, 16));
  EXPECT_GT(fine, 0);
  EXPECT_GT(std::log2(coarse / fine), 3.7);
}

/// A block on a parabola, whose length is ∫ √(1 + y′²) dx.
TEST(AreaError, IsThatOfTheGaussPoints) {
  for (const double height : {0.5, 40.0}) {
    // South side: control points (0, 0), (0.5, −h), (1, 0), that is y = −2 h ξ (1 − ξ), y′ = −2 h (1 − 2 ξ)
    const nurbs::Patch patch =
        nurbs::make_patch({nurbs::KnotVector::single(2), nurbs::KnotVector::single(1)},
                          (MatrixX(2, 6) << 0, 0.5, 1, 0, 0.5, 1, 0, -height, 0, 1, 1, 1).finished());
    const Body<2> body(
        std::make_shared<const nurbs::Discretization>(patch, nurbs::test::plan_of({1, 1}, "north", "N2")),
        neo_hookean(1, 0.3), Kind::plane_strain);
    const auto length = [&](int points) {
      const QuadratureRule rule = gauss_legendre(points, 0, 1);
      double sum = 0;
      for (std::size_t q = 0; q < rule.points.size(); ++q)
        sum += rule.weights[q] * std::hypot(1, 2 * height * (1 - 2 * rule.points[q]));
      return sum;
    };
    const double error = area_error(body, {nurbs::side_of("south", 2)});
    const double expected = std::abs(length(6) / length(12) - 1);
    if (height > 1) {
      EXPECT_NEAR(error, expected, 1e-12);
      EXPECT_GT(error, 0.01);
    } else { // nearly straight: not examined
      EXPECT_LT(expected, 1e-5);
      EXPECT_EQ(error, 0);
    }
    EXPECT_EQ(area_error(body, {nurbs::side_of("west", 2), nurbs::side_of("east", 2)}), 0);
  }
}

} // namespace quadrature_error_test
} // namespace signorini::solid
