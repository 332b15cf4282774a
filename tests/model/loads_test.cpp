// Dead loads: exact states under tractions and pressures, loads as targets, and initial loads.
#include "model/results/sample.hpp"
#include "model/scenes.hpp"
#include "text_of.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace signorini::model {
namespace loads_test {

using namespace test;

const solid::Material laws[] = {solid::neo_hookean(2, 0.3), solid::linear_elastic(2, 0.3)};

FaceReference face(const std::string& name) {
  return {0, nurbs::side_of(name, 2)};
}

double value(const Model<2>& model, const std::string& field, const Vec<2>& xi) {
  return sample(model, 0, find_field<2>(field), xi);
}

/// P at a point, from its deformation gradient.
Mat<2> stress(const Model<2>& model, const Vec<2>& xi) {
  Mat<2> f;
  f << value(model, "F11", xi), value(model, "F12", xi), value(model, "F21", xi), value(model, "F22", xi);
  return model.system.scene.bodies[0].body->material().stress(solid::in_space<2>(f)).topLeftCorner<2, 2>();
}

void expect_stress(const Model<2>& model, const Mat<2>& expected, double scale) {
  for (double x : {0.1, 0.5, 0.95})
    for (double y : {0.0, 0.6, 1.0}) {
      const Mat<2> p = stress(model, {x, y});
      EXPECT_NEAR((p - expected).norm(), 0, 1e-9 * scale) << "at " << x << ", " << y;
    }
}

/// A bar pulled at its east side, free to contract: P = diag(t, 0) everywhere.
Scene<2> bar(const solid::Material& material, const Vec<2>& start) {
  Scene<2> scene = square({{"wall", "west", {Constraint::fixed, Constraint::free}},
                           {"bed", "south", {Constraint::free, Constraint::fixed}}},
                          material);
  scene.loads = {{"pull", {face("east")}, LoadKind::traction, {start(0), start(1)}}};
  return scene;
}

TEST(Loads, TractionOnABarGivesItsStressAndReaction) {
  for (const solid::Material& material : laws)
    for (int steps : {1, 5}) {
      Model<2> model(bar(material, {0, 0}));
      constexpr double t = 0.4;
      for (int k = 1; k <= steps; ++k) {
        set_target(model, 0, 0, t * k / steps);
        const auto report = solve_step(model, {});
        ASSERT_EQ(report.outcome, solve::Outcome::converged) << text_of(report.messages);
        accept(model);
        expect_stress(model, Vec<2>(t * k / steps, 0).asDiagonal(), t);
        EXPECT_NEAR((load_resultant(model, 0) - Vec<2>(t * k / steps, 0)).norm(), 0, 1e-14);
        EXPECT_NEAR((reaction(model, 0) + Vec<2>(t * k / steps, 0)).norm(), 0, 1e-10);
        EXPECT_NEAR(reaction(model, 1).norm(), 0, 1e-10);
        EXPECT_EQ(accepted_target(model, 0, 0), t * k / steps);
      }
      if (material.linear()) {
        // Plane strain: ε_x = (1 − ν²) t/E, ε_y = −ν(1 + ν) t/E
        EXPECT_NEAR(value(model, "ux", {1, 0.3}), (1 - 0.09) * t / 2, 1e-12);
        EXPECT_NEAR(value(model, "uy", {0.3, 1}), -0.3 * 1.3 * t / 2, 1e-12);
        EXPECT_NEAR(value(model, "szz", {0.3, 1}), 0.3 * t, 1e-10);
      }
    }
}

/// A pressure on all sides: P = −p I for both laws, with zero reactions of the supports.
TEST(Loads, PressureAllAroundIsHydrostatic) {
  for (const solid::Material& material : laws) {
    Scene<2> scene = square({}, material);
    scene.supports = {{"pin", {corner(scene, 0, {0, 0})}, {Constraint::fixed, Constraint::fixed}},
                      {"foot", {corner(scene, 0, {1, 0})}, {Constraint::free, Constraint::fixed}}};
    scene.loads = {{"sea", {face("west"), face("east"), face("south"), face("north")}, LoadKind::pressure, {0}}};
    Model<2> model(std::move(scene));
    constexpr double p = 0.5;
    set_target(model, 0, 0, p);
    ASSERT_EQ(solve_step(model, {}).outcome, solve::Outcome::converged);
    accept(model);
    expect_stress(model, -p * Mat<2>::Identity(), p);
    EXPECT_NEAR(load_resultant(model, 0).norm(), 0, 1e-14);
    EXPECT_NEAR(reaction(model, 0).norm(), 0, 1e-10);
    EXPECT_NEAR(reaction(model, 1).norm(), 0, 1e-10);
    if (material.linear()) {
      EXPECT_NEAR(value(model, "ux", {1, 0.5}), -(1 + 0.3) * (1 - 0.6) * p / 2, 1e-12);
    }
  }
}

/// The start value of a load acts from the first step without being set as target.
TEST(Loads, StartValueActsFromTheFirstStep) {
  for (const solid::Material& material : laws) {
    Model<2> model(bar(material, {0.3, 0}));
    EXPECT_EQ(accepted_target(model, 0, 0), 0.3);
    ASSERT_EQ(solve_step(model, {}).outcome, solve::Outcome::converged);
    accept(model);
    expect_stress(model, Vec<2>(0.3, 0).asDiagonal(), 0.3);
    // Removed again
    set_target(model, 0, 0, 0);
    ASSERT_EQ(solve_step(model, {}).outcome, solve::Outcome::converged);
    accept(model);
    EXPECT_NEAR(model.present.displacement.norm(), 0, 1e-9);
  }
}

TEST(Loads, RollbackRestoresTheLoad) {
  Model<2> model(bar(laws[0], {0.2, 0}));
  ASSERT_EQ(solve_step(model, {}).outcome, solve::Outcome::converged);
  accept(model);
  const VectorX accepted = model.present.displacement;
  const Vec<2> force = reaction(model, 0), load = load_resultant(model, 0);
  StepOptions cut;
  cut.newton.iterations = 1;
  set_target(model, 0, 0, 0.8);
  ASSERT_NE(solve_step(model, cut).outcome, solve::Outcome::converged);
  rollback(model);
  EXPECT_EQ(model.present.displacement, accepted);
  EXPECT_EQ(reaction(model, 0), force);
  EXPECT_EQ(load_resultant(model, 0), load);
  // The target is restored, too: the next step changes nothing.
  const auto report = solve_step(model, {});
  EXPECT_EQ(report.outcome, solve::Outcome::converged);
  EXPECT_EQ(report.iterations, 0);
}

/// A load on a supported face acts on the support; two loads are summed.
TEST(Loads, ReactionsBalanceAllLoads) {
  for (const solid::Material& material : laws) {
    Scene<2> scene = square({{"bed", "south", {Constraint::fixed, Constraint::fixed}}}, material);
    scene.loads = {{"wind", {face("west"), face("south")}, LoadKind::traction, {0.05, -0.02}},
                   {"gas", {face("north")}, LoadKind::pressure, {0.1}}};
    Model<2> model(std::move(scene));
    ASSERT_EQ(solve_step(model, {}).outcome, solve::Outcome::converged);
    accept(model);
    EXPECT_NEAR((load_resultant(model, 0) - Vec<2>(0.1, -0.04)).norm(), 0, 1e-14);
    EXPECT_NEAR((load_resultant(model, 1) - Vec<2>(0, -0.1)).norm(), 0, 1e-14);
    EXPECT_NEAR((reaction(model, 0) - Vec<2>(-0.1, 0.14)).norm(), 0, 1e-10);
  }
}

/// Axisymmetric forces are those of the full circle: a disc of radius 1.5 pulled at both ends.
TEST(Loads, AxisymmetricLoadsActOnTheFullCircle) {
  for (const solid::Material& material : laws) {
    Scene<2> scene;
    scene.kind = solid::Kind::axisymmetric;
    scene.bodies.push_back({"disc", make_body(nurbs::rectangle(1.5, 1, Eigen::Vector2d(0, 0)), {2, 2}, "N2", "north",
                                              material, {}, solid::Kind::axisymmetric)});
    scene.supports = {{"axis", {face_points(scene, 0, "west")}, {Constraint::fixed, Constraint::free}},
                      {"bed", {face_points(scene, 0, "south")}, {Constraint::free, Constraint::fixed}}};
    scene.loads = {{"pull", {face("north")}, LoadKind::traction, {0, 0.3}}};
    Model<2> model(std::move(scene));
    ASSERT_EQ(solve_step(model, {}).outcome, solve::Outcome::converged);
    accept(model);
    const double force = 0.3 * std::acos(-1.0) * 1.5 * 1.5;
    EXPECT_NEAR(load_resultant(model, 0)(1), force, 1e-12);
    EXPECT_NEAR(reaction(model, 1)(1), -force, 1e-9);
    // Uniaxial: no stress normal to the axis, force over reference area along it
    for (double x : {0.0, 0.7}) {
      EXPECT_NEAR(value(model, "sxx", {x, 0.4}), 0, 1e-9);
      EXPECT_NEAR(value(model, "szz", {x, 0.4}), 0, 1e-9);
      const double across = material.linear() ? 1 : value(model, "F11", {x, 0.4});
      EXPECT_NEAR(value(model, "syy", {x, 0.4}) * across * across, 0.3, 1e-9);
    }
  }
}

} // namespace loads_test
} // namespace signorini::model
