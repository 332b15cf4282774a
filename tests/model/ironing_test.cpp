// The published ironing problem at mesh m1 with Newton's method alone: every discretization converges quadratically in
// few iterations, and forces balance.
#include "model/results/results.hpp"
#include "model/steps/arc.hpp"
#include "model/steps/load_step.hpp"

#include "model/quadratic.hpp"
#include "model/scenes.hpp"
#include "text_of.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace signorini::model {
namespace ironing_test {

using namespace test;

class Ironing : public testing::TestWithParam<const char*> {};

TEST_P(Ironing, ConvergesQuadraticallyAndBalances) {
  Model<2> model(ironing(GetParam()));
  constexpr int steps = 106;
  int iterations = 0, pairs = 0;
  for (int step = 1; step <= steps; ++step) {
    const solve::NewtonReport report = ironing_step(model, step);
    ASSERT_EQ(report.outcome, solve::Outcome::converged) << "step " << step << ": " << text_of(report.messages);
    iterations += report.iterations;

    const auto contact = resultant(model.present.contacts[0]);
    const Vec<2> by_bed = reaction(model, bed), by_grip = reaction(model, grip);
    const double scale = by_grip.norm();
    // Forces balance up to the residual of the free control points: |Σ r| ≤ √n |r|.
    const double missing = std::sqrt(model.system.unknowns.size()) * report.residuals.back() + 1e-12 * scale;
    EXPECT_LT((by_bed + by_grip).norm(), missing) << "step " << step;
    // The grip's reaction balances the slab's force on the die.
    EXPECT_LT((contact.force + by_grip).norm(), missing) << "step " << step;
    EXPECT_GT(contact.active, 0);
    if (step > 60) {
      EXPECT_GT(contact.force(1), 0);
      EXPECT_LT(contact.force(0), 0);
      EXPECT_GT(contact.slipping, 0);
    }

    if (step % 20 == 0) pairs += compare_starts(model);
    accept(model);
  }
  EXPECT_LE(iterations, 4.5 * steps);
  EXPECT_GE(pairs, 10); // of 20
}

INSTANTIATE_TEST_SUITE_P(Labels, Ironing,
                         testing::Values("N2", "N4", "N6", "N2-N4", "N2-N6", "N2-N2.1", "N2-N2.2", "N2-N2.3"),
                         [](const auto& info) {
                           std::string name = info.param;
                           std::replace_if(
                               name.begin(), name.end(), [](char c) { return c == '-' || c == '.'; }, '_');
                           return name;
                         });

} // namespace ironing_test
} // namespace signorini::model
