// Mirror planes of scenes: exact ones, and ones that a single number is missing from.
#include "model/symmetry.hpp"

#include "model/scenes.hpp"

#include <gtest/gtest.h>

namespace signorini::model {
namespace symmetry_test {

using namespace test;

/// A square on its south side, 1 + `move` wide at one control point of its north side, which weighs `weight`.
Scene<2> bumped(double move, double weight, std::vector<double> knots = {0, 0, 0, 0.25, 0.75, 1, 1, 1}) {
  const nurbs::KnotVector along(2, std::move(knots)), up = nurbs::KnotVector::single(1);
  const std::vector<double> greville = along.greville();
  MatrixX points(3, 2 * along.functions());
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < along.functions(); ++i)
      points.col(i + along.functions() * j) << greville[static_cast<std::size_t>(i)], j, 1;
  const int bump = along.functions() + 1;
  points(1, bump) += move;
  points.col(bump) *= weight;
  nurbs::Plan plan;
  plan.elements = {along.elements(), 1};
  plan.labels.assign(2, nurbs::parse_label("N2"));
  Scene<2> scene;
  scene.bodies.push_back({"block", std::make_shared<const solid::Body<2>>(std::make_shared<const nurbs::Discretisation>(
                                                                              nurbs::Patch({along, up}, points), plan),
                                                                          solid::neo_hookean(1, 0.3))});
  scene.supports.push_back({"bed", {held(scene, 0, "south")}, {Hold::fixed, Hold::fixed}});
  return scene;
}

std::size_t mirrors(const Scene<2>& scene) {
  return find_mirrors(Model<2>(scene)).size();
}

TEST(Symmetry, EveryControlPointWeightAndKnotCounts) {
  EXPECT_EQ(mirrors(bumped(0, 1)), 1u);
  EXPECT_EQ(mirrors(bumped(1e-12, 1)), 1u);
  EXPECT_EQ(mirrors(bumped(1e-7, 1)), 0u);
  EXPECT_EQ(mirrors(bumped(0, 1 + 1e-7)), 0u);
  EXPECT_EQ(mirrors(bumped(0, 1, {0, 0, 0, 0.25, 0.7, 1, 1, 1})), 0u);
}

TEST(Symmetry, PlaneAndHalfOfASquare) {
  const Model<2> model(bumped(0, 1));
  const std::vector<Mirror> found = find_mirrors(model);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].axis, 0);
  EXPECT_EQ(found[0].place, 0.5);
  EXPECT_EQ(found[0].directions, std::vector<int>{0});
  // Elements to 0.25 and to the middle: four functions by three rows of which the lowest is fixed; x in the middle.
  EXPECT_EQ(unknowns_beside(model, found), 2 * 4 * 2 - 2);
}

TEST(Symmetry, ThePublishedDieStandsBesideTheMiddle) {
  EXPECT_EQ(mirrors(ironing("N2")), 0u);
  Scene<2> middle = ironing("N2");
  middle.contacts.clear();
  middle.supports.pop_back();
  middle.bodies[0].body = make_body(nurbs::half_annulus(0.3, 0.5, Eigen::Vector2d(1.5, 1.5)), {6, 2}, "N2", "south",
                                    solid::neo_hookean(1000, 0.3));
  EXPECT_EQ(mirrors(middle), 1u);
}

TEST(Symmetry, ADriveThroughThePlaneIsTold) {
  for (const bool through : {false, true}) {
    Scene<2> scene = square({{"bed", "south", {Hold::fixed, Hold::fixed}}});
    scene.supports.push_back({"grip",
                              {held(scene, 0, "north")},
                              {through ? Hold::driven : Hold::fixed, through ? Hold::fixed : Hold::driven}});
    Model<2> model(scene);
    const std::vector<Mirror> found = find_mirrors(model);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].driven, through ? std::vector<int>{1} : std::vector<int>{});
    set_target(model, 0, 0, 0.1);
    ASSERT_EQ(solve_step(model, {}).outcome, solve::Outcome::converged);
    EXPECT_EQ(find_mirrors(model).size(), 1u);
    accept(model);
    EXPECT_EQ(find_mirrors(model).size(), through ? 0u : 1u);
  }
}

TEST(Symmetry, ATractionAlongTheNormalBreaksIt) {
  Scene<2> scene = square({{"bed", "south", {Hold::fixed, Hold::fixed}}});
  scene.loads = {{"push", {{0, nurbs::side_of("north", 2)}}, false, {0, -0.1}}};
  Model<2> model(scene);
  EXPECT_EQ(find_mirrors(model).size(), 1u);
  set_target(model, 0, 0, 0.01);
  ASSERT_EQ(solve_step(model, {}).outcome, solve::Outcome::converged);
  accept(model);
  EXPECT_EQ(find_mirrors(model).size(), 0u);
}

TEST(Symmetry, ThroughTheBodyRowsCount) {
  const Scene<2> scene = square({{"left", "west", {Hold::fixed, Hold::free}}});
  const Model<2> model(scene);
  const std::vector<Mirror> found = find_mirrors(model);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].directions, std::vector<int>{1});
  // Of three rows of four two are left; each has a point that is held at its start, the upper one all y.
  EXPECT_EQ(unknowns_beside(model, found), 2 * (2 * 4 - 1) - 4);
}

} // namespace symmetry_test
} // namespace signorini::model
