// Fields of both laws in plane strain and axisymmetric, also on the axis.
#include "model/results/sample.hpp"
#include "model/scenes.hpp"
#include "nurbs/plan.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace signorini::model {
namespace field_test {

using namespace test;

/// A disc of radius 1.5 and height 0.5 (plane strain: a rectangle) with given supports on its faces.
Scene<2> disc(const solid::Material& material, solid::Kind kind, const std::vector<Grip>& grips) {
  const auto space = std::make_shared<const nurbs::Discretization>(nurbs::rectangle(1.5, 0.5, Eigen::Vector2d(0, 0)),
                                                                   nurbs::test::plan_of({3, 2}, "north", "N2", 2));
  Scene<2> scene;
  scene.kind = kind;
  scene.bodies.push_back({"disc", std::make_shared<const solid::Body<2>>(space, material, kind)});
  for (const Grip& grip : grips)
    scene.supports.push_back({grip.name, {face_points(scene, 0, grip.face)}, grip.constraint});
  return scene;
}

double value(const Model<2>& model, const std::string& field, double xi, double eta) {
  return sample(model, 0, find_field<2>(field), Eigen::Vector2d(xi, eta));
}

/// The rim moves by 0.3 of 1.5 between lids at constant height: stretches are a = 1.2 along r, 1 along z, and a again
/// in the hoop direction, or 1 in plane strain.
TEST(Field, StressesAreThoseOfTheHomogeneousState) {
  const auto rubber = solid::neo_hookean(2, 0.3);
  const auto steel = solid::linear_elastic(2, 0.3);
  const std::vector<Grip> grips = {{"rim", "east", {Constraint::driven, Constraint::free}},
                                   {"axis", "west", {Constraint::fixed, Constraint::free}},
                                   {"bottom", "south", {Constraint::free, Constraint::fixed}},
                                   {"top", "north", {Constraint::free, Constraint::fixed}}};
  for (const solid::Kind kind : {solid::Kind::plane_strain, solid::Kind::axisymmetric}) {
    const double a = 1.2, hoop = kind == solid::Kind::axisymmetric ? a : 1.0;
    // σ_i = (λ ln J + μ (F_ii² − 1))/J, and λ tr ε + 2 μ ε_i
    const double j = a * hoop, trace = (a - 1) + (hoop - 1);
    const auto of_rubber = [&](double f) { return (rubber.lambda * std::log(j) + rubber.mu * (f * f - 1)) / j; };
    const auto of_steel = [&](double f) { return steel.lambda * trace + 2 * steel.mu * (f - 1); };
    for (const bool linear : {false, true}) {
      const auto expected = [&](double f) { return linear ? of_steel(f) : of_rubber(f); };
      Model<2> model(linear ? disc(steel, kind, grips) : disc(rubber, kind, grips));
      set_target(model, 0, 0, 0.3);
      ASSERT_EQ(solve_step(model, {}).outcome, solve::Outcome::converged);
      for (double xi : {0.0, 1e-12, 0.3, 1.0})
        for (double eta : {0.0, 0.7}) {
          EXPECT_NEAR(value(model, "sxx", xi, eta), expected(a), 1e-9);
          EXPECT_NEAR(value(model, "syy", xi, eta), expected(1), 1e-9);
          EXPECT_NEAR(value(model, "szz", xi, eta), expected(hoop), 1e-9);
          EXPECT_NEAR(value(model, "I1", xi, eta), expected(a) + expected(1) + expected(hoop), 1e-9);
          EXPECT_NEAR(value(model, "F11", xi, eta), a, 1e-9);
        }
    }
  }
}

/// Pressed against a rough bottom the state is inhomogeneous: on the axis radial and hoop stress are equal, and values
/// near it approach values on it.
TEST(Field, StressesAreContinuousUpToTheAxis) {
  Model<2> model(disc(solid::neo_hookean(2, 0.3), solid::Kind::axisymmetric,
                      {{"top", "north", {Constraint::free, Constraint::driven}},
                       {"bottom", "south", {Constraint::fixed, Constraint::fixed}},
                       {"axis", "west", {Constraint::fixed, Constraint::free}}}));
  set_target(model, 0, 0, -0.1);
  ASSERT_EQ(solve_step(model, {}).outcome, solve::Outcome::converged);
  for (double eta : {0.2, 0.9}) {
    EXPECT_NEAR(value(model, "sxx", 0, eta), value(model, "szz", 0, eta), 1e-13);
    for (const char* field : {"sxx", "syy", "szz", "von_mises"})
      EXPECT_NEAR(value(model, field, 1e-7, eta), value(model, field, 0, eta), 1e-6) << field;
    EXPECT_GT(std::abs(value(model, "szz", 0.9, eta) - value(model, "szz", 0, eta)), 1e-2);
  }
}

/// A block of one element of order N4.
Scene<2> block(const nurbs::Patch& patch) {
  const auto space = std::make_shared<const nurbs::Discretization>(patch, nurbs::test::plan_of({1, 1}, "north", "N4"));
  Scene<2> scene;
  scene.bodies.push_back(
      {"block", std::make_shared<const solid::Body<2>>(space, solid::neo_hookean(1, 0.3), solid::Kind::plane_strain)});
  scene.supports.push_back({"bed", {face_points(scene, 0, "south")}, {Constraint::fixed, Constraint::fixed}});
  return scene;
}

/// Displaces the block by u_x = Σ power_j ξ₁ʲ, whose Bézier coefficients are Σ_j C(i, j)/C(4, j) power_j.
void stretch(Model<2>& model, const std::array<double, 5>& power) {
  const auto choose = [](int n, int k) { return std::tgamma(n + 1) / std::tgamma(k + 1) / std::tgamma(n - k + 1); };
  const solid::Body<2>& body = *model.system.scene.bodies[0].body;
  for (int k = 0; k < body.functions(); ++k) {
    const int i = static_cast<int>(std::lround(4 * body.space().points()(0, k)));
    double u = 0;
    for (int j = 0; j <= i; ++j) u += choose(i, j) / choose(4, j) * power[j];
    model.present.displacement(2 * k) = u;
  }
}

/// u_x(x) with u_x′ = −1 + 200 ((x − a)² − 0.003) inverts the body around a = 0.365, between Gauss points, where the
/// law is evaluated and det F is positive: stresses there are those of the nearest Gauss point.
TEST(Field, StressesAreFiniteBetweenGaussPointsWhereTheBodyIsInverted) {
  constexpr double a = 0.365;
  const std::array<double, 5> power{0, -1 + 200 * (a * a - 0.003), -200 * a, 200 / 3.0, 0};
  Model<2> model(block(nurbs::rectangle(1, 1, Eigen::Vector2d(0, 0))));
  stretch(model, power);
  EXPECT_NEAR(value(model, "ux", 0.5, 0.5), power[1] / 2 + power[2] / 4 + power[3] / 8, 1e-13);
  EXPECT_NEAR(value(model, "F11", 0.45, 0.5), 200 * (0.085 * 0.085 - 0.003), 1e-10);
  const double gauss = 0.5 - std::sqrt(5 - 2 * std::sqrt(10.0 / 7)) / 6; // the second of five
  for (const char* field : {"sxx", "szz", "von_mises"}) {
    EXPECT_TRUE(std::isfinite(value(model, field, a, 0.5)));
    EXPECT_NEAR(value(model, field, 0.4, 0.5), value(model, field, 0.5, 0.5), 1e-9) << field;
    EXPECT_NEAR(value(model, field, 0.34, 0.5), value(model, field, gauss, 0.5), 1e-9) << field;
  }
}

/// A triangle whose west side is a point, with u_x′ = −1.5 + 40 x: gradients at the pole are those a little inside,
/// where det F = −0.5, too; stresses are those of the first Gauss points.
TEST(Field, StressesAreFiniteAtAPoleWhereTheBodyIsInverted) {
  const nurbs::Patch triangle = nurbs::make_patch({nurbs::KnotVector::single(1), nurbs::KnotVector::single(1)},
                                                  (MatrixX(2, 4) << 0, 1, 0, 1, 0, -0.5, 0, 0.5).finished());
  Model<2> model(block(triangle));
  stretch(model, {0, -1.5, 20, 0, 0});
  const double gauss = 0.5 - std::sqrt(5 + 2 * std::sqrt(10.0 / 7)) / 6; // the first of five
  EXPECT_NEAR(value(model, "F11", gauss, 0.5), -0.5 + 40 * gauss, 1e-10);
  for (const char* field : {"sxx", "szz", "von_mises"}) {
    EXPECT_TRUE(std::isfinite(value(model, field, gauss, 0.5)));
    EXPECT_NEAR(value(model, field, 0, 0.5), value(model, field, gauss, 0.5), 1e-9) << field;
  }
}

} // namespace field_test
} // namespace signorini::model
