// Line search on functions with known Newton moves, and inside the loop where plain Newton fails.
#include "solve/newton.hpp"

#include "base/dense.hpp"
#include "base/eigen.hpp"
#include "base/error.hpp"
#include "text_of.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace signorini::solve {
namespace line_search_test {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// f(x) = 0 in several unknowns; states in which f is not finite are invalid.
struct Problem : NewtonProblem {
  std::function<VectorX(const VectorX&)> f;
  std::function<MatrixX(const VectorX&)> slope;
  VectorX x, before, move;
  std::vector<double> evaluated; ///< fractions that a search has evaluated

  Problem(std::function<VectorX(const VectorX&)> function, std::function<MatrixX(const VectorX&)> derivative,
          VectorX start)
      : f(std::move(function)), slope(std::move(derivative)), x(std::move(start)) {}

  NewtonReport solve(LineSearchKind kind, int iterations = 25) {
    NewtonReport report;
    while (iterate(*this, {1e-12, iterations, kind}, false, report)) {
    }
    return report;
  }
  Outcome evaluate(bool, Message& why) override {
    why = Message("test.no_state");
    return f(x).allFinite() ? Outcome::converged : Outcome::inverted_element;
  }
  double residual() const override { return f(x).norm(); }
  double scale() const override { return 1; }
  double floor() const override { return 1e-15; }
  std::optional<double> advance() override {
    before = x;
    move = -dense::solve(slope(x), f(x));
    x += move;
    return f(before).dot(move);
  }
  Trial retreat(double part, bool /*tangent*/) override {
    evaluated.push_back(part);
    x = before + part * move;
    const VectorX residual = f(x);
    return residual.allFinite() ? Trial{residual.norm(), residual.dot(move)} : Trial{infinity, infinity};
  }
};

Problem scalar(double (*f)(double), double (*slope)(double), double start) {
  return {[f](const VectorX& x) { return VectorX::Constant(1, f(x(0))); },
          [slope](const VectorX& x) { return MatrixX::Constant(1, 1, slope(x(0))); }, VectorX::Constant(1, start)};
}

Problem arctan_from(double start) {
  return scalar([](double x) { return std::atan(x); }, [](double x) { return 1 / (1 + x * x); }, start);
}

/// Odd, convex on either side: from ±a Newton's method alternates between ∓a and ±a forever. f = x³ − 5x, f′ = 3x² − 5:
/// x − f/f′ = 2x³/(3x² − 5) = −x for 5x² = 5.
Problem two_cycle() {
  return scalar([](double x) { return x * x * x - 5 * x; }, [](double x) { return 3 * x * x - 5; }, 1);
}

TEST(LineSearch, AcceptsTheWholeMoveIfItIsGood) {
  for (LineSearchKind kind : {LineSearchKind::residual, LineSearchKind::energy}) {
    Problem plain = arctan_from(0.5), searched = arctan_from(0.5);
    const NewtonReport without = plain.solve(LineSearchKind::none), with = searched.solve(kind);
    EXPECT_EQ(with.outcome, Outcome::converged);
    EXPECT_EQ(with.residuals, without.residuals); // bitwise
    EXPECT_EQ(with.parts, std::vector<double>(static_cast<std::size_t>(with.iterations), 1));
    EXPECT_EQ(searched.evaluated.size() + 1, with.parts.size()); // the last move is not searched
    EXPECT_TRUE(without.parts.empty());
  }
}

TEST(LineSearch, ShortensMovesThatOvershoot) {
  EXPECT_NE(arctan_from(3).solve(LineSearchKind::none).outcome, Outcome::converged);
  for (LineSearchKind kind : {LineSearchKind::residual, LineSearchKind::energy}) {
    Problem problem = arctan_from(3);
    const NewtonReport report = problem.solve(kind);
    EXPECT_EQ(report.outcome, Outcome::converged);
    EXPECT_LT(report.iterations, 10);
    EXPECT_NEAR(problem.x(0), 0, 1e-12);
    EXPECT_LT(report.parts.front(), 1);
    EXPECT_EQ(report.parts.back(), 1); // plain Newton at the end
    for (std::size_t k = 1; k < report.residuals.size(); ++k) EXPECT_LT(report.residuals[k], report.residuals[k - 1]);
  }
}

TEST(LineSearch, ShortensMovesInSeveralUnknowns) {
  // A rotated pair of arctan functions, weights 1 and 4
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(0.7).toRotationMatrix();
  const auto f = [turn](const VectorX& x) {
    const Eigen::Vector2d y = turn * x;
    return VectorX(turn.transpose() * Eigen::Vector2d(std::atan(y(0)), 4 * std::atan(y(1))));
  };
  const auto slope = [turn](const VectorX& x) {
    const Eigen::Vector2d y = turn * x;
    const Eigen::Vector2d d(1 / (1 + y(0) * y(0)), 4 / (1 + y(1) * y(1)));
    return MatrixX(turn.transpose() * d.asDiagonal() * turn);
  };
  EXPECT_NE((Problem{f, slope, Eigen::Vector2d(3, -2.5)}.solve(LineSearchKind::none).outcome), Outcome::converged);
  for (LineSearchKind kind : {LineSearchKind::residual, LineSearchKind::energy}) {
    Problem problem{f, slope, Eigen::Vector2d(3, -2.5)};
    EXPECT_EQ(problem.solve(kind).outcome, Outcome::converged);
    EXPECT_LT(problem.x.norm(), 1e-12);
  }
}

TEST(LineSearch, AvoidsInvalidStates) {
  // ln x from x = 4: Newton's first move leads to 4 − 4 ln 4 < 0.
  const auto f = [](double x) { return x > 0 ? std::log(x) : std::numeric_limits<double>::quiet_NaN(); };
  const auto slope = [](double x) { return 1 / x; };
  EXPECT_EQ(scalar(f, slope, 4).solve(LineSearchKind::none).outcome, Outcome::inverted_element);
  for (LineSearchKind kind : {LineSearchKind::residual, LineSearchKind::energy}) {
    Problem problem = scalar(f, slope, 4);
    EXPECT_EQ(problem.solve(kind).outcome, Outcome::converged);
    EXPECT_NEAR(problem.x(0), 1, 1e-12);
    EXPECT_EQ(problem.evaluated.front(), 1);
  }
}

TEST(LineSearch, BreaksCyclesOfPlainNewton) {
  Problem plain = two_cycle();
  const NewtonReport without = plain.solve(LineSearchKind::none, 40);
  EXPECT_EQ(without.outcome, Outcome::iteration_limit);
  EXPECT_EQ(without.residuals.back(), without.residuals.front());
  for (LineSearchKind kind : {LineSearchKind::residual, LineSearchKind::energy}) {
    Problem problem = two_cycle();
    const NewtonReport report = problem.solve(kind, 40);
    EXPECT_EQ(report.outcome, Outcome::converged) << text_of(report.messages);
    EXPECT_LT(std::abs(problem.x(0) * (problem.x(0) * problem.x(0) - 5)), 1e-11);
  }
}

// ── The search alone ─────────────────────────────────────────────────────────────────────────────────────────────────

/// Fractions that a search evaluates, and the one that it accepts.
struct SearchRecord {
  std::vector<double> at;
  std::optional<double> part;
};

SearchRecord search_along(LineSearchKind kind, const std::function<Trial(double)>& trial,
                          const std::vector<double>& residuals, double slope = 0) {
  SearchRecord record;
  record.part = line_search(
      kind,
      [&](double s) {
        record.at.push_back(s);
        return trial(s);
      },
      residuals, slope);
  return record;
}

TEST(LineSearch, ByResidualUsesTheParabola) {
  // φ(0) = 1, φ′(0) = −2, φ(1) = 2²: the parabola's minimum is at 1/(4 − 1 + 2) = 0.2.
  const auto trial = [](double s) { return Trial{s == 1 ? 2.0 : 0.5, 0}; };
  const SearchRecord record = search_along(LineSearchKind::residual, trial, {1});
  ASSERT_EQ(record.at.size(), 2u);
  EXPECT_NEAR(record.at[1], 0.2, 1e-15);
  EXPECT_EQ(record.part, record.at[1]);
  // Limited to between a tenth and a half of the last fraction
  const auto huge = [](double s) { return Trial{s == 1 ? 1e6 : 0.5, 0}; };
  EXPECT_EQ(search_along(LineSearchKind::residual, huge, {1}).part, 0.1);
  const auto scarce = [](double s) { return Trial{s == 1 ? 1 + 1e-9 : 0.5, 0}; };
  EXPECT_EQ(search_along(LineSearchKind::residual, scarce, {1}).part,
            search_along(LineSearchKind::residual, scarce, {1}).at[1]);
  EXPECT_NEAR(*search_along(LineSearchKind::residual, scarce, {1}).part, 0.5, 1e-8);
}

TEST(LineSearch, ByResidualAllowsATemporaryIncrease) {
  const auto risen = [](double) { return Trial{3, 0}; };
  EXPECT_EQ(search_along(LineSearchKind::residual, risen, {4, 1, 2, 1}).part, 1);
  EXPECT_EQ(search_along(LineSearchKind::residual, risen, {1, 1, 2, 1}).part, std::nullopt);
  // Four residuals are compared, the fifth is ignored.
  EXPECT_EQ(search_along(LineSearchKind::residual, risen, {4, 1, 1, 1, 1}).part, std::nullopt);
  EXPECT_EQ(search_along(LineSearchKind::residual, risen, {1, 4, 1, 1, 1}).part, 1);
  // Equal to the highest is not a decrease.
  EXPECT_EQ(search_along(LineSearchKind::residual, risen, {3}).part, std::nullopt);
}

TEST(LineSearch, ByEnergyFindsASmallSlope) {
  // f·Δu = −1 + 5s is zero at 0.2; regula falsi finds it in one trial.
  const auto steep = [](double s) { return Trial{1, -1 + 5 * s}; };
  const SearchRecord record = search_along(LineSearchKind::energy, steep, {1}, -1);
  ASSERT_EQ(record.at.size(), 2u);
  EXPECT_NEAR(*record.part, 0.2, 1e-15);
  // Same sign, or small enough: the whole move, whatever the residual
  EXPECT_EQ(search_along(
                LineSearchKind::energy,
                [](double s) {
                  return Trial{9, -1 - s};
                },
                {1}, -1)
                .part,
            1);
  EXPECT_EQ(search_along(
                LineSearchKind::energy,
                [](double s) {
                  return Trial{9, -1 + 1.5 * s};
                },
                {1}, -1)
                .part,
            1);
  EXPECT_LT(*search_along(
                 LineSearchKind::energy,
                 [](double s) {
                   return Trial{9, -1 + 1.6 * s};
                 },
                 {1}, -1)
                 .part,
            1);
  // A positive slope, which an indefinite tangent causes, is searched in the same way.
  EXPECT_NEAR(*search_along(
                   LineSearchKind::energy,
                   [](double s) {
                     return Trial{1, 1 - 5 * s};
                   },
                   {1}, 1)
                   .part,
              0.2, 1e-15);
}

/// The slope keeps its sign up to the invalid states: no better fraction exists.
TEST(LineSearch, ByEnergyAdvancesToTheLastValidState) {
  const auto edge = [](double s) { return s > 0.6 ? Trial{infinity, infinity} : Trial{1, -1 + 0.2 * s}; };
  const SearchRecord record = search_along(LineSearchKind::energy, edge, {1}, -1);
  EXPECT_EQ(record.part, 0.5);
  EXPECT_EQ(record.at, (std::vector<double>{1, 0.5}));
}

TEST(LineSearch, FailsBelowOneIn128) {
  const SearchRecord by_residual = search_along(LineSearchKind::residual,
                                                [](double) {
                                                  return Trial{infinity, infinity};
                                                },
                                                {1});
  EXPECT_EQ(by_residual.part, std::nullopt);
  EXPECT_EQ(by_residual.at, (std::vector<double>{1, 0.5, 0.25, 1. / 8, 1. / 16, 1. / 32, 1. / 64, 1. / 128}));
  const SearchRecord by_energy = search_along(
      LineSearchKind::energy,
      [](double) {
        return Trial{infinity, infinity};
      },
      {1}, -1);
  EXPECT_EQ(by_energy.part, std::nullopt);
  EXPECT_EQ(by_energy.at, by_residual.at);
  // A jump of the slope that no fraction approaches
  const SearchRecord leap = search_along(
      LineSearchKind::energy,
      [](double s) {
        return Trial{1, s < 0.3 ? -1.0 : 1.0};
      },
      {1}, -1);
  EXPECT_EQ(leap.part, std::nullopt);
  EXPECT_LE(leap.at.size(), 10u);
}

TEST(LineSearch, LoopReportsAFailedSearch) {
  // The slope has the wrong sign: Newton's moves increase the residual.
  Problem problem = scalar([](double x) { return 1 + x * x; }, [](double) { return -1.0; }, 1);
  const NewtonReport report = problem.solve(LineSearchKind::residual);
  EXPECT_EQ(report.outcome, Outcome::line_search);
  EXPECT_EQ(name_of(report.outcome), "line_search");
  EXPECT_EQ(report.iterations, 1);
  EXPECT_TRUE(report.parts.empty());
  EXPECT_EQ(problem.x(0), 1); // as before the move
  EXPECT_NE(text_of(report.messages).find("solve.newton.line_search: residual = "), std::string::npos)
      << text_of(report.messages);
}

/// With an inexact slope moves shrink by a constant factor; those below the tolerance of the energy are not searched.
TEST(LineSearch, LastMovesAreNotSearched) {
  Problem problem = scalar([](double x) { return x; }, [](double) { return 1.25; }, 1);
  const NewtonReport report = problem.solve(LineSearchKind::energy, 40);
  ASSERT_EQ(report.outcome, Outcome::converged);
  // The energy of move k is 0.8·0.2^(2k): k = 9 is the first with at most 1e-12 of the first one.
  EXPECT_EQ(problem.evaluated.size(), 9u);
  EXPECT_EQ(report.parts, std::vector<double>(static_cast<std::size_t>(report.iterations), 1));
  EXPECT_GT(report.iterations, 9);
}

TEST(LineSearch, KindsHaveNames) {
  EXPECT_EQ(line_search_kind("none"), LineSearchKind::none);
  EXPECT_EQ(line_search_kind("residual"), LineSearchKind::residual);
  EXPECT_EQ(line_search_kind("energy"), LineSearchKind::energy);
  try {
    line_search_kind("enrgy");
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "solve.line_search.unknown: name = enrgy");
  }
}

} // namespace line_search_test
} // namespace signorini::solve
