// Diagnosis of provoked failures: outcome, places, messages.
#include "model/diagnosis/diagnosis.hpp"

#include "base/dense.hpp"
#include "model/diagnosis/weak_directions.hpp"
#include "model/scenes.hpp"
#include "solve/mumps.hpp"
#include "text_of.hpp"

#include <Eigen/Eigenvalues>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

namespace signorini::model {
namespace diagnosis_test {

using namespace test;
using solve::Outcome;

constexpr Constraint fixed = Constraint::fixed, free_to_move = Constraint::free, driven = Constraint::driven;

// ── Weak directions of matrices ──────────────────────────────────────────────────────────────────────────────────────

/// A dense matrix with its pattern.
struct Matrix {
  solve::Pattern pattern;
  std::vector<double> values;

  explicit Matrix(const MatrixX& full) {
    std::vector<int> all(static_cast<std::size_t>(full.rows()));
    std::iota(all.begin(), all.end(), 0);
    pattern = solve::couple(static_cast<int>(full.rows()), {all});
    for (int j = 0; j < pattern.size; ++j)
      for (int k = pattern.starts[j]; k < pattern.starts[static_cast<std::size_t>(j) + 1]; ++k)
        values.push_back(full(pattern.rows[k], j));
  }
};

/// An orthogonal matrix without zeros.
MatrixX turned(int n) {
  MatrixX random(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) random(i, j) = std::sin(1 + 3 * i + 7 * j + i * j);
  return dense::orthogonal(random);
}

TEST(WeakDirections, NullVectorOfAChainOfSprings) {
  constexpr int n = 12;
  MatrixX chain = MatrixX::Zero(n, n);
  for (int i = 0; i + 1 < n; ++i)
    chain.block<2, 2>(i, i) += (1 + 0.3 * i) * (Eigen::Matrix2d() << 1, -1, -1, 1).finished();
  const Matrix matrix(chain);
  const WeakDirection weak = null_direction(matrix.pattern, matrix.values, matrix.pattern.size);
  EXPECT_NEAR(weak.direction.norm(), 1, 1e-12);
  EXPECT_NEAR(std::abs(weak.direction.dot(VectorX::Constant(n, 1 / std::sqrt(double(n))))), 1, 1e-9);
  EXPECT_NEAR(weak.stiffness, 0, 1e-9);
}

TEST(WeakDirections, NullVectorOfAnUnsymmetricMatrix) {
  constexpr int n = 9;
  VectorX sizes = VectorX::LinSpaced(n, 1, 5);
  sizes(4) = 0;
  const MatrixX right = turned(n), left = turned(n + 1).topLeftCorner(n, n);
  const Matrix matrix(left * sizes.asDiagonal() * right.transpose());
  const WeakDirection weak = null_direction(matrix.pattern, matrix.values, matrix.pattern.size);
  EXPECT_NEAR(std::abs(weak.direction.dot(right.col(4))), 1, 1e-9);
}

TEST(WeakDirections, SoftestHasTheLowestOfTheEigenvaluesNearZero) {
  for (int n : {5, 40}) {
    VectorX stiffness = VectorX::LinSpaced(n, 2, 50);
    stiffness(1) = -0.5, stiffness(3) = 0.2;
    const MatrixX axes = turned(n);
    const Matrix matrix(axes * stiffness.asDiagonal() * axes.transpose());
    const WeakDirection weak = softest_direction(matrix.pattern, matrix.values, matrix.pattern.size);
    EXPECT_NEAR(weak.stiffness, -0.5, 1e-9);
    EXPECT_NEAR(std::abs(weak.direction.dot(axes.col(1))), 1, 1e-8);
  }
}

/// All negative eigenvalues count, also large ones, which inverse iteration does not find.
TEST(WeakDirections, MumpsCountsNegativeEigenvalues) {
  if (!solve::has_mumps()) GTEST_SKIP() << "built without MUMPS";
  constexpr int n = 40;
  const MatrixX axes = turned(n);
  for (const int negative : {0, 1, 3}) {
    VectorX stiffness = VectorX::LinSpaced(n, 0.3, 50);
    for (int k = 0; k < negative; ++k) stiffness(17 * k) *= -1;
    const Matrix matrix(axes * stiffness.asDiagonal() * axes.transpose());
    const WeakDirection weak =
        softest_direction(matrix.pattern, matrix.values, matrix.pattern.size, solve::LinearKind::mumps);
    EXPECT_EQ(weak.negative, negative);
    EXPECT_NEAR(weak.stiffness, negative == 0 ? 0 : -0.3, 1e-9);
    EXPECT_NEAR(weak.direction.norm(), negative == 0 ? 0 : 1, 1e-9);
  }
}

TEST(WeakDirections, SoftestUsesTheSymmetricPart) {
  constexpr int n = 10;
  const MatrixX axes = turned(n);
  MatrixX skew = turned(n);
  skew -= skew.transpose().eval();
  const MatrixX stiff = axes * VectorX::LinSpaced(n, 0.7, 9).asDiagonal() * axes.transpose();
  const Matrix matrix(stiff + 5 * skew);
  EXPECT_NEAR(softest_direction(matrix.pattern, matrix.values, matrix.pattern.size).stiffness, 0.7, 1e-9);
}

// ── Failed steps ─────────────────────────────────────────────────────────────────────────────────────────────────────

bool holds(const std::string& whole, const std::string& part) {
  return whole.find(part) != std::string::npos;
}

/// F = diag(1, 1 + d) everywhere at the first guess: J = 1 + d at X, x = X₂(1 + d).
TEST(Diagnosis, AnInvertedElementIsNamedWithItsPoint) {
  Model<2> model(square({{"bed", "south", {fixed, fixed}},
                         {"walls", "west", {fixed, free_to_move}},
                         {"far", "east", {fixed, free_to_move}},
                         {"top", "north", {fixed, driven}}}));
  set_target(model, 0, 0, -1.2);
  const solve::NewtonReport report = solve_step(model, {});
  ASSERT_EQ(report.outcome, Outcome::inverted_element);
  const Diagnosis diagnosis = diagnose(model, report);
  EXPECT_EQ(diagnosis.outcome, Outcome::inverted_element);
  ASSERT_EQ(diagnosis.places.size(), 1u);
  const FailurePlace& spot = diagnosis.places[0];
  EXPECT_EQ(spot.kind, "element");
  EXPECT_EQ(spot.where, "block");
  EXPECT_EQ(spot.index, 0);
  EXPECT_NEAR(spot.value, -0.2, 1e-9);
  EXPECT_EQ(bare_text(spot.what), "model.place.jacobian: jacobian = -0.2");
  EXPECT_NEAR(spot.current(0), spot.reference(0), 1e-9);
  EXPECT_NEAR(spot.current(1), spot.reference(1), 1e-9); // in the accepted state, not in the failed one
  EXPECT_TRUE(spot.reference(0) > 0 && spot.reference(0) < 0.5 && spot.reference(1) > 0 && spot.reference(1) < 0.5);
  EXPECT_TRUE(holds(text_of(diagnosis.messages), "model.step.inverted: element = 0, body = block, jacobian = -0.2"))
      << text_of(diagnosis.messages);
  EXPECT_TRUE(holds(text_of(diagnosis.remedies), "model.remedy.step")) << text_of(diagnosis.remedies);
}

/// Diagnosis of the first step of a square under a traction.
Diagnosis under_traction(const std::vector<Grip>& grips, bool pinned = false) {
  Scene<2> scene = square(grips);
  if (pinned) scene.supports.push_back({"pin", {corner(scene, 0, {0, 0})}, {fixed, fixed}});
  scene.loads = {{"wind", {{0, nurbs::side_of("north", 2)}}, LoadKind::traction, {0, 0}}};
  Model<2> model(std::move(scene));
  set_target(model, 0, 0, 0.1);
  set_target(model, 0, 1, -0.1);
  const solve::NewtonReport report = solve_step(model, {});
  EXPECT_EQ(report.outcome, Outcome::singular_tangent) << text_of(report.messages);
  return diagnose(model, report);
}

TEST(Diagnosis, ASingularTangentIsNamedWithItsMotion) {
  const Diagnosis along = under_traction({{"wall", "west", {fixed, free_to_move}}});
  ASSERT_EQ(along.messages.back().code, "model.diagnosis.moves");
  EXPECT_EQ(std::get<std::string>(along.messages.back().data[0].second), "block");
  const auto direction = std::get<std::vector<double>>(along.messages.back().data[1].second);
  EXPECT_NEAR(direction[0], 0, 1e-9);
  EXPECT_NEAR(std::abs(direction[1]), 1, 1e-9);
  ASSERT_EQ(along.places.size(), 3u);
  EXPECT_EQ(along.places[0].kind, "control point");
  EXPECT_EQ(along.places[0].where, "block");
  EXPECT_NEAR(along.places[0].value, 1 / std::sqrt(12.0), 1e-6); // 12 control points with equal motion
  EXPECT_TRUE(holds(text_of(along.remedies), "model.remedy.support"));

  // About the pinned corner the opposite one moves most.
  const Diagnosis turning = under_traction({}, true);
  EXPECT_TRUE(holds(text_of(turning.messages), "model.diagnosis.turns: body = block")) << text_of(turning.messages);
  EXPECT_EQ(turning.places[0].reference, VectorX(Eigen::Vector2d(1, 1)));
}

/// A perfect column compressed far beyond Euler's load, whose top would move sideways.
TEST(Diagnosis, AnIndefiniteTangentIsDetectedAfterAStall) {
  const auto press = [](double depth, int iterations) {
    Scene<2> scene;
    scene.bodies.push_back({"column", make_body(nurbs::rectangle(0.5, 10, Eigen::Vector2d(0, 0)), {1, 8}, "N3", "west",
                                                solid::neo_hookean(1, 0.3))});
    scene.supports = {{"bed", {face_points(scene, 0, "south")}, {fixed, fixed}},
                      {"top", {face_points(scene, 0, "north")}, {free_to_move, driven}}};
    Model<2> model(std::move(scene));
    set_target(model, 0, 0, -depth);
    StepOptions options;
    options.newton.iterations = iterations;
    const solve::NewtonReport report = solve_step(model, options);
    EXPECT_EQ(report.outcome, Outcome::iteration_limit);
    return diagnose(model, report);
  };
  // Clamped below and driven only in y above: buckles at a shortening of about (π t)²/(48 L) = 0.005.
  const Diagnosis beyond = press(0.1, 1);
  EXPECT_EQ(beyond.outcome, Outcome::indefinite);
  EXPECT_TRUE(holds(text_of(beyond.messages), "model.diagnosis.indefinite")) << text_of(beyond.messages);
  EXPECT_TRUE(holds(text_of(beyond.remedies), "model.remedy.first_step"));
  ASSERT_FALSE(beyond.places.empty());
  EXPECT_EQ(beyond.places[0].where, "column");
  EXPECT_GT(beyond.places[0].reference(1), 8);
  const Diagnosis before = press(0.002, 1);
  EXPECT_EQ(before.outcome, Outcome::iteration_limit);
  EXPECT_TRUE(holds(text_of(before.remedies), "model.remedy.iterations"));
  EXPECT_EQ(before.places.size(), before.unbalanced.size());
  EXPECT_EQ(before.places[0].index, before.unbalanced[0].index);
}

TEST(Diagnosis, UnbalancedForcesAreTheLargestOnes) {
  Model<2> model(square({{"bed", "south", {fixed, fixed}}, {"top", "north", {driven, driven}}}));
  set_target(model, 0, 0, 0.4);
  StepOptions options;
  options.newton.iterations = 2;
  const solve::NewtonReport report = solve_step(model, options);
  ASSERT_EQ(report.outcome, Outcome::iteration_limit);
  const Diagnosis diagnosis = diagnose(model, report);
  ASSERT_EQ(diagnosis.unbalanced.size(), 3u);
  std::vector<double> forces;
  const VectorX all = model.system.unknowns.spread(model.unbalanced);
  for (int a = 0; a < all.size() / 2; ++a) forces.push_back(all.segment<2>(2 * a).norm());
  std::sort(forces.rbegin(), forces.rend());
  for (std::size_t k = 0; k < 3; ++k) {
    const FailurePlace& spot = diagnosis.unbalanced[k];
    EXPECT_EQ(spot.value, forces[k]);
    EXPECT_EQ(all.segment<2>(2 * spot.index).norm(), forces[k]);
    EXPECT_EQ(spot.current, spot.reference);
  }
}

/// Pressing of deep ironing with a high penalty reaches a state at which one point alternates between two states.
TEST(Diagnosis, CyclingPointsAreNamed) {
  Scene<2> scene = ironing("N4");
  const nurbs::Patch arc = nurbs::half_annulus(0.3, 0.5, Eigen::Vector2d(0.75, 1.5));
  scene.bodies[0].body = make_body(arc, {6, 2}, "N4", "south", solid::neo_hookean(1e4, 0.3));
  scene.contacts[0].method = contact::InterfaceLaw{1000, 100, 0.1};
  scene.contacts[0].points = 7;
  Model<2> model(std::move(scene));
  solve::NewtonReport report;
  int step = 1;
  for (; step <= 46; ++step) {
    report = step_to(model, drive_of_grip, 0, -0.5 * step / 46);
    if (report.outcome != Outcome::converged) break;
    accept(model);
  }
  ASSERT_EQ(report.outcome, Outcome::cycling) << text_of(report.messages);
  EXPECT_GT(step, 20); // step and period depend on rounding error
  EXPECT_TRUE(holds(text_of(report.messages), "model.step.cycling: period = ")) << text_of(report.messages);
  const Diagnosis diagnosis = diagnose(model, report);
  EXPECT_EQ(diagnosis.outcome, Outcome::cycling);
  const auto cycling = model.active_set.cycling_points();
  ASSERT_EQ(diagnosis.places.size(), cycling.size());
  for (std::size_t k = 0; k < cycling.size(); ++k) {
    const FailurePlace& spot = diagnosis.places[k];
    EXPECT_EQ(spot.kind, "contact point");
    EXPECT_EQ(spot.where, "interface");
    const auto i = static_cast<std::size_t>(cycling[k].point);
    EXPECT_EQ(spot.index, model.system.contacts[0]->points().list[i].element);
    EXPECT_EQ(spot.reference, VectorX(model.system.contacts[0]->points().reference[i]));
    EXPECT_EQ(spot.current, VectorX(model.accepted.contacts[0].results[i].position));
    EXPECT_NEAR((spot.reference - Eigen::Vector2d(0.75, 1.5)).norm(), 0.5, 1e-9); // on the die
  }
  EXPECT_TRUE(holds(text_of(diagnosis.messages), "model.diagnosis.points: count = " + std::to_string(cycling.size()) +
                                                     ", contact = interface, element = "))
      << text_of(diagnosis.messages);
  EXPECT_TRUE(holds(text_of(diagnosis.remedies), "model.remedy.active_set"));

  // The path converges with line search.
  for (const auto kind : {solve::LineSearchKind::residual, solve::LineSearchKind::energy}) {
    rollback(model);
    StepOptions options;
    options.newton.line_search = kind;
    EXPECT_EQ(step_to(model, drive_of_grip, 0, -0.5 * 34 / 46, options).outcome, Outcome::converged);
  }
}

/// A soft bar on a ramp is pushed over the ramp's lower end, separates, comes back, …
TEST(Diagnosis, PointsThatLeaveTheMasterAreNamed) {
  const double angle = -25 * std::acos(-1) / 180, cosine = std::cos(angle), sine = std::sin(angle);
  const nurbs::Patch level = nurbs::rectangle(2, 0.5, Eigen::Vector2d(-2, -0.5));
  MatrixX points = level.points();
  const MatrixX turn = (Eigen::Matrix2d() << cosine, -sine, sine, cosine).finished();
  points = turn * points;
  const nurbs::Patch ramp =
      nurbs::make_patch({level.direction(0), level.direction(1)}, points, VectorX::Ones(points.cols()));
  Scene<2> scene;
  scene.bodies.push_back({"bar", make_body(nurbs::rectangle(0.1, 2, Eigen::Vector2d(-0.105, 0.1)), {2, 8}, "N2",
                                           "south", solid::linear_elastic(1, 0.3))});
  scene.bodies.push_back({"ramp", make_body(ramp, {100, 2}, "N2", "north", solid::linear_elastic(100, 0.3))});
  scene.supports = {{"top", {face_points(scene, 0, "north")}, {fixed, driven}},
                    {"bed", {face_points(scene, 1, "south")}, {fixed, fixed}}};
  scene.contacts = {{"edge",
                     {0, nurbs::side_of("south", 2)},
                     FaceReference{1, nurbs::side_of("north", 2)},
                     contact::InterfaceLaw{10},
                     3}};
  Model<2> model(std::move(scene));
  set_target(model, 0, 0, -0.0625);
  ASSERT_EQ(solve_step(model, {}).outcome, Outcome::converged);
  accept(model);
  set_target(model, 0, 0, -0.125);
  const solve::NewtonReport report = solve_step(model, {});
  EXPECT_EQ(report.outcome, Outcome::lost_projection) << text_of(report.messages);
  const Diagnosis diagnosis = diagnose(model, report);
  ASSERT_FALSE(diagnosis.places.empty());
  for (const FailurePlace& spot : diagnosis.places) {
    EXPECT_EQ(spot.kind, "contact point");
    EXPECT_EQ(spot.where, "edge");
    const std::string what = bare_text(spot.what);
    EXPECT_TRUE(what == "model.place.states: states = touching / beyond" ||
                what == "model.place.states: states = beyond / touching")
        << what;
    EXPECT_NEAR(spot.reference(1), 0.1, 1e-12);
  }
  EXPECT_TRUE(holds(text_of(diagnosis.remedies), "model.remedy.extend_master"));
}

TEST(Diagnosis, LineSearchAndNonfiniteNumbers) {
  Scene<2> scene = square({{"bed", "south", {fixed, fixed}}});
  scene.loads = {{"wind", {{0, nurbs::side_of("north", 2)}}, LoadKind::traction, {0, 0}}};
  Model<2> model(std::move(scene));
  set_target(model, 0, 0, 1e200); // its square overflows
  const solve::NewtonReport none = solve_step(model, {});
  EXPECT_EQ(none.outcome, Outcome::not_finite);
  const Diagnosis diagnosis = diagnose(model, none);
  EXPECT_EQ(diagnosis.outcome, Outcome::not_finite);
  EXPECT_TRUE(holds(text_of(diagnosis.messages), "solve.newton.not_finite"));
  rollback(model);
  set_target(model, 0, 0, 0.05);
  EXPECT_EQ(solve_step(model, {}).outcome, Outcome::converged);

  // A failed line search is diagnosed like any stall.
  solve::NewtonReport stalled = model.step->report;
  stalled.outcome = Outcome::line_search;
  const Diagnosis search = diagnose(model, stalled);
  EXPECT_EQ(search.outcome, Outcome::line_search);
  EXPECT_TRUE(holds(text_of(search.remedies), "model.remedy.no_line_search"));
  EXPECT_EQ(search.places.size(), 3u);
}

} // namespace diagnosis_test
} // namespace signorini::model
