// Multi-degree splines compared with B-splines, with extraction by null spaces, and with the continuity asked for.
#include "nurbs/multi_degree.hpp"

#include "nurbs/basis.hpp"
#include "nurbs/bezier.hpp"
#include "nurbs/random_patch.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace signorini::nurbs {
namespace multi_degree_test {

struct Definition {
  std::vector<double> breaks;
  std::vector<int> degrees, smoothness;
};

Space1D space_of(const Definition& given) {
  return multi_degree_space(given.breaks, given.degrees, given.smoothness);
}

/// Random degrees 1 … highest and continuities 0 … the lower degree; neighbors' lengths differ by factors up to
/// `grading`.
Definition random_definition(test::Random& random, int elements, int highest, double grading) {
  Definition result{{0}, {}, {-1}};
  for (int e = 0; e < elements; ++e) {
    result.breaks.push_back(result.breaks.back() + std::pow(grading, test::uniform(random, 0, 1)));
    result.degrees.push_back(test::integer(random, 1, highest));
    if (e > 0)
      result.smoothness.push_back(test::integer(random, 0, std::min(result.degrees[e - 1], result.degrees[e])));
  }
  result.smoothness.push_back(-1);
  return result;
}

int functions(const Definition& given) {
  int count = given.degrees.front() + 1;
  for (std::size_t i = 1; i < given.degrees.size(); ++i) count += given.degrees[i] - given.smoothness[i];
  return count;
}

/// Bernstein coefficients of all functions on all elements, one block of columns per element.
MatrixX table_of(const Space1D& space) {
  int columns = 0;
  for (int e = 0; e < space.elements(); ++e) columns += space.degree(e) + 1;
  MatrixX result = MatrixX::Zero(space.functions(), columns);
  for (int e = 0, first = 0; e < space.elements(); first += space.degree(e++) + 1) {
    const auto numbers = space.functions_on(e);
    for (std::size_t a = 0; a < numbers.size(); ++a)
      result.row(numbers[a]).segment(first, space.degree(e) + 1) = space.extraction(e).row(static_cast<int>(a));
  }
  return result;
}

/// k-th derivatives of the Bernstein polynomials at an end of an element, as coefficients.
VectorX end_derivative(int degree, double length, bool at_end, int k) {
  VectorX result = VectorX::Zero(degree + 1);
  double factor = 1;
  for (int i = 0; i < k; ++i) factor *= (degree - i) / length;
  // B^(k)(0) = p!/(p−k)! Δ^k, Δ^k = Σ_i (−1)^(k−i) C(k, i) c_i
  double binomial = 1;
  for (int i = 0; i <= k && i <= degree; ++i) {
    result(at_end ? degree - (k - i) : i) = factor * ((k - i) % 2 == 0 ? 1 : -1) * binomial;
    binomial *= (k - i) / (i + 1.0);
  }
  return result;
}

/// Jump of the k-th derivative of each function at breakpoint b.
VectorX jump(const MatrixX& table, const Definition& given, std::size_t b, int k) {
  int first = 0;
  for (std::size_t e = 0; e + 1 < b; ++e) first += given.degrees[e] + 1;
  const int left = given.degrees[b - 1], right = given.degrees[b];
  const auto length = [&](std::size_t e) { return given.breaks[e + 1] - given.breaks[e]; };
  return table.middleCols(first, left + 1) * end_derivative(left, length(b - 1), true, k) -
         table.middleCols(first + left + 1, right + 1) * end_derivative(right, length(b), false, k);
}

/// The same functions by null spaces (H. Speleers, ACM TOMS 45, 2019, Algorithm 999): for each breakpoint and each
/// derivative that must be continuous, H ← N H with N v = 0 for its jumps v = H·jump.
MatrixX by_null_spaces(const Definition& given) {
  const int columns =
      std::accumulate(given.degrees.begin(), given.degrees.end(), 0) + static_cast<int>(given.degrees.size());
  MatrixX H = MatrixX::Identity(columns, columns);
  for (std::size_t b = 1; b < given.degrees.size(); ++b)
    for (int k = 0; k <= given.smoothness[b]; ++k) {
      const VectorX v = jump(H, given, b, k);
      int from = 0, to = static_cast<int>(v.size()) - 1;
      const double least = 1e-9 * v.cwiseAbs().maxCoeff();
      while (std::abs(v(from)) < least) ++from;
      while (std::abs(v(to)) < least) --to;
      MatrixX N = MatrixX::Zero(v.size() - 1, v.size());
      for (int i = 0; i <= from; ++i) N(i, i) = 1;
      for (int l = from; l < to; ++l) {
        N(l, l + 1) = -v(l) / v(l + 1) * N(l, l);
        if (l + 1 < to) N(l + 1, l + 1) = 1 - N(l, l + 1);
      }
      for (int i = to + 1; i < v.size(); ++i) N(i - 1, i) = 1;
      H = (N * H).eval();
    }
  return H;
}

TEST(MultiDegree, OneDegreeGivesBSplines) {
  test::Random random(31);
  for (int degree = 1; degree <= 7; ++degree)
    for (int trial = 0; trial < 10; ++trial) {
      const Space1D spline = spline_space(test::random_knots(random, degree, 6));
      const Space1D space =
          multi_degree_space(spline.breaks(), std::vector<int>(spline.elements(), degree), spline.smoothness());
      EXPECT_EQ(space.functions(), spline.functions());
      EXPECT_LT((table_of(space) - table_of(spline)).cwiseAbs().maxCoeff(), 4e-15) << degree;
      EXPECT_EQ(space.smoothness(), spline.smoothness());
    }
}

TEST(MultiDegree, AgreesWithNullSpaces) {
  test::Random random(32);
  for (int trial = 0; trial < 200; ++trial) {
    const Definition given = random_definition(random, test::integer(random, 1, 7), 5, 3);
    const MatrixX table = table_of(space_of(given)), other = by_null_spaces(given);
    ASSERT_EQ(table.rows(), functions(given)) << trial;
    ASSERT_EQ(other.rows(), table.rows()) << trial;
    EXPECT_LT((table - other).cwiseAbs().maxCoeff(), 1e-9) << trial;
  }
}

/// Non-negative, sum 1, continuous to rounding of the derivatives: hundreds of elements whose lengths differ by 1e4.
TEST(MultiDegree, ManyGradedElements) {
  test::Random random(33);
  for (int trial = 0; trial < 6; ++trial) {
    const Definition given = random_definition(random, 300, trial < 3 ? 4 : 8, trial % 3 == 0 ? 1 : 1e4);
    const Space1D space = space_of(given);
    const MatrixX table = table_of(space);
    EXPECT_EQ(space.functions(), functions(given));
    EXPECT_GE(table.minCoeff(), 0);
    EXPECT_LT((table.colwise().sum().array() - 1).abs().maxCoeff(), 2e-15);
    for (std::size_t b = 1; b < given.degrees.size(); ++b)
      for (int k = 0; k <= given.smoothness[b]; ++k) {
        // Relative to the derivative of values of 1 on the shorter element
        const double left =
            end_derivative(given.degrees[b - 1], given.breaks[b] - given.breaks[b - 1], true, k).lpNorm<1>();
        const double right =
            end_derivative(given.degrees[b], given.breaks[b + 1] - given.breaks[b], false, k).lpNorm<1>();
        EXPECT_LT(jump(table, given, b, k).cwiseAbs().maxCoeff(), 2e-14 * std::max(left, right)) << b << " " << k;
      }
  }
}

/// The example of Beccari, Casciola and Morigi's section 2: functions have the least support that continuity allows.
TEST(MultiDegree, SupportIsLocal) {
  const Space1D space = multi_degree_space({0, 1, 2, 3, 4}, {2, 2, 4, 2}, {-1, 1, 1, 1, -1});
  EXPECT_EQ(space.functions(), 3 + 1 + 3 + 1);
  EXPECT_EQ(space.functions_on(1).front(), 1);
  EXPECT_EQ(space.functions_on(2).front(), 2);
  EXPECT_EQ(space.functions_on(2).size(), 5u);
  EXPECT_EQ(space.functions_on(3).front(), 5);
  EXPECT_FALSE(space.knots());
}

/// Splines of one degree on the same breakpoints and coarser ones are contained in finer spaces.
TEST(MultiDegree, RepresentsCoarserSpaces) {
  test::Random random(34);
  double largest = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const int p = test::integer(random, 1, 3);
    const Space1D coarse = spline_space(test::random_knots(random, p, 2));
    Definition fine{{}, {}, {}};
    for (int e = 0; e < coarse.elements(); ++e) {
      const auto [from, to] = coarse.interval(e);
      fine.breaks.push_back(from);
      fine.smoothness.push_back(coarse.smoothness()[e]);
      for (int i = test::integer(random, 0, 3); i > 0; --i) {
        fine.breaks.push_back(fine.breaks.back() + (to - fine.breaks.back()) * test::uniform(random, 0.01, 0.9));
        fine.smoothness.push_back(p); // lowered below
      }
    }
    fine.breaks.push_back(coarse.last());
    for (std::size_t e = 0; e + 1 < fine.breaks.size(); ++e) fine.degrees.push_back(p + test::integer(random, 0, 2));
    for (std::size_t b = 1; b < fine.degrees.size(); ++b)
      fine.smoothness[b] =
          std::min(fine.smoothness[b], std::min(fine.degrees[b - 1], fine.degrees[b]) - test::integer(random, 0, 1));
    fine.smoothness.push_back(-1);
    const Space1D space = space_of(fine);
    const MatrixX m = representation(coarse, space);
    largest = std::max(largest, -m.minCoeff());
    for (int n = 0; n < 10; ++n) {
      const double xi = test::uniform(random, space.first(), space.last());
      const auto values = [&](const Space1D& of) {
        const int e = of.find_element(xi);
        const auto numbers = of.functions_on(e);
        VectorX local(static_cast<Eigen::Index>(numbers.size())), all = VectorX::Zero(of.functions());
        basis_derivatives(of, e, xi, 0, local.data());
        for (std::size_t a = 0; a < numbers.size(); ++a) all(numbers[a]) = local(static_cast<int>(a));
        return all;
      };
      EXPECT_LT((m.transpose() * values(space) - values(coarse)).cwiseAbs().maxCoeff(), 1e-13) << trial;
    }
  }
  EXPECT_LT(largest, 1e-13) << "refinement combines with factors that are not negative, so weights remain positive";
}

TEST(MultiDegree, RejectsWrongLists) {
  EXPECT_ERROR(multi_degree_space({0, 1, 2}, {2}, {-1, 1, -1}), "nurbs.space.breakpoints");
  EXPECT_ERROR(multi_degree_space({0, 1, 2}, {2, 3}, {-1, 3, -1}),
               "nurbs.space.smoothness: breakpoint = 1, smoothness = 3, degree = 2");
  EXPECT_ERROR(multi_degree_space({0, 1, 2}, {2, 3}, {-1, -2, -1}), "nurbs.space.smoothness");
  EXPECT_ERROR(multi_degree_space({0, 1, 2}, {2, 16}, {-1, 1, -1}), "nurbs.space.degree");
}

} // namespace multi_degree_test
} // namespace signorini::nurbs
