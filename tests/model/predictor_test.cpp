// Different predictors lead to the same states.
#include "model/scenes.hpp"

#include "model/system/drives.hpp"
#include "text_of.hpp"

#include <gtest/gtest.h>

namespace signorini::model {
namespace predictor_test {

using namespace test;

StepOptions with(Predictor predictor) {
  StepOptions options;
  options.predictor = predictor;
  return options;
}

constexpr Predictor all[] = {Predictor::tangent, Predictor::constant, Predictor::linear};

/// Numbers of iterations of the accepted steps of a path.
int walk(Model<2>& model, const std::function<void(int)>& set_targets, int steps, Predictor predictor) {
  int iterations = 0;
  for (int step = 1; step <= steps; ++step) {
    set_targets(step);
    const solve::NewtonReport report = solve_step(model, with(predictor));
    EXPECT_EQ(report.outcome, solve::Outcome::converged) << step << ": " << text_of(report.messages);
    iterations += report.iterations;
    accept(model);
  }
  return iterations;
}

/// Checks that states are equal up to `tolerance`; returns the iterations of `tangent`, `constant` and `linear`.
std::vector<int> compare(const std::function<Scene<2>()>& scene, const std::function<void(Model<2>&, int)>& set_targets,
                         int steps, double tolerance) {
  std::vector<int> iterations;
  VectorX reference;
  for (Predictor predictor : all) {
    Model<2> model(scene());
    iterations.push_back(walk(
        model, [&](int step) { set_targets(model, step); }, steps, predictor));
    if (predictor == Predictor::tangent) reference = model.present.displacement;
    EXPECT_LT((model.present.displacement - reference).cwiseAbs().maxCoeff(), tolerance);
  }
  return iterations;
}

void iron(Model<2>& model, int step) {
  const double press = std::min(step, 46) / 46.0, slide = std::max(step - 46, 0) / 250.0;
  set_target(model, drive_of_grip, 0, 1.5 * slide);
  set_target(model, drive_of_grip, 1, -0.23 * press);
}

TEST(Predictor, LinearPredictorSavesIterationsInIroning) {
  const auto iterations = compare([] { return ironing("N2"); }, iron, 86, 1e-9);
  EXPECT_LT(iterations[2], 0.9 * iterations[0]);
}

/// Without two similar steps before, at the start of the path and where it is not straight, the linear predictor is the
/// tangent one.
TEST(Predictor, LinearIsTangentWhereThePathIsNotStraight) {
  Model<2> linear(ironing("N2")), tangent(ironing("N2"));
  for (int step = 1; step <= 50; ++step) {
    restore(linear, snapshot(tangent)); // both start from the state of `tangent`
    iron(linear, step);
    iron(tangent, step);
    const double first = solve_step(linear, with(Predictor::linear)).residuals.front();
    const double reference = solve_step(tangent, with(Predictor::tangent)).residuals.front();
    if (step <= 2 || step == 47 || step == 48) {
      EXPECT_NEAR(first, reference, 1e-9 * reference) << step;
    } else {
      EXPECT_LT(first, 0.1 * reference) << step;
    }
    // First touches are foreseen from either guess.
    EXPECT_LT((linear.present.displacement - tangent.present.displacement).cwiseAbs().maxCoeff(), 1e-5);
    accept(tangent);
  }
}

TEST(Predictor, FirstGuessesSatisfyPrescribedDisplacements) {
  Model<2> model(ironing("N2"));
  for (int step = 1; step <= 3; ++step) {
    iron(model, step);
    const solve::NewtonReport first = iterate(model, with(step <= 2 ? Predictor::constant : Predictor::linear));
    EXPECT_EQ(first.outcome, solve::Outcome::iterating);
    for (int dof : model.system.unknowns.of_support(grip, 1))
      EXPECT_NEAR(model.present.displacement(dof), -0.23 * step / 46, 1e-16) << step;
    solve_step(model, {});
    accept(model);
  }
}

/// A strip with a rotating end: positions are nonlinear functions of the target.
TEST(Predictor, RotatingSupports) {
  const auto scene = [] {
    Scene<2> strip;
    strip.bodies.push_back({"strip", make_body(nurbs::rectangle(6, 1, Eigen::Vector2d(0, 0)), {6, 1}, "N2", "south",
                                               solid::neo_hookean(2, 0.3), 2)});
    Support<2> east{"east", {face_points(strip, 0, "east")}, {Constraint::free, Constraint::free}};
    east.rotates = true;
    east.center = face_centroid(*strip.bodies[0].body, nurbs::side_of("east", 2));
    strip.supports = {{"west", {face_points(strip, 0, "west")}, {Constraint::fixed, Constraint::fixed}}, east};
    return strip;
  };
  const auto iterations = compare(
      scene, [](Model<2>& model, int step) { set_target(model, 0, 0, 4.0 * step); }, 15, 1e-9);
  EXPECT_LT(iterations[2], iterations[0]);
}

TEST(Predictor, Loads) {
  const auto scene = [] {
    Scene<2> bar = square({{"bed", "south", {Constraint::fixed, Constraint::fixed}}});
    bar.loads = {{"pull", {{0, nurbs::side_of("north", 2)}}, LoadKind::traction, {0, 0}}};
    return bar;
  };
  const auto set = [](Model<2>& model, int step) { set_target(model, 0, 1, 0.02 * step); };
  const auto iterations = compare(scene, set, 10, 1e-9);
  EXPECT_LE(iterations[2], iterations[0]);
  // The linear predictor saves iterations from the third step on.
  Model<2> model(scene());
  for (int step = 1; step <= 5; ++step) {
    set(model, step);
    const double plain = solve_step(model, with(Predictor::constant)).residuals.front();
    rollback(model);
    set(model, step);
    const double linear = solve_step(model, with(Predictor::linear)).residuals.front();
    if (step <= 2) {
      EXPECT_EQ(linear, plain);
    } else {
      EXPECT_LT(linear, 0.2 * plain) << step;
    }
    accept(model);
  }
}

TEST(Predictor, RestoredStatesContinueAsBefore) {
  Model<2> model(ironing("N2"));
  walk(
      model, [&](int step) { iron(model, step); }, 5, Predictor::linear);
  const Snapshot<2> saved = snapshot(model);
  iron(model, 6);
  const auto residuals = solve_step(model, with(Predictor::linear)).residuals;
  const VectorX reached = model.present.displacement;
  accept(model);
  iron(model, 9);
  solve_step(model, with(Predictor::linear));
  accept(model);
  for (int again = 0; again < 2; ++again) {
    restore(model, saved);
    iron(model, 6);
    const auto once_more = solve_step(model, with(Predictor::linear)).residuals;
    EXPECT_EQ(once_more.size(), residuals.size());
    EXPECT_NEAR(once_more.front(), residuals.front(), 1e-9 * residuals.front());
    EXPECT_LT((model.present.displacement - reached).cwiseAbs().maxCoeff(), 1e-12);
  }
}

} // namespace predictor_test
} // namespace signorini::model
