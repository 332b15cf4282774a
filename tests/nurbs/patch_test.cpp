#include "nurbs/patch.hpp"

#include "random_patch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace signorini::nurbs {
namespace patch_test {

using namespace test;

/// Quarter of the unit circle, x² + y² = 1.
Patch quarter_circle() {
  MatrixX points(2, 3);
  points << 1, 1, 0, 0, 1, 1;
  return make_patch({KnotVector::single(2)}, points, Eigen::Vector3d(1, std::sqrt(0.5), 1));
}

Patch bilinear_square() {
  MatrixX points(2, 4);
  points << 0, 1, 0, 1, 0, 0, 1, 1;
  return make_patch({KnotVector::single(1), KnotVector::single(1)}, points);
}

VectorX parameters(std::initializer_list<double> values) {
  return Eigen::Map<const VectorX>(values.begin(), static_cast<int>(values.size()));
}

TEST(Patch, ReturnsPointsAndWeights) {
  const Patch arc = quarter_circle();
  EXPECT_EQ(arc.parametric_dimension(), 1);
  EXPECT_EQ(arc.dimension(), 2);
  EXPECT_EQ(arc.functions(), 3);
  EXPECT_DOUBLE_EQ(arc.homogeneous()(0, 1), std::sqrt(0.5));
  EXPECT_DOUBLE_EQ(arc.points()(1, 1), 1);
  EXPECT_DOUBLE_EQ(arc.weights()(1), std::sqrt(0.5));
}

TEST(Patch, InvalidOnesAreRejectedWithTheReason) {
  const KnotVector line = KnotVector::single(1);
  EXPECT_ERROR(make_patch({}, MatrixX::Zero(2, 1)), "nurbs.patch.directions: count = 0");
  EXPECT_ERROR(make_patch({line, line, line, line}, MatrixX::Zero(3, 16)), "nurbs.patch.directions: count = 4");
  EXPECT_ERROR(make_patch({line}, MatrixX::Zero(1, 2)), "nurbs.patch.coordinates: count = 1");
  EXPECT_ERROR(make_patch({line, line, line}, MatrixX::Zero(2, 8)),
               "nurbs.patch.dimension: directions = 3, dimension = 2");
  EXPECT_ERROR(make_patch({KnotVector::single(0)}, MatrixX::Zero(2, 1)), "nurbs.patch.degree");
  EXPECT_ERROR(make_patch({line, KnotVector::single(2)}, MatrixX::Zero(2, 5)),
               "nurbs.patch.points: expected = 6, factors = (2, 3), count = 5");
  EXPECT_ERROR(make_patch({line}, MatrixX::Zero(2, 2), VectorX::Ones(3)), "nurbs.patch.weights: points = 2, count = 3");
  EXPECT_ERROR(make_patch({line}, MatrixX::Zero(2, 2), Eigen::Vector2d(1, 0)),
               "nurbs.patch.weight: number = 1, weight = 0");
  EXPECT_ERROR(make_patch({line}, MatrixX::Zero(2, 2), Eigen::Vector2d(-1, 1)),
               "nurbs.patch.weight: number = 0, weight = -1");
  EXPECT_ERROR(make_patch({line}, MatrixX::Zero(2, 2), Eigen::Vector2d(std::nan(""), 1)), "nurbs.patch.weight");
  MatrixX points = MatrixX::Zero(2, 2);
  points(0, 1) = std::numeric_limits<double>::infinity();
  EXPECT_ERROR(make_patch({line}, points), "nurbs.patch.point: number = 1");
}

TEST(Patch, EvaluatesTheCircleExactly) {
  const Patch arc = quarter_circle();
  for (double xi = 0; xi <= 1; xi += 0.125) EXPECT_NEAR(evaluate(arc, parameters({xi})).norm(), 1, 1e-15);
  EXPECT_NEAR(evaluate(arc, parameters({0.5}))(0), std::sqrt(0.5), 1e-15);
}

TEST(Patch, ParametersOutsideAreRejected) {
  const Patch square = bilinear_square();
  EXPECT_ERROR(evaluate(square, parameters({0.5})), "nurbs.patch.parameters: expected = 2, count = 1");
  EXPECT_ERROR(evaluate(square, parameters({0.5, 1.5})), "nurbs.knots.outside: xi = 1.5, first = 0, last = 1");
  EXPECT_ERROR(derivatives(square, parameters({-0.1, 0.5}), 1), "nurbs.knots.outside: xi = -0.1, first = 0, last = 1");
  EXPECT_ERROR(derivatives(square, parameters({0, 0}), -1), "nurbs.patch.derivative: order = -1, most = 17");
  EXPECT_ERROR(derivatives(square, parameters({0, 0}), 1000), "nurbs.patch.derivative: order = 1000, most = 17");
  EXPECT_ERROR(rational_basis(square, parameters({0.1, std::nan("")})), "nurbs.knots.outside");
}

TEST(Patch, AgreesWithTheRecursionOfTheNurbsBook) {
  Random random(3);
  for (int run = 0; run < 30; ++run) {
    const int parametric = 1 + run % 3;
    const Patch patch = random_patch(random, parametric, std::max(parametric, 2 + run % 2), 3);
    const VectorX xi = random_parameter(random, patch);
    VectorX sum = VectorX::Zero(patch.dimension() + 1);
    for (int a = 0; a < patch.functions(); ++a) {
      double value = 1;
      for (int d = 0, rest = a; d < parametric; ++d) {
        const KnotVector& knots = patch.direction(d);
        value *= cox_de_boor(knots, rest % knots.functions(), knots.degree(), xi(d));
        rest /= knots.functions();
      }
      sum += value * patch.homogeneous().col(a);
    }
    const VectorX expected = sum.head(patch.dimension()) / sum(patch.dimension());
    EXPECT_LT((evaluate(patch, xi) - expected).norm(), 1e-13);
  }
}

TEST(Patch, RationalBasisSumsUpToOneAndGivesThePoint) {
  Random random(4);
  for (int run = 0; run < 30; ++run) {
    const Patch patch = random_patch(random, 1 + run % 3, 3);
    const VectorX xi = random_parameter(random, patch);
    const MatrixX points = patch.points();
    double sum = 0;
    VectorX x = VectorX::Zero(3);
    int previous = -1;
    for (const BasisValue& basis : rational_basis(patch, xi)) {
      EXPECT_GT(basis.function, previous);
      EXPECT_GE(basis.value, 0);
      previous = basis.function;
      sum += basis.value;
      x += basis.value * points.col(basis.function);
    }
    EXPECT_NEAR(sum, 1, 1e-14);
    EXPECT_LT((x - evaluate(patch, xi)).norm(), 1e-14);
  }
}

TEST(Derivatives, AreSortedByTotalOrderThenDecreasingInTheFirstDirection) {
  const auto orders = [](const Patch& patch, int n) {
    std::vector<std::vector<int>> result;
    for (const auto& derivative : derivatives(patch, VectorX::Constant(patch.parametric_dimension(), 0.5), n))
      result.push_back(derivative.orders);
    return result;
  };
  using Orders = std::vector<std::vector<int>>;
  EXPECT_EQ(orders(quarter_circle(), 3), (Orders{{0}, {1}, {2}, {3}}));
  EXPECT_EQ(orders(bilinear_square(), 2), (Orders{{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}}));
  Random random(5);
  const Patch volume = random_patch(random, 3, 3, 2);
  EXPECT_EQ(orders(volume, 2), (Orders{{0, 0, 0},
                                       {1, 0, 0},
                                       {0, 1, 0},
                                       {0, 0, 1},
                                       {2, 0, 0},
                                       {1, 1, 0},
                                       {1, 0, 1},
                                       {0, 2, 0},
                                       {0, 1, 1},
                                       {0, 0, 2}}));
}

TEST(Derivatives, OfTheCircleInClosedForm) {
  // With a = 1−ξ, s = √2: x = (a² + s a ξ)/w, y = (ξ² + s a ξ)/w, w = a² + s a ξ + ξ²; all are quadratics
  // c0 + c1 ξ + c2 ξ², so (f w)^(k) = Σ C(k,i) w^(i) f^(k−i) gives f, f′, f″ in closed form.
  const double s = std::sqrt(2.0);
  for (double xi : {0.0, 0.3, 0.5, 0.9, 1.0}) {
    const double w = 1 + (s - 2) * xi + (2 - s) * xi * xi, dw = s - 2 + 2 * (2 - s) * xi, ddw = 2 * (2 - s);
    const Eigen::Vector2d n(1 + (s - 2) * xi + (1 - s) * xi * xi, s * xi + (1 - s) * xi * xi);
    const Eigen::Vector2d dn(s - 2 + 2 * (1 - s) * xi, s + 2 * (1 - s) * xi), ddn(2 * (1 - s), 2 * (1 - s));
    const Eigen::Vector2d f = n / w, df = (dn - dw * f) / w, ddf = (ddn - 2 * dw * df - ddw * f) / w;
    const auto all = derivatives(quarter_circle(), parameters({xi}), 2);
    EXPECT_LT((all[0].value - f).norm(), 1e-14);
    EXPECT_LT((all[1].value - df).norm(), 1e-14);
    EXPECT_LT((all[2].value - ddf).norm(), 1e-13);
    // Curvature of the unit circle: det(x′, x″)/|x′|³ = 1
    const double area = all[1].value(0) * all[2].value(1) - all[1].value(1) * all[2].value(0);
    EXPECT_NEAR(area / std::pow(all[1].value.norm(), 3), 1, 1e-13);
  }
}

TEST(Derivatives, AgreeWithFiniteDifferencesOfTheOrderBelow) {
  Random random(6);
  const double h = 1e-5;
  for (int run = 0; run < 30; ++run) {
    const Patch patch = random_patch(random, 1 + run % 3, 3, 3);
    VectorX xi = random_parameter(random, patch);
    // Away from knots, so that both points are in one element.
    for (int d = 0; d < xi.size(); ++d) {
      const auto& breaks = patch.direction(d).breaks();
      const std::size_t e = static_cast<std::size_t>(patch.direction(d).find_element(xi(d)));
      xi(d) = breaks[e] + (breaks[e + 1] - breaks[e]) * uniform(random, 0.2, 0.8);
    }
    const auto all = derivatives(patch, xi, 3);
    double scale = 1;
    for (const auto& derivative : all) scale = std::max(scale, derivative.value.norm());
    for (int d = 0; d < xi.size(); ++d) {
      VectorX left = xi, right = xi;
      left(d) -= h;
      right(d) += h;
      const auto before = derivatives(patch, left, 2), after = derivatives(patch, right, 2);
      for (std::size_t i = 0; i < before.size(); ++i) {
        std::vector<int> orders = before[i].orders;
        ++orders[d];
        const auto found = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.orders == orders; });
        ASSERT_NE(found, all.end());
        EXPECT_LT((found->value - (after[i].value - before[i].value) / (2 * h)).norm(), 1e-6 * scale);
      }
    }
  }
}

