// Strips bent by rotation of their ends: moments against beam theory and against the rate of the stored energy.
#include "model/scenes.hpp"
#include "text_of.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace signorini::model {
namespace bending_test {

using namespace test;
using std::numbers::pi;

constexpr double youngs_modulus = 2, poissons_ratio = 0.3;

/// A strip of unit height; its east end rotates with free translation, its west end is clamped or rotates, too.
Scene<2> strip(double length, int elements, const std::string& label, const solid::Material& material, bool both) {
  Scene<2> scene;
  scene.bodies.push_back({"strip", make_body(nurbs::rectangle(length, 1, Eigen::Vector2d(0, 0)), {elements, 2}, label,
                                             "south", material, 2)});
  Support<2> west{"west", {face_points(scene, 0, "west")}, {Constraint::fixed, Constraint::fixed}};
  west.rotates = both;
  west.center = face_centroid(*scene.bodies[0].body, nurbs::side_of("west", 2));
  Support<2> east{"east", {face_points(scene, 0, "east")}, {Constraint::free, Constraint::free}};
  east.rotates = true;
  east.center = face_centroid(*scene.bodies[0].body, nurbs::side_of("east", 2));
  scene.supports = {west, east};
  return scene;
}

void solve(Model<2>& model) {
  const solve::NewtonReport report = solve_step(model, {});
  ASSERT_EQ(report.outcome, solve::Outcome::converged) << text_of(report.messages);
  accept(model);
}

/// M = E I κ/(1 − ν²), I = H³/12.
double beam_moment(double curvature) {
  return youngs_modulus / (1 - poissons_ratio * poissons_ratio) / 12 * curvature;
}

/// At a given curvature the effect of the disturbances at the ends, about one height long, decreases with H/L.
TEST(Bending, MomentApproachesBeamTheoryAsTheStripBecomesSlender) {
  constexpr double curvature = 0.005;
  for (const solid::Material& material : {solid::Material(solid::neo_hookean(youngs_modulus, poissons_ratio)),
                                          solid::Material(solid::linear_elastic(youngs_modulus, poissons_ratio))}) {
    const bool linear = material.linear();
    std::vector<double> errors;
    for (int length : {10, 20, 40}) {
      Model<2> model(strip(length, 2 * length, "N3", material, false));
      // Hooke's law is limited to small rotations: its error increases with the square of the angle.
      const double bend = linear ? 1e-3 * curvature : curvature;
      set_target(model, 0, 0, bend * length * 180 / pi);
      solve(model);
      errors.push_back(moment(model, 1) / beam_moment(bend) - 1);
      EXPECT_NEAR(moment(model, 0), 0, 1e-15); // no rotating support
      EXPECT_NEAR(reaction(model, 1).norm(), 0, 1e-9 * moment(model, 1));
      EXPECT_NEAR(reaction(model, 0).norm(), 0, 1e-9 * moment(model, 1));
    }
    EXPECT_LT(errors[0], 0.005);
    EXPECT_NEAR(errors[0] / errors[1], 2, 0.05);
    EXPECT_NEAR(errors[1] / errors[2], 2, 0.05);
  }
}

/// Bent into more than half a circle by rotation of both ends: beam theory up to (κH)².
TEST(Bending, LargeRotationsAgreeWithBeamTheory) {
  constexpr double length = 40, step = 5;
  Model<2> model(strip(length, 40, "N2", solid::neo_hookean(youngs_modulus, poissons_ratio), true));
  for (double angle = step; angle <= 100; angle += step) {
    set_target(model, 0, 0, -angle);
    set_target(model, 1, 0, angle);
    solve(model);
    const double curvature = 2 * angle * pi / 180 / length;
    EXPECT_NEAR(moment(model, 1), beam_moment(curvature), 0.003 * beam_moment(curvature)) << angle;
    EXPECT_NEAR(moment(model, 0), -moment(model, 1), 1e-9 * moment(model, 1));
    EXPECT_NEAR(reaction(model, 1).norm(), 0, 1e-9 * moment(model, 1));
  }
}

/// M = dW/dθ along an accepted path, by central differences of the energy over the steps, whose error decreases with
/// the square of the step.
TEST(Bending, MomentIsTheRateOfTheStoredEnergy) {
  std::vector<double> errors;
  for (double step : {8.0, 4.0, 2.0}) {
    Model<2> model(strip(8, 8, "N2", solid::neo_hookean(youngs_modulus, poissons_ratio), false));
    std::vector<double> stored{0}, moments{0};
    for (double angle = step; angle <= 80; angle += step) {
      set_target(model, 0, 0, angle);
      solve(model);
      stored.push_back(energies(model).stored);
      moments.push_back(moment(model, 1));
    }
    double worst = 0;
    for (std::size_t k = 1; k + 1 < stored.size(); ++k) {
      const double rate = (stored[k + 1] - stored[k - 1]) / (2 * step * pi / 180);
      worst = std::max(worst, std::abs(rate - moments[k]) / moments.back());
    }
    errors.push_back(worst);
  }
  EXPECT_LT(errors[0], 1e-4);
  EXPECT_NEAR(errors[0] / errors[1], 4, 0.25);
  EXPECT_NEAR(errors[1] / errors[2], 4, 0.25);
}

} // namespace bending_test
} // namespace signorini::model
