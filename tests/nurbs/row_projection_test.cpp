// Values carried between rows: exact where the new row contains the old one, of optimal order otherwise.
#include "nurbs/row_projection.hpp"

#include "base/dense.hpp"
#include "nurbs/basis.hpp"
#include "nurbs/constants.hpp"
#include "nurbs/random_patch.hpp"
#include "nurbs/refine.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace signorini::nurbs {
namespace row_projection_test {

/// A random rational row k-refined to degree p with `elements` equal elements per direction, then elevated s times.
Row row_of(const Patch& patch, int elements, int p, int s) {
  Patch refined = patch;
  for (int d = 0; d < patch.parametric_dimension(); ++d) {
    std::vector<double> knots;
    for (int i = 1; i < elements; ++i) knots.push_back(static_cast<double>(i) / elements);
    refined = elevate(k_refine(refined, d, p, knots), d, s);
  }
  return make_row(refined);
}

/// A curve or surface of one linear element with positive weights.
Patch rational(test::Random& random, int dimensions) {
  const KnotVector line(1, {0, 0, 1, 1});
  const int count = dimensions == 1 ? 2 : 4;
  MatrixX points(dimensions + 1, count);
  VectorX weights(count);
  for (int a = 0; a < count; ++a) {
    points(0, a) = a % 2;
    points(1, a) = dimensions == 1 ? test::uniform(random, -0.3, 0.3) : a / 2;
    if (dimensions == 2) points(2, a) = test::uniform(random, -0.3, 0.3);
    weights(a) = test::uniform(random, 0.6, 1.6);
  }
  return make_patch(std::vector<KnotVector>(dimensions, line), points, weights);
}

/// The field of a row with these values at its control points.
VectorX field(const Row& row, const MatrixX& values, const VectorX& xi) {
  MatrixX homogeneous(row.dimension() + 1, row.functions());
  homogeneous.setZero();
  homogeneous.topRows(values.rows()) = values.array().rowwise() * row.weights().transpose().array();
  homogeneous.bottomRows(1) = row.weights().transpose();
  return evaluate(Row(row.directions(), homogeneous), xi).head(values.rows());
}

TEST(RowProjection, IsExactInASpaceThatContainsTheOldOne) {
  test::Random random(3);
  for (const int dimensions : {1, 2})
    for (const int p : {1, 2, 3}) {
      const Patch patch = rational(random, dimensions);
      const Row low = row_of(patch, 5, p, 0), high = row_of(patch, 5, p, 2);
      const MatrixX values = MatrixX::Random(2, low.functions());
      const MatrixX carried = project_row(low, high, values);
      ASSERT_EQ(carried.cols(), high.functions());
      for (int k = 0; k < 20; ++k) {
        const VectorX xi = test::random_parameter(random, patch);
        EXPECT_LT((field(high, carried, xi) - field(low, values, xi)).norm(), 1e-12) << dimensions << " " << p;
      }
      // and back, because the old space holds the field
      EXPECT_LT((project_row(high, low, carried) - values).norm(), 1e-11);
    }
}

TEST(RowProjection, ReproducesRigidMotionsAndEnds) {
  test::Random random(5);
  for (const int dimensions : {1, 2}) {
    const Patch patch = rational(random, dimensions);
    const Row high = row_of(patch, 6, 2, 2), low = row_of(patch, 6, 2, 0);
    // u = A X + b is in every row, since X is
    const MatrixX motion = MatrixX::Random(dimensions + 1, dimensions + 1);
    const VectorX shift = VectorX::Random(dimensions + 1);
    const auto moved = [&](const Row& row) { return MatrixX((motion * row.points()).colwise() + shift); };
    EXPECT_LT((project_row(high, low, moved(high)) - moved(low)).norm(), 1e-12);
    EXPECT_LT((project_row(low, high, moved(low)) - moved(high)).norm(), 1e-12);
    const MatrixX values = MatrixX::Random(1, high.functions()), carried = project_row(high, low, values);
    const VectorX start = VectorX::Zero(dimensions), end = VectorX::Ones(dimensions);
    for (const VectorX& corner : {start, end})
      EXPECT_NEAR(field(low, carried, corner)(0), field(high, values, corner)(0), 1e-13);
  }
}

/// sin 5X in the least-squares sense, at the control points of a row of a line.
MatrixX sine(const Row& row) {
  const int samples = 6 * row.functions();
  MatrixX functions(samples, row.functions()), right(samples, 1);
  for (int k = 0; k < samples; ++k) {
    const VectorX xi = VectorX::Constant(1, (k + 0.5) / samples);
    const int e = row.direction(0).find_element(xi(0));
    std::array<double, max_degree + 1> values{};
    basis_derivatives(row.direction(0), e, xi(0), 0, values.data());
    functions.row(k).setZero();
    double weight = 0;
    const std::span<const int> on = row.direction(0).functions_on(e);
    for (std::size_t a = 0; a < on.size(); ++a) weight += functions(k, on[a]) = values[a] * row.weights()(on[a]);
    functions.row(k) /= weight;
    right(k, 0) = std::sin(5 * evaluate(row, xi)(0));
  }
  return dense::least_squares(functions, right).transpose();
}

/// A smooth field, projected onto a row of lower degree: the error of best approximation, h^(p+1).
TEST(RowProjection, HasTheOrderOfBestApproximation) {
  test::Random random(7);
  const Patch patch = rational(random, 1);
  for (const int p : {1, 2, 3}) {
    std::vector<double> errors;
    for (const int elements : {16, 32}) {
      const Row high = row_of(patch, elements, p, 2), low = row_of(patch, elements, p, 0);
      const MatrixX start = sine(high), carried = project_row(high, low, start);
      double sum = 0;
      const int samples = 400;
      for (int k = 0; k < samples; ++k) {
        const VectorX xi = VectorX::Constant(1, (k + 0.5) / samples);
        const double difference = field(low, carried, xi)(0) - field(high, start, xi)(0);
        sum += difference * difference / samples;
      }
      errors.push_back(std::sqrt(sum));
    }
    EXPECT_NEAR(std::log2(errors[0] / errors[1]), p + 1, 0.35) << p << ": " << errors[0] << " " << errors[1];
  }
}

TEST(RowProjection, RefusesOtherElements) {
  test::Random random(9);
  const Patch patch = rational(random, 1);
  EXPECT_ERROR(projection(row_of(patch, 4, 2, 0).direction(0), row_of(patch, 5, 2, 0).direction(0)), "nurbs.row");
}

} // namespace row_projection_test
} // namespace signorini::nurbs