TEST(Sides, HaveNamesByDimension) {
  EXPECT_EQ(side_of("west", 1), (Side{0, false}));
  EXPECT_EQ(side_of("east", 2), (Side{0, true}));
  EXPECT_EQ(side_of("south", 2), (Side{1, false}));
  EXPECT_EQ(side_of("north", 3), (Side{1, true}));
  EXPECT_EQ(side_of("front", 3), (Side{2, false}));
  EXPECT_EQ(side_of("back", 3), (Side{2, true}));
  for (const char* name : {"west", "east", "south", "north", "front", "back"})
    EXPECT_EQ(name_of(side_of(name, 3)), name);
}

TEST(Sides, ErrorsForUnknownNamesListTheValidOnes) {
  EXPECT_ERROR(side_of("nort", 2), "nurbs.face.unknown: face = nort, suggestion = (nurbs.face.did_you_mean: face = "
                                   "north), known = (west, east, south, north), ends = (xi1, xi2)");
  EXPECT_ERROR(side_of("back", 2), "west, east, south, north");
  EXPECT_ERROR(side_of("Front", 3), "nurbs.face.unknown: face = Front, suggestion = (nurbs.face.did_you_mean: face = "
                                    "front), known = (west, east, south, north, front, back), ends = (xi1, xi2, xi3)");
  EXPECT_ERROR(side_of("", 1), "nurbs.face.unknown: face = , suggestion = (), known = (west, east), ends = (xi1)");
  EXPECT_ERROR(side_of("west", 4), "nurbs.patch.directions: count = 4");
}

