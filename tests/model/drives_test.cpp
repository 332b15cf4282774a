// Prescribed displacements by translation and rotation with their rates, moments, and the shared unknowns of a rotating
// face.
#include "model/bench.hpp"
#include "model/scene/check.hpp"
#include "model/scenes.hpp"

#include <cmath>
#include <numbers>

namespace signorini::model {
namespace drives_test {

using namespace test;
using nurbs::test::Random;
using nurbs::test::uniform;
using std::numbers::pi;

/// A half annulus whose outer arc rotates and is driven along x, above a driven disc, with a load: all kinds of drives.
Scene<2> busy(std::array<Constraint, 2> constraint = {Constraint::driven, Constraint::free}) {
  Scene<2> scene;
  const nurbs::Patch arc = nurbs::half_annulus(0.6, 1, Eigen::Vector2d(0.5, 2));
  scene.bodies.push_back({"shell", make_body(arc, {4, 1}, "N2", "north", solid::neo_hookean(1, 0.3))});
  scene.obstacles = {contact::make_ball<2>({0.5, 2.0}, 0.5)};
  Support<2> edge{"edge", {face_points(scene, 0, "south")}, constraint};
  edge.rotates = true;
  edge.center = face_centroid(*scene.bodies[0].body, nurbs::side_of("south", 2));
  Support<2> roll{"roll", {}, {Constraint::driven, Constraint::driven}, {0}};
  scene.supports = {{"idle", {face_points(scene, 0, "north")}, {Constraint::free, Constraint::free}}, edge, roll};
  scene.loads = {{"push", {{0, nurbs::side_of("west", 2)}}, LoadKind::traction, {0.25, -0.5}},
                 {"gas", {{0, nurbs::side_of("north", 2)}, {0, nurbs::side_of("east", 2)}}, LoadKind::pressure, {3}}};
  scene.contacts = {
      {"rub", {0, nurbs::side_of("north", 2)}, ObstacleReference{0}, contact::InterfaceLaw{50, 50, 0.3}, 4}};
  return scene;
}

TEST(Drives, ListSupportsAndLoadsWithTheirComponents) {
  const Scene<2> scene = busy();
  const Unknowns<2> unknowns(scene);
  const Drives<2> drives(scene, unknowns);
  const std::vector<std::pair<std::string, std::vector<std::string>>> expected = {
      {"edge", {"x", "angle"}}, {"roll", {"x", "y"}}, {"push", {"x", "y"}}, {"gas", {"pressure"}}};
  ASSERT_EQ(drives.all().size(), expected.size());
  int target = 0;
  for (std::size_t d = 0; d < expected.size(); ++d) {
    EXPECT_EQ(drives.all()[d].name, expected[d].first);
    EXPECT_EQ(drives.all()[d].components, expected[d].second);
    for (std::size_t c = 0; c < expected[d].second.size(); ++c)
      EXPECT_EQ(drives.target(static_cast<int>(d), static_cast<int>(c)), target++);
  }
  EXPECT_EQ(drives.start(), (VectorX(7) << 0, 0, 0, 0, 0.25, -0.5, 3).finished());
}

TEST(Drives, CenterIsTheCentroidOfTheFace) {
  const Scene<2> scene = busy();
  const solid::Body<2>& shell = *scene.bodies[0].body;
  // The centroid of a semicircular arc is 2R/π below its center.
  EXPECT_NEAR((face_centroid(shell, nurbs::side_of("south", 2)) - Vec<2>(0.5, 2 - 2 / pi)).norm(), 0, 1e-6);
  EXPECT_NEAR((face_centroid(shell, nurbs::side_of("west", 2)) - Vec<2>(-0.3, 2)).norm(), 0, 1e-14);
}

TEST(Drives, RateIsTheDisplacementsDerivative) {
  Random random(1);
  const Scene<2> scene = busy();
  const Unknowns<2> unknowns(scene);
  const Drives<2> drives(scene, unknowns);
  for (int trial = 0; trial < 20; ++trial) {
    VectorX targets(7), direction(7);
    for (int i = 0; i < 7; ++i) {
      targets(i) = uniform(random, -1, 1) * (i == 1 ? 360 : 1);
      direction(i) = uniform(random, -1, 1) * (i == 1 ? 90 : 1);
    }
    const VectorX slope = signorini::test::derivative<VectorX>(
        [&](double h) { return drives.displacement(targets + h * direction); }, 1e-2);
    EXPECT_NEAR((drives.rate(targets, direction) - slope).norm(), 0, 1e-10 * slope.norm());
    EXPECT_EQ(drives.displacement(drives.start()).norm(), 0);
    for (int dof = 0; dof < unknowns.dofs(); ++dof) {
      if (unknowns.constrained(dof)) continue;
      EXPECT_EQ(slope(dof), 0);
    }
    // Forces are linear in the targets.
    EXPECT_NEAR((drives.force(targets + direction) - drives.force(targets) - drives.force(direction)).norm(), 0, 1e-14);
  }
}

/// Rotation by θ counter-clockwise about the centroid and translation along x by the target; distances are constant.
TEST(Drives, RotationIsRigidAboutTheCenter) {
  const Scene<2> scene = busy();
  const Unknowns<2> unknowns(scene);
  const Drives<2> drives(scene, unknowns);
  const MatrixX points = scene.bodies[0].body->space().points();
  const Vec<2> center = scene.supports[1].center;
  for (double angle : {-400.0, -90.0, 10.0, 72.8, 180.0}) {
    VectorX targets = drives.start();
    targets(0) = 0.3;
    targets(1) = angle;
    const VectorX u = drives.displacement(targets);
    std::vector<Vec<2>> before, after;
    for (int a : scene.supports[1].on[0].functions) {
      before.push_back(points.col(a));
      after.push_back(Vec<2>(points.col(a)) + u.segment<2>(2 * a));
      const Vec<2> from = before.back() - center, to = after.back() - center - Vec<2>(0.3, 0);
      EXPECT_NEAR(to.norm(), from.norm(), 1e-14);
      EXPECT_NEAR(
          std::remainder(std::atan2(from(0) * to(1) - from(1) * to(0), from.dot(to)) - angle * pi / 180, 2 * pi), 0,
          1e-13);
    }
    for (std::size_t i = 1; i < before.size(); ++i)
      EXPECT_NEAR((after[i] - after[0]).norm(), (before[i] - before[0]).norm(), 1e-14);
  }
}

TEST(Drives, MomentUsesTheRotatedArms) {
  Random random(2);
  const Scene<2> scene = busy();
  const Unknowns<2> unknowns(scene);
  const Drives<2> drives(scene, unknowns);
  const MatrixX points = scene.bodies[0].body->space().points();
  for (int trial = 0; trial < 10; ++trial) {
    VectorX targets = drives.start(), force(unknowns.dofs());
    targets(1) = uniform(random, -180, 180);
    for (int i = 0; i < force.size(); ++i) force(i) = uniform(random, -1, 1);
    const Mat<2> rotation = nurbs::rotation(targets(1), Eigen::Vector3d(0, 0, 1)).topLeftCorner<2, 2>();
    double moment = 0;
    for (int a : scene.supports[1].on[0].functions) {
      const Vec<2> arm = rotation * (points.col(a) - scene.supports[1].center), f = force.segment<2>(2 * a);
      moment += arm(0) * f(1) - arm(1) * f(0);
    }
    EXPECT_NEAR(drives.moment(1, targets, force), moment, 1e-13);
    EXPECT_EQ(drives.moment(0, targets, force), 0);
    EXPECT_EQ(drives.moment(2, targets, force), 0);
  }
}

TEST(Unknowns, RotatingFaceSharesItsFreeTranslations) {
  const Scene<2> driven = busy(), free = busy({Constraint::free, Constraint::free}),
                 fixed = busy({Constraint::fixed, Constraint::fixed});
  const int face = std::ssize(free.supports[1].on[0].functions);
  const Unknowns<2> none(fixed), one(driven), two(free);
  EXPECT_EQ(none.size(), none.dofs() - 2 * face - 2);
  EXPECT_EQ(one.size(), none.size() + 1);
  EXPECT_EQ(two.size(), none.size() + 2);
  for (int c = 0; c < 2; ++c) {
    const std::vector<int>& dofs = two.of_support(1, c);
    ASSERT_EQ(static_cast<int>(dofs.size()), face);
    for (int dof : dofs) {
      EXPECT_TRUE(two.constrained(dof));
      EXPECT_EQ(two.unknown(dof), two.unknown(dofs[0]));
      EXPECT_GE(two.unknown(dof), 0);
    }
  }
  EXPECT_NE(two.unknown(two.of_support(1, 0)[0]), two.unknown(two.of_support(1, 1)[0]));
  // Forces are summed, displacements are equal.
  VectorX forces = VectorX::Zero(two.dofs());
  for (int dof : two.of_support(1, 1)) forces(dof) = 2;
  EXPECT_EQ(two.gather(forces).sum(), 2 * face);
  EXPECT_EQ(two.gather(forces).maxCoeff(), 2 * face);
  EXPECT_EQ(two.spread(VectorX::Ones(two.size())).sum(), two.dofs() - 2);
  // Obstacles are prescribed with or without a support.
  for (int c = 0; c < 2; ++c) EXPECT_EQ(two.unknown(two.obstacle_offset(0) + c), -1);
}

TEST(Unknowns, RotatingFaceAllowsNoOtherSupport) {
  const auto build = [](std::array<Constraint, 2> constraint, bool first) {
    Scene<2> scene = busy({Constraint::free, Constraint::fixed});
    const Support<2> other{"bolt", {face_points(scene, 0, "west")}, constraint};
    scene.supports.insert(first ? scene.supports.begin() : scene.supports.end(), other);
    complete(scene);
  };
  EXPECT_ERROR(build({Constraint::fixed, Constraint::free}, false),
               "model.scene.constrained_twice: support = bolt, verb = (model.verb.fixes), component = x, other = edge, "
               "other_verb = (model.verb.turns)");
  EXPECT_ERROR(build({Constraint::free, Constraint::driven}, true),
               "model.scene.constrained_twice: support = edge, verb = (model.verb.turns), component = y, other = bolt, "
               "other_verb = (model.verb.drives)");
  EXPECT_ERROR(build({Constraint::free, Constraint::fixed}, false),
               "model.scene.constrained_twice: support = bolt, verb = (model.verb.fixes), component = y, other = edge, "
               "other_verb = (model.verb.turns)");
}

TEST(Assembly, TangentOfSharedUnknownsIsTheResidualsDerivative) {
  Random random(3);
  int compared = 0, touching = 0;
  for (const auto& constraint : {std::array{Constraint::free, Constraint::free},
                                 {Constraint::driven, Constraint::free},
                                 {Constraint::fixed, Constraint::fixed}}) {
    Bench bench(busy(constraint));
    const Drives<2>& drives = bench.system.drives;
    VectorX targets = drives.start();
    for (double angle : {5.0, 25.0}) {
      targets(drives.target(0, static_cast<int>(drives.all()[0].components.size()) - 1)) = angle;
      VectorX u = drives.displacement(targets);
      // The disc pushed into the shell's inner side
      u(bench.unknowns.obstacle_offset(0) + 1) = -0.12;
      for (int i = 0; i < bench.unknowns.obstacle_offset(0); ++i)
        if (!bench.unknowns.constrained(i)) u(i) = uniform(random, -0.005, 0.005);
      const bool same = compare(bench, u);
      compared += same;
      touching += same && !bench.system.contacts[0]->blocks().empty();
    }
  }
  EXPECT_GE(compared, 5);
  EXPECT_GE(touching, 5);
}

} // namespace drives_test
} // namespace signorini::model
