// Models with rigid obstacles: driven obstacles, their reactions, and exact states on a plane.
#include "model/results/profile.hpp"
#include "model/scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace signorini::model {
namespace obstacle_test {

using namespace test;
using std::numbers::pi;

/// A slab, clamped below, under a disc that is pressed into it and slides; or a fixed disc and a moving slab.
Scene<2> indented(bool disc_moves, double mu) {
  Scene<2> scene;
  const nurbs::Patch block = nurbs::rectangle(2, 1, Eigen::Vector2d(-1, -1));
  scene.bodies.push_back({"slab", make_body(block, {10, 3}, "N2", "north", solid::neo_hookean(1, 0.3))});
  const Constraint moved = Constraint::driven, still = Constraint::fixed;
  const Constraint bottom = disc_moves ? still : moved, disc = disc_moves ? moved : still;
  scene.supports = {{"bed", {face_points(scene, 0, "south")}, {bottom, bottom}}, {"roll", {}, {disc, disc}, {0}}};
  scene.obstacles = {contact::make_ball<2>({0, 0.4}, 0.4)};
  scene.contacts = {
      {"rub", {0, nurbs::side_of("north", 2)}, ObstacleReference{0}, contact::InterfaceLaw{50, 50, mu}, 9}};
  return scene;
}

/// Only the relative motion matters; the reaction of the disc's support is transferred by contact to the bed.
TEST(Obstacle, DrivenObstacleIsEquivalentToADrivenBody) {
  for (double mu : {0.0, 0.3}) {
    Model<2> by_disc(indented(true, mu)), by_slab(indented(false, mu));
    for (int k = 1; k <= 12; ++k) {
      const double down = 0.15 * std::min(k, 6) / 6, along = 0.2 * std::max(k - 6, 0) / 6;
      ASSERT_EQ(step_to(by_disc, 0, along, -down).outcome, solve::Outcome::converged) << k;
      ASSERT_EQ(step_to(by_slab, 0, -along, down).outcome, solve::Outcome::converged) << k;
      accept(by_disc);
      accept(by_slab);
      const auto contact = resultant(by_disc.present.contacts[0]);
      const double size = contact.force.norm();
      EXPECT_GT(contact.active, 0);
      EXPECT_NEAR((resultant(by_slab.present.contacts[0]).force - contact.force).norm(), 0, 1e-8 * size);
      for (const Model<2>* model : {&by_disc, &by_slab}) {
        EXPECT_NEAR((model::reaction(*model, 1) - resultant(model->present.contacts[0]).force).norm(), 0, 1e-8 * size);
        EXPECT_NEAR((model::reaction(*model, 0) + model::reaction(*model, 1)).norm(), 0, 1e-8 * size);
      }
      if (k > 8) {
        EXPECT_EQ(contact.slipping > 0, mu > 0);
        EXPECT_EQ(contact.force(0) > 0, mu > 0); // dragged along
      }
    }
  }
}

/// A block on a plane between smooth walls: uniaxial strain until p = ε_N (depth − shortening).
TEST(Obstacle, BlockBetweenWallsOnAPlaneIsUniform) {
  const solid::NeoHookean material = solid::neo_hookean(2, 0.3);
  constexpr double penalty = 40, depth = 0.2;
  Scene<2> scene = square({{"walls", "west", {Constraint::fixed, Constraint::free}},
                           {"far", "east", {Constraint::fixed, Constraint::free}},
                           {"top", "north", {Constraint::free, Constraint::driven}}},
                          material);
  scene.obstacles = {contact::make_plane<2>({0, 0}, {0, 1})};
  scene.contacts = {
      {"floor", {0, nurbs::side_of("south", 2)}, ObstacleReference{0}, contact::InterfaceLaw{penalty}, 4}};
  Model<2> model(std::move(scene));
  set_target(model, 0, 0, -depth);
  ASSERT_EQ(solve_step(model, {}).outcome, solve::Outcome::converged);
  const auto floor = resultant(model.present.contacts[0]);
  // f = 1 − depth + penetration,  −P_yy = p
  const double p = floor.max_pressure, f = 1 - depth + p / penalty;
  EXPECT_NEAR(p, -(material.mu * f + (material.lambda * std::log(f) - material.mu) / f), 1e-9);
  EXPECT_NEAR(floor.force(1), p, 1e-12);
  EXPECT_NEAR(contact_area(model, 0, model.present.contacts[0]).area, 1, 1e-14);
  EXPECT_NEAR(floor.max_penetration, p / penalty, 1e-15);
  EXPECT_NEAR(reaction(model, 2)(1), -p, 1e-9);
}

/// Axisymmetric forces are those of the full circle.
TEST(Obstacle, AxisymmetricCylinderOnAPlane) {
  constexpr double radius = 1.5, penalty = 40, depth = 0.05;
  const solid::LinearElastic material = solid::linear_elastic(2, 0.3);
  Scene<2> scene;
  scene.kind = solid::Kind::axisymmetric;
  scene.bodies.push_back({"cylinder", make_body(nurbs::rectangle(radius, 1, Eigen::Vector2d(0, 0)), {3, 2}, "N2",
                                                "south", material, {}, solid::Kind::axisymmetric)});
  scene.supports = {
      {"axis", {face_points(scene, 0, "west"), face_points(scene, 0, "east")}, {Constraint::fixed, Constraint::free}},
      {"top", {face_points(scene, 0, "north")}, {Constraint::free, Constraint::driven}}};
  scene.obstacles = {contact::make_plane<2>({0, 0}, {0, 1})};
  scene.contacts = {
      {"floor", {0, nurbs::side_of("south", 2)}, ObstacleReference{0}, contact::InterfaceLaw{penalty}, 4}};
  Model<2> model(std::move(scene));
  set_target(model, 0, 0, -depth);
  ASSERT_EQ(solve_step(model, {}).outcome, solve::Outcome::converged);
  // p = (λ + 2μ) ε = ε_N (depth − ε)
  const double modulus = material.lambda + 2 * material.mu, p = modulus * penalty * depth / (modulus + penalty);
  EXPECT_NEAR(resultant(model.present.contacts[0]).max_pressure, p, 1e-10);
  EXPECT_NEAR(resultant(model.present.contacts[0]).force(1), p * pi * radius * radius, 1e-9);
  EXPECT_NEAR(contact_area(model, 0, model.present.contacts[0]).area, pi * radius * radius, 1e-12);
  EXPECT_NEAR(reaction(model, 1)(1), -p * pi * radius * radius, 1e-9);
}

} // namespace obstacle_test
} // namespace signorini::model