TEST(Sides, FacesAreTheMapAtTheEnds) {
  Random random(7);
  for (int run = 0; run < 10; ++run) {
    const int parametric = 2 + run % 2;
    const Patch patch = random_patch(random, parametric, 3);
    for (int d = 0; d < parametric; ++d)
      for (bool at_end : {false, true}) {
        const Patch side = face(patch, {d, at_end});
        ASSERT_EQ(side.parametric_dimension(), parametric - 1);
        VectorX xi = random_parameter(random, patch), along(parametric - 1);
        xi(d) = at_end ? patch.direction(d).last() : patch.direction(d).first();
        for (int k = 0, a = 0; k < parametric; ++k)
          if (k != d) along(a++) = xi(k);
        EXPECT_LT((evaluate(side, along) - evaluate(patch, xi)).norm(), 1e-13);
      }
  }
}

TEST(Sides, NonexistentRowsAndFacesAreRejected) {
  const Patch square = bilinear_square();
  EXPECT_ERROR(face(quarter_circle(), {0, false}), "nurbs.face.curve");
  EXPECT_ERROR(face(square, {2, false}), "nurbs.face.direction: direction = 2, count = 2");
  EXPECT_ERROR(control_row(square, 1, 2), "nurbs.row.number: row = 2, count = 2");
  EXPECT_ERROR(control_row(square, -1, 0), "nurbs.row.direction: direction = -1, count = 2");
  EXPECT_EQ(control_row(square, 0, 1).points(), (MatrixX(2, 2) << 1, 1, 0, 1).finished());
}

} // namespace patch_test
} // namespace signorini::nurbs
