// The loop on systems small enough to predict its results.
#include "solve/newton.hpp"

#include "os/interrupt.hpp"
#include "text_of.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <functional>
#include <limits>

namespace signorini::solve {
namespace newton_test {

void press_ctrl_c() {
  catch_interrupts();
  std::raise(SIGINT);
}

NewtonReport newton(NewtonProblem& problem, const NewtonOptions& options, bool pending) {
  NewtonReport report;
  while (iterate(problem, options, pending, report)) {
  }
  return report;
}

/// f(x) = 0 in one unknown, with its derivative.
struct Scalar : NewtonProblem {
  std::function<double(double)> f, slope;
  double x = 0, forces = 1, rounding = 0;
  int assemblies = 0, tangents = 0, solves = 0;
  double tangent_at = std::numeric_limits<double>::quiet_NaN();
  Outcome outcome = Outcome::converged;
  std::function<double()> floor_of_tangent;
  std::function<Outcome(Message&)> end;

  explicit Scalar(std::function<double(double)> function = {}, std::function<double(double)> derivative = {},
                  double start = 0)
      : f(std::move(function)), slope(std::move(derivative)), x(start) {}

  NewtonReport solve(const NewtonOptions& options = {}, bool pending = false) {
    return newton(*this, options, pending);
  }
  Outcome evaluate(bool tangent, Message& why) override {
    ++assemblies;
    if (tangent) ++tangents, tangent_at = x;
    why = Message("test.wanted");
    return outcome;
  }
  double residual() const override { return std::abs(f(x)); }
  double scale() const override { return forces; }
  double floor() const override { return floor_of_tangent ? floor_of_tangent() : rounding; }
  Outcome conclude(Message& why) override { return end ? end(why) : NewtonProblem::conclude(why); }
  std::optional<double> advance() override {
    ++solves;
    EXPECT_EQ(tangent_at, x); // a solve never uses an old tangent
    if (slope(x) == 0) return std::nullopt;
    const double step = -f(x) / slope(x), work = f(x) * step;
    x += step;
    return work;
  }
};

Scalar root_of_two() {
  return Scalar([](double x) { return x * x - 2; }, [](double x) { return 2 * x; }, 1.0);
}

TEST(Newton, ConvergesQuadratically) {
  Scalar problem = root_of_two();
  const NewtonReport report = problem.solve({1e-14, 25});
  EXPECT_EQ(report.outcome, Outcome::converged);
  EXPECT_NEAR(problem.x, std::sqrt(2.0), 1e-15);
  ASSERT_EQ(report.residuals.size(), static_cast<std::size_t>(report.iterations) + 1);
  EXPECT_EQ(report.energies.size(), static_cast<std::size_t>(report.iterations));
  EXPECT_EQ(problem.solves, report.iterations);
  // f(x + δ) = δ² with δ = f/2x: each residual is the square of the last one over 4x².
  for (std::size_t k = 1; k < report.residuals.size(); ++k)
    EXPECT_LE(report.residuals[k], std::pow(report.residuals[k - 1], 2) / 4 + 1e-15);
  for (std::size_t k = 1; k < report.energies.size(); ++k) EXPECT_LT(report.energies[k], report.energies[k - 1]);
}

TEST(Newton, PredictedConvergenceIsConfirmedByTheResidualAlone) {
  Scalar problem = root_of_two();
  const NewtonReport report = problem.solve({1e-10, 25});
  EXPECT_EQ(problem.assemblies, report.iterations + 1);
  EXPECT_EQ(problem.tangents, report.iterations);
}

TEST(Newton, WrongPredictionCostsOneMoreAssembly) {
  // Residuals 1, 1e-4, from which quadratic convergence predicts 1e-12; a slope twice too steep leaves 5e-6.
  Scalar problem{[](double x) { return x < 0.9e-4 ? 0.1 * x : x; },
                 [](double x) { return x < 0.9e-4 ? 0.1
                                       : x < 1    ? 2.0
                                                  : 1 / 0.9999; }, 1.0};
  const NewtonReport report = problem.solve({1e-10, 50});
  EXPECT_EQ(report.outcome, Outcome::converged);
  EXPECT_GT(problem.assemblies, report.iterations + 1);
}

TEST(Newton, LinearSystemsNeedOneSolve) {
  Scalar problem{[](double x) { return 4 * x - 8; }, [](double) { return 4.0; }};
  problem.rounding = 1e-15;
  EXPECT_EQ(problem.solve().iterations, 1);
  EXPECT_EQ(problem.x, 2);
}

TEST(Newton, SmallResidualNeedsNoSolveUnlessDisplacementsArePending) {
  Scalar solved{[](double x) { return x; }, [](double) { return 1.0; }};
  EXPECT_EQ(solved.solve().iterations, 0);
  EXPECT_EQ(solved.solve().outcome, Outcome::converged);
  const NewtonReport pending = solved.solve({}, true);
  EXPECT_EQ(pending.iterations, 1);
  EXPECT_EQ(pending.outcome, Outcome::converged);
}

/// f = x with an error of ±size that no iteration removes.
Scalar noisy(double size) {
  Scalar problem;
  problem.x = 1;
  problem.f = [size](double x) { return std::abs(x) < 3 * size ? std::copysign(size, x) : x; };
  problem.slope = [](double) { return 0.9; };
  problem.forces = 0;
  return problem;
}

TEST(Newton, ResidualThatStagnatesNearTheRoundingLevelHasConverged) {
  for (const double times : {1.5, 9.0}) {
    Scalar problem = noisy(times * 1e-12);
    problem.rounding = 1e-12;
    const NewtonReport report = problem.solve({1e-10, 60});
    EXPECT_EQ(report.outcome, Outcome::converged) << times;
    EXPECT_LE(report.residuals.back(), 10 * problem.rounding);
  }
  Scalar far = noisy(11e-12);
  far.rounding = 1e-12;
  EXPECT_EQ(far.solve({1e-10, 60}).outcome, Outcome::iteration_limit);
}

TEST(Newton, ResidualThatStillDecreasesNearTheRoundingLevelIsNotStagnating) {
  // Each iteration leaves a third: 27, 9, 3 and 1 times the floor are visited.
  Scalar problem{[](double x) { return x; }, [](double) { return 1.5; }, 27e-12};
  problem.rounding = 1e-12;
  problem.forces = 0;
  EXPECT_EQ(problem.solve({1e-10, 60}).outcome, Outcome::converged);
  EXPECT_LE(problem.x, 1.001 * problem.rounding);
}

TEST(Newton, TheRoundingLevelIsThatOfThePresentTangent) {
  // As a contact that opens: the residual 5e-6 is predicted to vanish, and below the level of the former, stiff
  // tangent.
  Scalar problem{[](double x) { return x < 0.9e-4 ? 0.1 * x : x; },
                 [](double x) { return x < 0.9e-4 ? 0.1
                                       : x < 1    ? 2.0
                                                  : 1 / 0.9999; }, 1.0};
  problem.floor_of_tangent = [&problem] { return problem.slope(problem.tangent_at) == 2 ? 1e-5 : 1e-12; };
  const NewtonReport report = problem.solve({1e-10, 25});
  EXPECT_EQ(report.outcome, Outcome::converged);
  EXPECT_LE(report.residuals.back(), 1e-10);
}

TEST(Newton, IterationLimitIsReported) {
  Scalar problem = root_of_two();
  const NewtonReport report = problem.solve({1e-14, 2});
  EXPECT_EQ(report.outcome, Outcome::iteration_limit);
  EXPECT_EQ(report.iterations, 2);
  EXPECT_EQ(report.residuals.size(), 3u);
  EXPECT_NE(text_of(report.messages).find("solve.newton.no_convergence: iterations = 2"), std::string::npos);
  // A cycle between 0 and 1: f = x³ − 2x + 2.
  Scalar cycle{[](double x) { return x * x * x - 2 * x + 2; }, [](double x) { return 3 * x * x - 2; }};
  EXPECT_EQ(cycle.solve({1e-10, 50}).outcome, Outcome::iteration_limit);
}

TEST(Newton, DivergenceIsReported) {
  // Newton's method on sign(x) |x|^(1/5) multiplies x by −4 each time.
  Scalar problem{[](double x) { return std::copysign(std::pow(std::abs(x), 0.2), x) * 1e3; },
                 [](double x) { return 0.2e3 * std::pow(std::abs(x), -0.8); }, 1.0};
  const NewtonReport report = problem.solve({1e-10, 1000});
  EXPECT_EQ(report.outcome, Outcome::diverged);
  EXPECT_LT(report.iterations, 1000);
  EXPECT_NE(text_of(report.messages).find("solve.newton.diverged"), std::string::npos);
}

TEST(Newton, NonfiniteResidualIsReported) {
  Scalar problem{[](double x) { return x < 1 ? 1.0 : std::numeric_limits<double>::quiet_NaN(); },
                 [](double) { return -1.0; }};
  const NewtonReport report = problem.solve();
  EXPECT_EQ(report.outcome, Outcome::not_finite);
  EXPECT_EQ(report.iterations, 1);
}

TEST(Newton, SingularTangentAndErrorsOfAssemblyAreReported) {
  Scalar flat{[](double) { return 1.0; }, [](double) { return 0.0; }};
  EXPECT_EQ(flat.solve().outcome, Outcome::singular_tangent);
  Scalar inverted = root_of_two();
  inverted.outcome = Outcome::inverted_element;
  const NewtonReport report = inverted.solve();
  EXPECT_EQ(report.outcome, Outcome::inverted_element);
  EXPECT_EQ(text_of(report.messages), "test.wanted");
  EXPECT_EQ(inverted.solves, 0);
}

/// A residual that happens to be small does not end the iteration while the last move still did work.
TEST(Newton, EnergyMustDecreaseToo) {
  struct : NewtonProblem {
    int calls = 0;
    Outcome evaluate(bool, Message&) override { return Outcome::converged; }
    double residual() const override { return calls == 0 ? 1.0 : 1e-12; }
    double scale() const override { return 1; }
    double floor() const override { return 0; }
    std::optional<double> advance() override { return ++calls < 3 ? 1.0 : 1e-15; }
  } problem;
  EXPECT_EQ(newton(problem, {}, false).iterations, 3);
}

TEST(Newton, ResidualIsRelativeToTheScale) {
  Scalar problem = root_of_two();
  problem.forces = 1e6;
  const NewtonReport report = problem.solve({1e-10, 25});
  EXPECT_EQ(report.outcome, Outcome::converged);
  EXPECT_LE(report.residuals.back(), 1e-4);
}

TEST(Newton, StopsWhenInterrupted) {
  press_ctrl_c();
  Scalar problem = root_of_two();
  const NewtonReport report = problem.solve();
  clear_interrupt();
  EXPECT_EQ(report.outcome, Outcome::interrupted);
  EXPECT_EQ(problem.solves, 0);
  EXPECT_EQ(problem.x, 1.0);
}

TEST(Newton, StopsBeforeAStepThatNeedsNoIteration) {
  Scalar problem = root_of_two();
  problem.x = std::sqrt(2.0);
  EXPECT_EQ(problem.solve().iterations, 0);
  press_ctrl_c();
  const NewtonReport report = problem.solve();
  clear_interrupt();
  EXPECT_EQ(report.outcome, Outcome::interrupted);
  EXPECT_EQ(report.residuals.size(), 0U);
}

TEST(Newton, IterationByIterationGivesTheSameResults) {
  for (const bool pending : {false, true})
    for (const int limit : {2, 25}) {
      const NewtonOptions options{1e-14, limit};
      Scalar whole = root_of_two(), pieces = root_of_two();
      const NewtonReport at_once = whole.solve(options, pending);
      NewtonReport report;
      int calls = 0;
      while (iterate(pieces, options, pending, report)) {
        EXPECT_EQ(report.outcome, Outcome::iterating);
        EXPECT_EQ(report.iterations, ++calls);
        EXPECT_EQ(report.residuals.size(), static_cast<std::size_t>(calls));
        EXPECT_EQ(pieces.solves, calls);
      }
      EXPECT_EQ(report.outcome, at_once.outcome);
      EXPECT_EQ(report.residuals, at_once.residuals);
      EXPECT_EQ(report.energies, at_once.energies);
      EXPECT_EQ(report.tolerance, at_once.tolerance);
      EXPECT_EQ(text_of(report.messages), text_of(at_once.messages));
      EXPECT_EQ(pieces.x, whole.x);
      EXPECT_EQ(pieces.assemblies, whole.assemblies);
    }
}

TEST(Newton, ConcludeIsCalledOnlyOnConvergenceAndMayFail) {
  Scalar problem = root_of_two();
  int asked = 0;
  problem.end = [&](Message&) {
    ++asked;
    EXPECT_NEAR(problem.x, std::sqrt(2.0), 1e-7);
    return Outcome::converged;
  };
  const NewtonReport report = problem.solve({1e-10, 25});
  EXPECT_EQ(report.outcome, Outcome::converged);
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(report.begun, 0);

  problem.end = [](Message& why) {
    why = Message("test.too_deep");
    return Outcome::crossed;
  };
  problem.x = 1;
  const NewtonReport failed = problem.solve({1e-10, 25});
  EXPECT_EQ(failed.outcome, Outcome::crossed);
  EXPECT_EQ(text_of(failed.messages), "test.too_deep");
  EXPECT_EQ(failed.residuals, report.residuals);

  problem.x = 1;
  problem.end = [&](Message&) {
    ADD_FAILURE() << "called before convergence";
    return Outcome::converged;
  };
  EXPECT_EQ(problem.solve({1e-10, 2}).outcome, Outcome::iteration_limit);
}

/// √2, then √3, then √5 with one limit for each.
TEST(Newton, IterationLimitRestartsWhenConcludeRequestsMore) {
  double square = 2;
  Scalar problem{[&](double x) { return x * x - square; }, [](double x) { return 2 * x; }, 1.0};
  const auto raise = [&](Message&) {
    if (square == 5) return Outcome::converged;
    square = square == 2 ? 3 : 5;
    return Outcome::iterating;
  };
  problem.end = raise;
  const NewtonReport report = problem.solve({1e-12, 6});
  EXPECT_EQ(report.outcome, Outcome::converged);
  EXPECT_NEAR(problem.x, std::sqrt(5.0), 1e-12);
  EXPECT_GT(report.iterations, 6);
  EXPECT_GT(report.begun, 6);
  EXPECT_LE(report.iterations - report.begun, 6);

  problem.x = 1, square = 2;
  const NewtonReport limited = problem.solve({1e-12, 4});
  EXPECT_EQ(limited.outcome, Outcome::iteration_limit);
  EXPECT_EQ(limited.iterations - limited.begun, 4);

  // An interrupt ends the iteration even if conclude always requests more.
  problem.x = 1;
  problem.end = [&](Message&) { return square += 1, Outcome::iterating; };
  press_ctrl_c();
  EXPECT_EQ(problem.solve({1e-12, 6}).outcome, Outcome::interrupted);
  clear_interrupt();
}

TEST(Newton, OutcomesHaveNames) {
  const std::pair<Outcome, const char*> names[] = {
      {Outcome::converged, "converged"},       {Outcome::iteration_limit, "iterations"},
      {Outcome::diverged, "diverged"},         {Outcome::inverted_element, "inverted"},
      {Outcome::singular_tangent, "singular"}, {Outcome::not_finite, "nan"},
      {Outcome::interrupted, "interrupted"},   {Outcome::iterating, "iterating"},
      {Outcome::cycling, "cycling"},           {Outcome::lost_projection, "lost_projection"},
      {Outcome::indefinite, "indefinite"},     {Outcome::line_search, "line_search"},
      {Outcome::crossed, "crossed"},
  };
  for (const auto& [outcome, name] : names) EXPECT_EQ(name_of(outcome), name);
}

} // namespace newton_test
} // namespace signorini::solve
