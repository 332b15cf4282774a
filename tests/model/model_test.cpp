// Supports, reactions, accept and roll-back, and independence of the solution of solver and history.
#include "model/results/results.hpp"
#include "model/scene/check.hpp"
#include "model/steps/arc.hpp"
#include "model/steps/load_step.hpp"

#include "model/results/sample.hpp"
#include "model/scenes.hpp"
#include "text_of.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace signorini::model {
namespace model_test {

using namespace test;

TEST(Unknowns, NumberFreeComponents) {
  const Scene<2> scene = square({{"bed", "south", {Constraint::fixed, Constraint::fixed}},
                                 {"top", "north", {Constraint::free, Constraint::driven}}});
  const Unknowns<2> unknowns(scene);
  const int functions = scene.bodies[0].body->functions();
  EXPECT_EQ(functions, 4 * 3);
  EXPECT_EQ(unknowns.dofs(), 2 * functions);
  EXPECT_EQ(unknowns.size(), 2 * functions - 3 * 4);
  EXPECT_EQ(unknowns.of_support(1, 0).size(), 4u);
  EXPECT_EQ(unknowns.of_support(1, 1).size(), 4u);
  int next = 0;
  for (int dof = 0; dof < unknowns.dofs(); ++dof) {
    EXPECT_EQ(unknowns.unknown(dof), unknowns.constrained(dof) ? -1 : next);
    next += !unknowns.constrained(dof);
  }
  EXPECT_EQ(next, unknowns.size());
  for (int dof : unknowns.of_support(1, 0)) EXPECT_FALSE(unknowns.constrained(dof));
  for (int dof : unknowns.of_support(1, 1)) EXPECT_TRUE(unknowns.constrained(dof));
  const VectorX values = VectorX::LinSpaced(unknowns.size(), 1, 2);
  EXPECT_EQ(unknowns.gather(unknowns.spread(values)), values);
}

TEST(Unknowns, SupportsMustNotContradictEachOther) {
  const auto build = [](const std::vector<Grip>& grips) {
    Scene<2> scene = square(grips);
    complete(scene);
  };
  const Constraint fixed = Constraint::fixed, driven = Constraint::driven, free = Constraint::free;
  EXPECT_ERROR(build({{"bed", "south", {fixed, fixed}}, {"grip", "west", {driven, free}}}),
               "model.scene.constrained_twice: support = grip, verb = (model.verb.drives), component = x, other = bed, "
               "other_verb = (model.verb.fixes)");
  EXPECT_ERROR(build({{"grip", "west", {free, driven}}, {"bed", "south", {fixed, fixed}}}),
               "model.scene.constrained_twice: support = bed, verb = (model.verb.fixes), component = y, other = grip, "
               "other_verb = (model.verb.drives)");
  EXPECT_ERROR(
      build({{"a", "west", {driven, free}}, {"b", "north", {driven, free}}}),
      "model.scene.constrained_twice: support = b, verb = (model.verb.drives), component = x, other = a, other_verb "
      "= (model.verb.drives)");
  build({{"bed", "south", {fixed, fixed}}, {"wall", "west", {fixed, free}}, {"top", "north", {free, driven}}});
}

TEST(Model, InvalidScenesAreErrors) {
  EXPECT_ERROR(Model<2>(Scene<2>{}), "model.scene.no_body");
  Scene<2> self = ironing("N2");
  self.contacts[0].master = self.contacts[0].slave;
  std::get<Faces>(self.contacts[0].master).push_back(std::get<Faces>(ironing("N2").contacts[0].master).front());
  EXPECT_ERROR(Model<2>(std::move(self)), "model.scene.own_face: contact = interface");
  Scene<2> kinds = square({{"bed", "south", {Constraint::fixed, Constraint::fixed}}});
  kinds.kind = solid::Kind::axisymmetric;
  EXPECT_ERROR(Model<2>(std::move(kinds)), "model.scene.kind: body = block");
}

/// Confined compression: F = diag(1, 1 + d), P_yy = μ F + (λ ln F − μ)/F, by one step and by many.
TEST(Model, PrescribedDisplacementsAreReached) {
  const auto material = solid::neo_hookean(1, 0.3);
  const auto scene = [] {
    return square({{"bed", "south", {Constraint::fixed, Constraint::fixed}},
                   {"walls", "west", {Constraint::fixed, Constraint::free}},
                   {"far", "east", {Constraint::fixed, Constraint::free}},
                   {"top", "north", {Constraint::free, Constraint::driven}}});
  };
  for (int steps : {1, 4}) {
    Model<2> model(scene());
    for (int k = 1; k <= steps; ++k) {
      set_target(model, 0, 0, -0.3 * k / steps);
      const auto report = solve_step(model, {});
      ASSERT_EQ(report.outcome, solve::Outcome::converged) << text_of(report.messages);
      accept(model);
      EXPECT_EQ(accepted_target(model, 0, 0), -0.3 * k / steps);
    }
    const double f = 0.7, stress = material.mu * f + (material.lambda * std::log(f) - material.mu) / f;
    EXPECT_NEAR(reaction(model, 3)(1), stress, 1e-10);
    EXPECT_NEAR(reaction(model, 0)(1), -stress, 1e-10);
    EXPECT_NEAR((reaction(model, 1) + reaction(model, 2)).norm(), 0, 1e-10);
    for (int dof : model.system.unknowns.of_support(3, 1)) EXPECT_NEAR(model.present.displacement(dof), -0.3, 1e-15);
    EXPECT_NEAR(energies(model).stored, material.energy(Eigen::Vector3d(1, f, 1).asDiagonal()), 1e-12);
    const auto point = body_point(model, 0, 0, Eigen::Vector2d(0.2, 0.3));
    EXPECT_NEAR((point.reference - Eigen::Vector2d(0.2, 0.3)).norm(), 0, 1e-15);
    EXPECT_NEAR((point.state.displacement - Eigen::Vector2d(0, -0.3 * 0.3)).norm(), 0, 1e-12);
    EXPECT_NEAR(sample(model, 0, find_field<2>("F22"), Eigen::Vector2d(0.9, 0.9)), f, 1e-12);
    EXPECT_NEAR(sample(model, 0, find_field<2>("syy"), Eigen::Vector2d(0.9, 0.9)), stress, 1e-10);
  }
}

TEST(Model, UnconstrainedBodyIsSingular) {
  for (auto kind : {solve::LinearKind::klu, solve::LinearKind::umfpack}) {
    Model<2> model(square({{"side", "west", {Constraint::driven, Constraint::free}},
                           {"other", "east", {Constraint::fixed, Constraint::free}}}));
    set_target(model, 0, 0, 0.1);
    EXPECT_EQ(solve_step(model, {{}, kind}).outcome, solve::Outcome::singular_tangent);
  }
}

TEST(Model, InversionAndIterationLimitAreReportedAndRolledBack) {
  Model<2> model(square({{"bed", "south", {Constraint::fixed, Constraint::fixed}},
                         {"top", "north", {Constraint::driven, Constraint::driven}}}));
  ASSERT_EQ(step_to(model, 0, 0, -0.1).outcome, solve::Outcome::converged);
  accept(model);
  const VectorX accepted = model.present.displacement;
  const Eigen::Vector2d force = reaction(model, 1);
  const auto inverted = step_to(model, 0, 0, -1.5);
  EXPECT_EQ(inverted.outcome, solve::Outcome::inverted_element);
  EXPECT_NE(text_of(inverted.messages).find("body = block"), std::string::npos) << text_of(inverted.messages);
  rollback(model);
  EXPECT_EQ(model.present.displacement, accepted);
  EXPECT_NEAR((reaction(model, 1) - force).norm(), 0, 1e-14);
  StepOptions short_of_breath;
  short_of_breath.newton.iterations = 1;
  EXPECT_EQ(step_to(model, 0, 0.2, -0.3, short_of_breath).outcome, solve::Outcome::iteration_limit);
  rollback(model);
  EXPECT_EQ(model.present.displacement, accepted);
  EXPECT_EQ(accepted_target(model, 0, 1), -0.1);
}

void iron(Model<2>& model, int from, int to, const StepOptions& options = {}) {
  for (int step = from; step <= to; ++step) {
    ASSERT_EQ(ironing_step(model, step, options).outcome, solve::Outcome::converged) << "step " << step;
    accept(model);
  }
}

TEST(Model, SolutionDoesNotDependOnTheLinearSolver) {
  Model<2> klu(ironing("N2-N2.1")), umfpack(ironing("N2-N2.1"));
  StepOptions first, second;
  first.linear = solve::LinearKind::klu;
  second.linear = solve::LinearKind::umfpack;
  iron(klu, 1, 60, first);
  iron(umfpack, 1, 60, second);
  EXPECT_EQ(klu.linear.kind(), solve::LinearKind::klu);
  EXPECT_EQ(umfpack.linear.kind(), solve::LinearKind::umfpack);
  EXPECT_NEAR((klu.present.displacement - umfpack.present.displacement).norm(), 0,
              1e-9 * klu.present.displacement.norm());
  EXPECT_NEAR((reaction(klu, grip) - reaction(umfpack, grip)).norm(), 0, 1e-9 * reaction(klu, grip).norm());
}

/// Equal up to Newton's tolerance, a residual of 1e-10 of the forces: contact elements of the failed attempt may change
/// the ordering of the unknowns, whose rounding error can change the number of iterations. Remaining displacements of
/// the attempt would change the first digits. (pair_test.cpp compares contacts bitwise.)
TEST(Model, FailedAttemptLeavesNoTrace) {
  Model<2> straight(ironing("N2")), tried(ironing("N2"));
  iron(straight, 1, 52);
  iron(tried, 1, 50);
  // A step that is far too long, with a low limit of iterations
  StepOptions cut;
  cut.newton.iterations = 3;
  EXPECT_NE(ironing_step(tried, 150, cut).outcome, solve::Outcome::converged);
  rollback(tried);
  iron(tried, 51, 52);
  EXPECT_NEAR((straight.present.displacement - tried.present.displacement).norm(), 0,
              1e-9 * straight.present.displacement.norm());
  EXPECT_NEAR((reaction(straight, grip) - reaction(tried, grip)).norm(), 0, 1e-9 * reaction(straight, grip).norm());
}

/// A snapshot contains all data that the next step depends on, including slip points.
TEST(Model, RestoredStateContinuesAsBefore) {
  Model<2> model(ironing("N2"));
  iron(model, 1, 60);
  const Snapshot<2> saved = snapshot(model);
  const double length = last_length(model);
  iron(model, 61, 64);
  const VectorX ahead = model.present.displacement;
  const Vec<2> force = reaction(model, grip);
  restore(model, saved);
  EXPECT_EQ(model.present.displacement, saved.state.displacement);
  EXPECT_EQ(last_length(model), length);
  EXPECT_NEAR(accepted_target(model, drive_of_grip, 0), 1.5 * 14 / 250, 1e-15);
  iron(model, 61, 64);
  EXPECT_NEAR((model.present.displacement - ahead).norm(), 0, 1e-9 * ahead.norm());
  EXPECT_NEAR((reaction(model, grip) - force).norm(), 0, 1e-9 * force.norm());
}

/// Start and end of a step; further iterations do nothing.
TEST(Model, IterationByIterationIsOneStep) {
  Model<2> whole(ironing("N2")), pieces(ironing("N2"));
  EXPECT_FALSE(pieces.step.has_value());
  const auto iterate_on = [&] {
    int calls = 0;
    while (iterate(pieces, {}).outcome == solve::Outcome::iterating) EXPECT_EQ(pieces.step->report.iterations, ++calls);
    return calls;
  };
  for (int step : {3, 6}) {
    const solve::NewtonReport report = ironing_step(whole, step);
    ASSERT_EQ(report.outcome, solve::Outcome::converged);
    set_target(pieces, drive_of_grip, 1, -0.23 * (step / 46.0));
    EXPECT_EQ(iterate_on(), report.iterations);
    for (const auto& residuals : {pieces.step->report.residuals, iterate(pieces, {}).residuals}) // at the end
      EXPECT_EQ(residuals, report.residuals);
    EXPECT_EQ(pieces.present.displacement, whole.present.displacement);
    accept(whole);
    accept(pieces);
    EXPECT_FALSE(pieces.step.has_value());
  }
  // Other targets during a step begin another step from its present state. A roll-back starts again.
  set_target(pieces, drive_of_grip, 1, -0.04);
  iterate(pieces, {});
  set_target(pieces, drive_of_grip, 1, -0.045);
  EXPECT_FALSE(pieces.step.has_value());
  iterate_on();
  EXPECT_EQ(pieces.step->report.outcome, solve::Outcome::converged);
  for (int dof : pieces.system.unknowns.of_support(grip, 1))
    EXPECT_NEAR(pieces.present.displacement(dof), -0.045, 1e-16);
  rollback(pieces);
  EXPECT_FALSE(pieces.step.has_value());
  EXPECT_EQ(pieces.present.displacement, whole.present.displacement);
  set_target(pieces, drive_of_grip, 1, -0.23 * (9 / 46.0));
  iterate_on();
  ironing_step(whole, 9);
  EXPECT_LT((pieces.present.displacement - whole.present.displacement).cwiseAbs().maxCoeff(), 1e-11);
}

} // namespace model_test
} // namespace signorini::model
