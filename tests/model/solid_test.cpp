// Models of solids: quadratic convergence of frictional ironing and twisting with the consistent tangent, balance of
// forces, moments and energy, and a pole that remains one point.
#include "model/results/results.hpp"
#include "model/steps/arc.hpp"
#include "model/steps/load_step.hpp"

#include "model/quadratic.hpp"
#include "nurbs/coincident.hpp"
#include "nurbs/shapes.hpp"
#include "os/parallel.hpp"
#include "solid/neo_hookean.hpp"
#include "text_of.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>

namespace signorini::model {
namespace solid_test {

const nurbs::Side west{0, false}, south{1, false}, front{2, false}, back{2, true};

std::shared_ptr<const solid::Body<3>> make_solid(const nurbs::Patch& patch, std::vector<int> elements,
                                                 const std::string& label, nurbs::Side contact,
                                                 const solid::Material& material) {
  nurbs::Plan plan;
  plan.elements = std::move(elements);
  plan.contact = {contact};
  plan.labels.assign(2, nurbs::parse_label(label));
  plan.thickness_degree = 1;
  return std::make_shared<const solid::Body<3>>(std::make_shared<const nurbs::Discretization>(patch, plan), material);
}

SupportedControlPoints face_points(const Scene<3>& scene, int body, nurbs::Side side) {
  return {body, scene.bodies[body].body->space().face_functions(side)};
}

/// A small indenter with a spherical cap on a block; its top is translated, or rotated about the vertical.
Scene<3> indentation(const std::string& label, double mu, bool turns) {
  Scene<3> scene;
  const nurbs::Patch cap = nurbs::spherical_indenter(1, 1, 0.8, 1.2, 2, Eigen::Vector3d(0.6, 0.5, 1));
  scene.bodies.push_back({"indenter", make_solid(cap, {2, 2, 1}, label, front, solid::neo_hookean(5, 0.3))});
  const nurbs::Patch block = nurbs::block({3, 2, 1}, Eigen::Vector3d(0, 0, 0));
  scene.bodies.push_back({"block", make_solid(block, {6, 4, 2}, label, back, solid::neo_hookean(1, 0.3))});
  scene.supports.push_back(
      {"bed", {face_points(scene, 1, front)}, {Constraint::fixed, Constraint::fixed, Constraint::fixed}});
  Support<3> grip{"grip", {face_points(scene, 0, back)}, {Constraint::driven, Constraint::driven, Constraint::driven}};
  grip.rotates = turns;
  grip.center = {1.1, 1, 1.8};
  grip.axis = {0, 0, 1};
  scene.supports.push_back(grip);
  scene.contacts.push_back({"interface", {0, front}, FaceReference{1, back}, contact::InterfaceLaw{50, 50, mu}, 6});
  return scene;
}

/// One step, solved but not accepted.
void solve(Model<3>& model, const std::vector<double>& targets, int& iterations) {
  for (std::size_t i = 0; i < targets.size(); ++i) set_target(model, 0, static_cast<int>(i), targets[i]);
  const solve::NewtonReport report = solve_step(model, {});
  ASSERT_EQ(report.outcome, solve::Outcome::converged) << text_of(report.messages);
  iterations += report.iterations;
  const Vec<3> by_bed = reaction(model, 0), by_grip = reaction(model, 1);
  const double scale = by_grip.norm();
  const double missing = std::sqrt(model.system.unknowns.size()) * report.residuals.back() + 1e-12 * scale;
  EXPECT_LT((by_bed + by_grip).norm(), missing);
  EXPECT_LT((resultant(model.present.contacts[0]).force + by_grip).norm(), missing);
}

void step(Model<3>& model, const std::vector<double>& targets, int& iterations) {
  solve(model, targets, iterations);
  accept(model);
}

TEST(SolidModel, IroningConvergesQuadraticallyAndItsEnergyBalances) {
  for (const char* label : {"N2", "N2-N2.1"}) {
    Model<3> model(indentation(label, 0.3, false));
    int iterations = 0;
    for (int i = 1; i <= 8; ++i) step(model, {0, 0, -0.02 * i}, iterations);
    int pairs = 0;
    for (int i = 1; i <= 14; ++i) {
      solve(model, {0.025 * i, 0.01 * i, -0.16}, iterations);
      if (i % 7 == 0) pairs += test::compare_starts(model);
      accept(model);
    }
    EXPECT_GE(pairs, 4) << label; // of 8
    EXPECT_LE(iterations, 6 * 22) << label;
    const auto contact = resultant(model.present.contacts[0]);
    EXPECT_GT(contact.slipping, 0);
    EXPECT_LT(contact.force(0), 0);
    EXPECT_LT(contact.force(1), 0);
    // Work = stored energy + penalty springs + friction, without the change of the springs' area.
    const Energies e = energies(model);
    EXPECT_GT(e.friction, 0.05 * e.work);
    EXPECT_NEAR(e.work, e.stored + e.contact + e.friction, 5e-3 * e.work)
        << label << ": " << e.work << " " << e.stored << " " << e.contact << " " << e.friction;
  }
}

TEST(SolidModel, TwistingNeedsAMoment) {
  Model<3> model(indentation("N2", 0.3, true));
  int iterations = 0;
  for (int i = 1; i <= 6; ++i) step(model, {0, 0, -0.02 * i, 0}, iterations);
  EXPECT_NEAR(moment(model, 1), 0, 1e-3 * reaction(model, 1).norm());
  double before = 0, work = 0, last_moment = moment(model, 1);
  const double work_before = energies(model).work;
  for (int i = 1; i <= 16; ++i) {
    step(model, {0, 0, -0.12, 1.5 * i}, iterations);
    work += (moment(model, 1) + last_moment) / 2 * 1.5 * std::acos(-1.0) / 180;
    last_moment = moment(model, 1);
    if (i <= 2) {
      EXPECT_GT(moment(model, 1), before);
    }
    before = moment(model, 1);
  }
  EXPECT_LE(iterations, 6 * 22);
  // The angle's work is M dθ.
  EXPECT_NEAR(energies(model).work - work_before, work, 2e-3 * work);
}

TEST(SolidModel, ResultsAreBitwiseIndependentOfThreads) {
  const contact::InterfaceLaw law{50, 50, 0.3};
  for (const contact::Method& method : {contact::Method(law), contact::Method(law, contact::MultiplierSpace::equal)}) {
    std::vector<VectorX> results;
    for (int threads : {1, 2, 3}) {
      set_worker_threads(threads);
      Scene<3> scene = indentation("N2-N2.1", 0.3, false);
      scene.contacts[0].method = method;
      Model<3> model(std::move(scene));
      int iterations = 0;
      for (int i = 1; i <= 2; ++i) step(model, {0.01 * i, 0, -0.03 * i}, iterations);
      results.push_back(model.present.displacement);
      EXPECT_GT(resultant(model.present.contacts[0]).active, 0);
    }
    set_worker_threads(1);
    for (const VectorX& other : results) EXPECT_EQ((other - results[0]).norm(), 0);
  }
}

TEST(SolidModel, APoleRemainsOnePoint) {
  Scene<3> scene;
  const nurbs::Patch octant = nurbs::sphere_octant(0.5, 1, Eigen::Vector3d::Zero());
  scene.bodies.push_back({"ball", make_solid(octant, {2, 3, 1}, "N2-N2.1", front, solid::neo_hookean(1, 0.3))});
  scene.supports.push_back(
      {"x0", {face_points(scene, 0, {0, true})}, {Constraint::fixed, Constraint::free, Constraint::free}});
  scene.supports.push_back(
      {"y0", {face_points(scene, 0, west)}, {Constraint::free, Constraint::fixed, Constraint::free}});
  scene.supports.push_back(
      {"equator", {face_points(scene, 0, south)}, {Constraint::free, Constraint::free, Constraint::driven}});
  scene.obstacles.push_back(contact::make_plane<3>({0, 0, -1}, {0, 0, 1}));
  scene.contacts.push_back({"plane", {0, front}, ObstacleReference{0}, contact::InterfaceLaw{100}, 4});
  Model<3> model(std::move(scene));
  const auto groups = nurbs::coincident_functions(model.system.scene.bodies[0].body->space());
  ASSERT_FALSE(groups.empty());
  for (int i = 1; i <= 3; ++i) {
    set_target(model, 0, 0, -0.02 * i);
    const solve::NewtonReport report = solve_step(model, {});
    ASSERT_EQ(report.outcome, solve::Outcome::converged) << text_of(report.messages);
    accept(model);
  }
  EXPECT_GT(resultant(model.present.contacts[0]).force(2), 0);
  const auto u = body_displacement(model, 0);
  for (const auto& group : groups)
    for (int function : group) {
      EXPECT_EQ((u.col(function) - u.col(group.front())).norm(), 0);
      EXPECT_EQ(u.col(function).head<2>().norm(), 0); // fixed by both symmetry planes
    }
}

} // namespace solid_test
} // namespace signorini::model
