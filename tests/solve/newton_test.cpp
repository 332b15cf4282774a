// The loop on systems small enough to know what must come out.
#include "solve/newton.hpp"

#include "base/interrupt.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace signorini::solve {
namespace {

/// f(x) = 0 in one unknown with its derivative.
struct Scalar {
  std::function<double(double)> f, slope;
  double x = 0, scale = 1, floor = 0;
  int assemblies = 0, tangents = 0, solves = 0;
  double tangent_at = std::numeric_limits<double>::quiet_NaN();
  Outcome outcome = Outcome::converged;

  NewtonReport solve(const NewtonOptions& options = {}, bool pending = false) {
    NewtonSystem system;
    system.assemble = [this](bool tangent, std::string& why) {
      ++assemblies;
      if (tangent) ++tangents, tangent_at = x;
      why = "as the test wants it";
      return outcome;
    };
    system.residual = [this] { return std::abs(f(x)); };
    system.scale = [this] { return scale; };
    system.floor = [this] { return floor; };
    system.advance = [this](double& energy) {
      ++solves;
      EXPECT_EQ(tangent_at, x); // a step never uses an old tangent
      if (slope(x) == 0) return false;
      const double step = -f(x) / slope(x);
      energy = std::abs(f(x) * step);
      x += step;
      return true;
    };
    return newton(system, options, pending);
  }
};

Scalar root_of_two() {
  return {[](double x) { return x * x - 2; }, [](double x) { return 2 * x; }, 1.0};
}

TEST(Newton, ConvergesQuadratically) {
  Scalar problem = root_of_two();
  const NewtonReport report = problem.solve({1e-14, 25});
  EXPECT_EQ(report.outcome, Outcome::converged);
  EXPECT_NEAR(problem.x, std::sqrt(2.0), 1e-15);
  ASSERT_EQ(report.residuals.size(), static_cast<std::size_t>(report.iterations) + 1);
  EXPECT_EQ(report.energies.size(), static_cast<std::size_t>(report.iterations));
  EXPECT_EQ(problem.solves, report.iterations);
  // f(x + δ) = δ² with δ = f/2x: each residual is the square of the last over 4x².
  for (std::size_t k = 1; k < report.residuals.size(); ++k)
    EXPECT_LE(report.residuals[k], std::pow(report.residuals[k - 1], 2) / 4 + 1e-15);
  for (std::size_t k = 1; k < report.energies.size(); ++k) EXPECT_LT(report.energies[k], report.energies[k - 1]);
}

TEST(Newton, TheResidualAloneConfirmsConvergenceThatIsForeseen) {
  Scalar problem = root_of_two();
  const NewtonReport report = problem.solve({1e-10, 25});
  EXPECT_EQ(problem.assemblies, report.iterations + 1);
  EXPECT_EQ(problem.tangents, report.iterations);
}

TEST(Newton, AForeseenConvergenceThatDoesNotComeCostsOneMoreAssembly) {
  // Residuals 1, 1e-4, for which the square law foresees 1e-12; a slope twice too steep leaves 5e-6.
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
  problem.floor = 1e-15;
  EXPECT_EQ(problem.solve().iterations, 1);
  EXPECT_EQ(problem.x, 2);
}

TEST(Newton, NothingToDoTakesNoSolveUnlessDisplacementsWait) {
  Scalar solved{[](double x) { return x; }, [](double) { return 1.0; }};
  EXPECT_EQ(solved.solve().iterations, 0);
  EXPECT_EQ(solved.solve().outcome, Outcome::converged);
  const NewtonReport pending = solved.solve({}, true);
  EXPECT_EQ(pending.iterations, 1);
  EXPECT_EQ(pending.outcome, Outcome::converged);
}

TEST(Newton, IterationLimit) {
  Scalar problem = root_of_two();
  const NewtonReport report = problem.solve({1e-14, 2});
  EXPECT_EQ(report.outcome, Outcome::iteration_limit);
  EXPECT_EQ(report.iterations, 2);
  EXPECT_EQ(report.residuals.size(), 3u);
  EXPECT_NE(report.message.find("no convergence in 2 iterations"), std::string::npos);
  // A cycle between 0 and 1 never ends by itself: f = x³ − 2x + 2.
  Scalar cycle{[](double x) { return x * x * x - 2 * x + 2; }, [](double x) { return 3 * x * x - 2; }};
  EXPECT_EQ(cycle.solve({1e-10, 50}).outcome, Outcome::iteration_limit);
}

TEST(Newton, Divergence) {
  // Newton on x^(1/3) doubles x with changed sign each time; a cubed copy grows fast enough.
  Scalar problem{[](double x) { return std::copysign(std::pow(std::abs(x), 0.2), x) * 1e3; },
                 [](double x) { return 0.2e3 * std::pow(std::abs(x), -0.8); }, 1.0};
  const NewtonReport report = problem.solve({1e-10, 1000});
  EXPECT_EQ(report.outcome, Outcome::diverged);
  EXPECT_LT(report.iterations, 1000);
  EXPECT_NE(report.message.find("the residual grew to"), std::string::npos);
}

TEST(Newton, NotFinite) {
  Scalar problem{[](double x) { return x < 1 ? 1.0 : std::numeric_limits<double>::quiet_NaN(); },
                 [](double) { return -1.0; }};
  const NewtonReport report = problem.solve();
  EXPECT_EQ(report.outcome, Outcome::not_finite);
  EXPECT_EQ(report.iterations, 1);
}

TEST(Newton, SingularTangentAndWhatAssemblyReports) {
  Scalar flat{[](double) { return 1.0; }, [](double) { return 0.0; }};
  EXPECT_EQ(flat.solve().outcome, Outcome::singular_tangent);
  Scalar inverted = root_of_two();
  inverted.outcome = Outcome::inverted_element;
  const NewtonReport report = inverted.solve();
  EXPECT_EQ(report.outcome, Outcome::inverted_element);
  EXPECT_EQ(report.message, "as the test wants it");
  EXPECT_EQ(inverted.solves, 0);
}

/// A residual that happens to be small does not end the iteration while the last step still did work.
TEST(Newton, EnergyMustFallToo) {
  int calls = 0;
  NewtonSystem system;
  system.assemble = [](bool, std::string&) { return Outcome::converged; };
  system.residual = [&] { return calls == 0 ? 1.0 : 1e-12; };
  system.scale = [] { return 1.0; };
  system.floor = [] { return 0.0; };
  system.advance = [&](double& energy) {
    energy = ++calls < 3 ? 1.0 : 1e-15;
    return true;
  };
  EXPECT_EQ(newton(system, {}, false).iterations, 3);
}

TEST(Newton, ResidualIsRelativeToTheScale) {
  Scalar problem = root_of_two();
  problem.scale = 1e6;
  const NewtonReport report = problem.solve({1e-10, 25});
  EXPECT_EQ(report.outcome, Outcome::converged);
  EXPECT_LE(report.residuals.back(), 1e-4);
}

TEST(Newton, StopsWhenInterrupted) {
  request_interrupt();
  Scalar problem = root_of_two();
  const NewtonReport report = problem.solve();
  clear_interrupt();
  EXPECT_EQ(report.outcome, Outcome::interrupted);
  EXPECT_EQ(problem.solves, 0);
  EXPECT_EQ(problem.x, 1.0);
}

TEST(Newton, OutcomesHaveNames) {
  const std::pair<Outcome, const char*> names[] = {
      {Outcome::converged, "converged"},       {Outcome::iteration_limit, "iterations"},
      {Outcome::diverged, "diverged"},         {Outcome::inverted_element, "inverted"},
      {Outcome::singular_tangent, "singular"}, {Outcome::not_finite, "nan"},
      {Outcome::interrupted, "interrupted"},
  };
  for (const auto& [outcome, name] : names) EXPECT_EQ(name_of(outcome), name);
}

} // namespace
} // namespace signorini::solve
