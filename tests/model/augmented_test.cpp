// The augmented Lagrangian method for a known exact state: a block between walls, pressed onto a plane.
#include "model/scenes.hpp"
#include "text_of.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace signorini::model {
namespace augmented_test {

using namespace test;

const solid::NeoHookean material = solid::neo_hookean(2, 0.3);

Scene<2> pressed_block(double penalty, contact::Enforcement enforcement = contact::Enforcement::augmented) {
  Scene<2> scene = square({{"walls", "west", {Constraint::fixed, Constraint::free}},
                           {"far", "east", {Constraint::fixed, Constraint::free}},
                           {"top", "north", {Constraint::free, Constraint::driven}}},
                          material);
  scene.obstacles = {contact::make_plane<2>({0, 0}, {0, 1})};
  const contact::PenaltyLaw law{.normal = penalty, .enforcement = enforcement};
  scene.contacts = {{"floor", {0, nurbs::side_of("south", 2)}, ObstacleReference{0}, law, 4}};
  return scene;
}

/// Uniaxial strain on an impenetrable plane: p = −P_yy = −μ f − (λ ln f − μ)/f with f = 1 − depth.
double exact_pressure(double depth) {
  const double f = 1 - depth;
  return -(material.mu * f + (material.lambda * std::log(f) - material.mu) / f);
}

StepOptions augmented(double penetration, int loops = 100) {
  StepOptions options;
  options.augmentation = {penetration, loops};
  return options;
}

TEST(Augmented, PressureIsExactAtAModeratePenalty) {
  for (double penalty : {10.0, 40.0})
    for (double tolerance : {1e-4, 1e-8}) {
      Model<2> model(pressed_block(penalty));
      for (double depth : {0.1, 0.2}) {
        set_target(model, 0, 0, -depth);
        const solve::NewtonReport report = solve_step(model, augmented(tolerance));
        ASSERT_EQ(report.outcome, solve::Outcome::converged) << text_of(report.messages);
        EXPECT_GT(report.begun, 0);
        const auto floor = resultant(model.present.contacts[0]);
        // The block's diagonal is √2.
        EXPECT_LE(floor.max_penetration, std::sqrt(2) * tolerance);
        EXPECT_EQ(floor.active, 8);
        const double p = exact_pressure(depth);
        // The remaining penetration changes the pressure with a stiffness below λ + 2μ.
        EXPECT_NEAR(floor.max_pressure, p, 20 * tolerance + 1e-9);
        EXPECT_NEAR(-reaction(model, 2)(1), p, 20 * tolerance + 1e-9);
        if (tolerance < 1e-6) {
          EXPECT_NEAR(floor.max_pressure / p, 1, 1e-5);
        }
        accept(model);
      }
    }
  // The penalty method alone has a large error.
  Model<2> plain(pressed_block(10, contact::Enforcement::penalty));
  set_target(plain, 0, 0, -0.2);
  ASSERT_EQ(solve_step(plain, {}).outcome, solve::Outcome::converged);
  EXPECT_GT(std::abs(resultant(plain.present.contacts[0]).max_pressure / exact_pressure(0.2) - 1), 0.1);
}

TEST(Augmented, ASeparatedBlockHasNoPressure) {
  Model<2> model(pressed_block(40));
  for (double depth : {0.2, 0.05, -0.01}) {
    set_target(model, 0, 0, -depth);
    const solve::NewtonReport report = solve_step(model, augmented(1e-8));
    ASSERT_EQ(report.outcome, solve::Outcome::converged) << text_of(report.messages);
    EXPECT_NEAR(resultant(model.present.contacts[0]).max_pressure, depth > 0 ? exact_pressure(depth) : 0, 1e-6);
    EXPECT_NEAR(reaction(model, 2)(1), depth > 0 ? -exact_pressure(depth) : 0, 1e-6);
    accept(model);
  }
}

TEST(Augmented, TooFewLoopsAreReported) {
  Model<2> model(pressed_block(10));
  set_target(model, 0, 0, -0.2);
  const solve::NewtonReport report = solve_step(model, augmented(1e-8, 3));
  EXPECT_EQ(report.outcome, solve::Outcome::penetration);
  EXPECT_NE(text_of(report.messages).find("loops = 3, tolerance = 1.41421"), std::string::npos)
      << text_of(report.messages);
}

TEST(Augmented, RollBackAndRestoreIncludeMultipliers) {
  Model<2> model(pressed_block(40));
  set_target(model, 0, 0, -0.1);
  ASSERT_EQ(solve_step(model, augmented(1e-8)).outcome, solve::Outcome::converged);
  accept(model);
  const Snapshot<2> saved = snapshot(model);
  const double pressure = resultant(model.present.contacts[0]).max_pressure;
  set_target(model, 0, 0, -0.2);
  ASSERT_EQ(solve_step(model, augmented(1e-8)).outcome, solve::Outcome::converged);
  rollback(model);
  EXPECT_EQ(resultant(model.present.contacts[0]).max_pressure, pressure);
  set_target(model, 0, 0, -0.2);
  ASSERT_EQ(solve_step(model, augmented(1e-8)).outcome, solve::Outcome::converged);
  const double deeper = resultant(model.present.contacts[0]).max_pressure;
  accept(model);
  restore(model, saved);
  EXPECT_EQ(resultant(model.present.contacts[0]).max_pressure, pressure);
  set_target(model, 0, 0, -0.2);
  ASSERT_EQ(solve_step(model, augmented(1e-8)).outcome, solve::Outcome::converged);
  EXPECT_EQ(resultant(model.present.contacts[0]).max_pressure, deeper);
}

/// The penalty factor is restored with its state.
TEST(PenaltyFactor, IsRestoredWithTheState) {
  Model<2> model(pressed_block(40, contact::Enforcement::penalty));
  set_penalty_factor(model, 0.5);
  set_target(model, 0, 0, -0.1);
  ASSERT_EQ(solve_step(model, {}).outcome, solve::Outcome::converged);
  accept(model);
  const double force = reaction(model, 2)(1), pressure = resultant(model.present.contacts[0]).max_pressure;
  const Snapshot<2> saved = snapshot(model);
  set_penalty_factor(model, 1);
  set_target(model, 0, 0, -0.2);
  ASSERT_EQ(solve_step(model, {}).outcome, solve::Outcome::converged);
  rollback(model);
  EXPECT_EQ(model.present.penalty_factor, 0.5);
  EXPECT_NEAR(resultant(model.present.contacts[0]).max_pressure, pressure, 1e-13);
  EXPECT_NEAR(reaction(model, 2)(1), force, 1e-13);
  set_penalty_factor(model, 1);
  restore(model, saved);
  EXPECT_EQ(model.present.penalty_factor, 0.5);
  EXPECT_NEAR(resultant(model.present.contacts[0]).max_pressure, pressure, 1e-13);
  EXPECT_ERROR(set_penalty_factor(model, 0), "model.penalty.factor: factor = 0");
}

} // namespace augmented_test
} // namespace signorini::model
