// The factor on all penalties: a block between walls, pressed onto a plane.
#include "model/scenes.hpp"
#include "text_of.hpp"

#include <gtest/gtest.h>

namespace signorini::model {
namespace penalty_factor_test {

using namespace test;

const solid::NeoHookean material = solid::neo_hookean(2, 0.3);

Scene<2> pressed_block(double penalty) {
  Scene<2> scene = square({{"walls", "west", {Constraint::fixed, Constraint::free}},
                           {"far", "east", {Constraint::fixed, Constraint::free}},
                           {"top", "north", {Constraint::free, Constraint::driven}}},
                          material);
  scene.obstacles = {contact::make_plane<2>({0, 0}, {0, 1})};
  scene.contacts = {
      {"floor", {0, nurbs::side_of("south", 2)}, ObstacleReference{0}, contact::InterfaceLaw{penalty}, 4}};
  return scene;
}

/// The penalty factor is restored with its state.
TEST(PenaltyFactor, IsRestoredWithTheState) {
  Model<2> model(pressed_block(40));
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

} // namespace penalty_factor_test
} // namespace signorini::model
