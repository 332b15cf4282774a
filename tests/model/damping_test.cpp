// Unconstrained bodies, supported by contact only: rigid-body modes, damped motion, final state.
#include "model/system/damping.hpp"

#include "model/scenes.hpp"
#include "text_of.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace signorini::model {
namespace damping_test {

using namespace test;

constexpr Constraint fixed = Constraint::fixed, free_to_move = Constraint::free;

StepOptions damped() {
  StepOptions options;
  options.damping = true;
  return options;
}

std::vector<UnconstrainedMotion> unconstrained_of(const Scene<2>& scene) {
  return unconstrained_motions(scene, Unknowns<2>(scene));
}

// ── Rigid-body modes ─────────────────────────────────────────────────────────────────────────────────────────────────

TEST(Damping, AFreeBodyHasAllRigidBodyModes) {
  const Scene<2> scene = square({});
  const auto unconstrained = unconstrained_of(scene);
  ASSERT_EQ(unconstrained.size(), 3u);
  const MatrixX points = scene.bodies[0].body->space().points();
  const auto at = [&](std::size_t k, int a) { return Vec<2>(unconstrained[k].motion.segment<2>(2 * a)); };
  for (int a = 0; a < points.cols(); ++a) {
    EXPECT_EQ(at(0, a), Vec<2>(1, 0));
    EXPECT_EQ(at(1, a), Vec<2>(0, 1));
    // About the middle, with largest component 1: u = (−y, x)/0.5
    const Vec<2> arm = points.col(a) - Vec<2>(0.5, 0.5);
    EXPECT_NEAR((at(2, a) - Vec<2>(-arm(1), arm(0)) / 0.5).norm(), 0, 1e-14);
  }
}

TEST(Damping, SupportsPreventModes) {
  // Fixed in x on its west face: only translation in y is free, because rotation moves that face in x.
  const auto along = unconstrained_of(square({{"wall", "west", {fixed, free_to_move}}}));
  ASSERT_EQ(along.size(), 1u);
  EXPECT_EQ(along[0].motion(1), 1);
  EXPECT_EQ(along[0].motion(0), 0);
  // Driven components are prescribed, too. A pinned corner leaves no mode, because rotations are about the middle.
  EXPECT_EQ(unconstrained_of(square({{"wall", "west", {Constraint::driven, free_to_move}}})).size(), 1u);
  Scene<2> pinned = square({});
  pinned.supports = {{"pin", {corner(pinned, 0, {0, 0})}, {fixed, fixed}}};
  EXPECT_TRUE(unconstrained_of(pinned).empty());
  EXPECT_TRUE(unconstrained_of(square({{"bed", "south", {fixed, fixed}}})).empty());
}

TEST(Damping, ABodyOfRevolutionTranslatesAlongItsAxisOnly) {
  Scene<2> scene;
  scene.kind = solid::Kind::axisymmetric;
  scene.bodies.push_back({"disc", make_body(nurbs::rectangle(1, 1, Eigen::Vector2d(0, 0)), {2, 2}, "N2", "south",
                                            solid::neo_hookean(1, 0.3), {}, solid::Kind::axisymmetric)});
  scene.supports = {{"axis", {face_points(scene, 0, "west")}, {fixed, free_to_move}}};
  const auto unconstrained = unconstrained_of(scene);
  ASSERT_EQ(unconstrained.size(), 1u);
  EXPECT_EQ(Vec<2>(unconstrained[0].motion.head<2>()), Vec<2>(0, 1));
}

TEST(Damping, EachBodyHasItsOwnModes) {
  Scene<2> scene = ironing("N2");
  EXPECT_TRUE(unconstrained_of(scene).empty());
  scene.supports.pop_back(); // the die's grip
  const auto unconstrained = unconstrained_of(scene);
  ASSERT_EQ(unconstrained.size(), 3u);
  for (const UnconstrainedMotion& motion : unconstrained) EXPECT_EQ(motion.body, 0);
}

// ── 3D ───────────────────────────────────────────────────────────────────────────────────────────────────────────────

const nurbs::Side west{0, false}, south{1, false}, front{2, false}, back{2, true};

/// A block with its front face `gap` above the plane z = 0, pressed by 0.05 from behind.
Scene<3> block_above_plane(double gap) {
  nurbs::Plan plan;
  plan.elements = {2, 2, 1};
  plan.contact = {front};
  plan.labels.assign(2, nurbs::parse_label("N2"));
  plan.thickness_degree = 1;
  const nurbs::Patch patch = nurbs::block({1, 1, 0.6}, Eigen::Vector3d(0, 0, gap));
  Scene<3> scene;
  scene.bodies.push_back(
      {"block", std::make_shared<const solid::Body<3>>(std::make_shared<const nurbs::Discretization>(patch, plan),
                                                       solid::neo_hookean(1, 0.3))});
  const auto face = [&](nurbs::Side side) {
    return SupportedControlPoints{0, scene.bodies[0].body->space().face_functions(side)};
  };
  scene.supports = {{"x", {face(west)}, {fixed, free_to_move, free_to_move}},
                    {"y", {face(south)}, {free_to_move, fixed, free_to_move}}};
  scene.loads = {{"weight", {{0, back}}, LoadKind::pressure, {0}}};
  scene.obstacles = {contact::make_plane<3>({0, 0, 0}, {0, 0, 1})};
  scene.contacts = {{"floor", {0, front}, ObstacleReference{0}, contact::InterfaceLaw{50}, 3}};
  return scene;
}

TEST(Damping, RigidBodyModesIn3D) {
  Scene<3> scene = block_above_plane(0.1);
  EXPECT_EQ(unconstrained_motions(scene, Unknowns<3>(scene)).size(), 1u); // along z
  scene.supports.pop_back();
  EXPECT_EQ(unconstrained_motions(scene, Unknowns<3>(scene)).size(), 3u); // along y and z, about x
  scene.supports.clear();
  const auto unconstrained = unconstrained_motions(scene, Unknowns<3>(scene));
  ASSERT_EQ(unconstrained.size(), 6u);
  for (const UnconstrainedMotion& motion : unconstrained) EXPECT_NEAR(motion.motion.cwiseAbs().maxCoeff(), 1, 1e-14);
}

// ── Length of moves ──────────────────────────────────────────────────────────────────────────────────────────────────

/// A free square `gap` above a plane, with a pressure from above that is zero at first.
Scene<2> above_plane(double gap, const std::vector<Grip>& grips) {
  Scene<2> scene = square(grips);
  scene.bodies[0].body =
      make_body(nurbs::rectangle(1, 1, Eigen::Vector2d(0, gap)), {3, 2}, "N2", "south", solid::neo_hookean(1, 0.3));
  scene.supports.clear();
  for (const Grip& grip : grips)
    scene.supports.push_back({grip.name, {face_points(scene, 0, grip.face)}, grip.constraint});
  scene.loads = {{"weight", {{0, nurbs::side_of("north", 2)}}, LoadKind::pressure, {0}}};
  scene.obstacles = {contact::make_plane<2>({0, 0}, {0, 1})};
  scene.contacts = {{"floor", {0, nurbs::side_of("south", 2)}, ObstacleReference{0}, contact::InterfaceLaw{50}, 4}};
  return scene;
}

/// (K + αD) u = f with K m = 0: the rigid part of u, Σ D_ii m_i u_i / Σ D_ii m_i², is f·m/(α Σ D_ii m_i²) = stride.
TEST(Damping, AFreeBodyTravelsOneStrideInOneSolve) {
  for (double gap : {0.3, 0.02})
    for (double weight : {0.01, 10.0}) {
      Model<2> model(above_plane(gap, {}));
      set_target(model, 0, 0, weight);
      const solve::NewtonReport& report = iterate(model, damped());
      ASSERT_EQ(report.outcome, solve::Outcome::iterating) << text_of(report.messages);
      // The shift is a multiple of the diagonal, so it can replace it.
      const VectorX diagonal = model.system.assembly.tangent().diagonal();
      double travel = 0, sum = 0;
      for (int i = 0; i < model.system.unknowns.size(); ++i)
        if (i % 2 == 1) travel += diagonal(i) * model.present.displacement(i), sum += diagonal(i);
      EXPECT_NEAR(travel / sum, -gap, 1e-9 * gap);
    }
}

TEST(Damping, StridesAreTheGapsOfOpenContacts) {
  Scene<2> scene = above_plane(0.2, {});
  Model<2> model(scene);
  EXPECT_NEAR(strides(model.system.scene, model.system.contacts, model.present, 1e-3)[0], 0.2, 1e-14);
  EXPECT_EQ(strides(model.system.scene, model.system.contacts, model.present, 0.5)[0], 0.5);
  Model<2> touching(above_plane(-1e-3, {}));
  EXPECT_EQ(strides(touching.system.scene, touching.system.contacts, touching.present, 1e-3)[0], 1e-3);
  scene.contacts.clear();
  EXPECT_EQ(strides<2>(scene, {}, {}, 1e-3)[0], 1e-3);
}

/// |f·m|/(stride Σ K m²), the largest of all modes, and 10⁻¹⁰ if no force does work.
TEST(Damping, TheFactorIsThatOfTheModeWithMostWork) {
  const Scene<2> scene = square({});
  const Unknowns<2> unknowns(scene);
  const auto unconstrained = unconstrained_motions(scene, unknowns);
  const VectorX diagonal = VectorX::LinSpaced(unknowns.size(), 1, 3);
  VectorX force = VectorX::Zero(unknowns.dofs());
  EXPECT_LT((damping(scene, unknowns, unconstrained, diagonal, force, {0.1}) - 1e-10 * diagonal).norm(), 1e-22);
  for (int i = 1; i < force.size(); i += 2) force(i) = -2;
  double along_y = 0;
  for (int i = 1; i < force.size(); i += 2) along_y += diagonal(i);
  const double factor = 2 * static_cast<double>(force.size() / 2) / (0.1 * along_y);
  EXPECT_LT((damping(scene, unknowns, unconstrained, diagonal, force, {0.1}) - factor * diagonal).norm(),
            1e-13 * factor * diagonal.norm());
}

// ── Final state ──────────────────────────────────────────────────────────────────────────────────────────────────────

/// Positions of the control points relative to the plane.
template <int D> MatrixX places(const Model<D>& model) {
  return MatrixX(model.system.scene.bodies[0].body->space().points()) + MatrixX(body_displacement(model, 0));
}

template <int D> void expect_the_same_rest(const std::function<Scene<D>(double)>& scene, double load, double gap) {
  Model<D> touching(scene(-1e-3)), apart(scene(gap)), undamped(scene(gap));
  set_target(touching, 0, 0, load);
  ASSERT_EQ(solve_step(touching, {}).outcome, solve::Outcome::converged);
  set_target(apart, 0, 0, load);
  const solve::NewtonReport report = solve_step(apart, damped());
  ASSERT_EQ(report.outcome, solve::Outcome::converged) << text_of(report.messages);
  EXPECT_LT((places(apart) - places(touching)).cwiseAbs().maxCoeff(), 1e-8);
  EXPECT_GT(resultant(apart.present.contacts[0]).active, 0);
  EXPECT_LT((resultant(apart.present.contacts[0]).force - resultant(touching.present.contacts[0]).force).norm(), 1e-8);
  set_target(undamped, 0, 0, load);
  const solve::NewtonReport failed = solve_step(undamped, {});
  EXPECT_EQ(failed.outcome, solve::Outcome::singular_tangent) << text_of(failed.messages);
}

TEST(Damping, ASquareReachesTheSameStateAsWithoutAGap) {
  const auto scene = [](double gap) { return above_plane(gap, {{"wall", "west", {fixed, free_to_move}}}); };
  for (double gap : {0.05, 0.4}) expect_the_same_rest<2>(scene, 0.1, gap);
}

TEST(Damping, ADiscReachesTheSameStateAsWithoutAGap) {
  // Half of a ring, pressed down at its ends, which slide along walls
  const auto scene = [](double gap) {
    Scene<2> result;
    result.bodies.push_back({"ring", make_body(nurbs::half_annulus(0.3, 0.5, Eigen::Vector2d(0, 0.5 + gap)), {8, 2},
                                               "N2", "south", solid::neo_hookean(1, 0.3))});
    result.supports = {
        {"walls", {face_points(result, 0, "west"), face_points(result, 0, "east")}, {fixed, free_to_move}}};
    result.loads = {
        {"weight", {{0, nurbs::side_of("west", 2)}, {0, nurbs::side_of("east", 2)}}, LoadKind::pressure, {0}}};
    result.obstacles = {contact::make_plane<2>({0, 0}, {0, 1})};
    result.contacts = {{"floor", {0, nurbs::side_of("south", 2)}, ObstacleReference{0}, contact::InterfaceLaw{50}, 9}};
    return result;
  };
  expect_the_same_rest<2>(scene, 0.02, 0.1);
}

TEST(Damping, ABlockReachesTheSameStateAsWithoutAGap) {
  expect_the_same_rest<3>(block_above_plane, 0.05, 0.1);
}

TEST(Damping, ABlockWithFrictionComesIntoContactFromAnyHeightUnderFullLoad) {
  for (double mu : {0.1, 0.3, 0.8})
    for (double gap : {1e-6, 1e-3, 1e-2, 0.3})
      for (double load : {1e-3, 1e-2, 5e-2}) {
        Scene<2> scene = above_plane(gap, {});
        scene.contacts[0].method = contact::InterfaceLaw{50, 50, mu};
        Model<2> model(scene);
        set_target(model, 0, 0, load);
        const solve::NewtonReport report = solve_step(model, damped());
        ASSERT_EQ(report.outcome, solve::Outcome::converged)
            << text_of(report.messages) << mu << " " << gap << " " << load;
        // The resultant is the load up to the face's stretch, without lateral force.
        const auto floor = resultant(model.present.contacts[0]);
        EXPECT_NEAR(floor.force(1) / load_resultant(model, 0)(1), -1, 1e-8);
        EXPECT_NEAR(floor.force(0) / floor.force(1), 0, 1e-6);
      }
}

TEST(Damping, ChangesNothingIfSupportsConstrainAllBodies) {
  Model<2> plain(ironing("N2")), with(ironing("N2"));
  EXPECT_TRUE(with.system.unconstrained().empty());
  for (int step : {2, 4, 6, 8, 10, 12}) {
    ASSERT_EQ(ironing_step(plain, step).outcome, solve::Outcome::converged);
    const solve::NewtonReport report = ironing_step(with, step, damped());
    EXPECT_EQ(report.residuals, plain.step->report.residuals);
    EXPECT_EQ(with.present.displacement, plain.present.displacement);
    accept(plain);
    accept(with);
  }
}

} // namespace damping_test
} // namespace signorini::model
