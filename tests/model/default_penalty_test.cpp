// Penalty parameters from material and mesh, and files that keep them.
#include "model/files/checkpoint.hpp"
#include "model/scene/default_penalty.hpp"
#include "model/scenes.hpp"
#include "scratch.hpp"
#include "text_of.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace signorini::model {
namespace default_penalty_test {

using namespace test;
using contact::Enforcement;
using contact::InterfaceLaw;

const nurbs::Side south = nurbs::side_of("south", 2), north = nurbs::side_of("north", 2);

/// A stiff block, 4 elements along its south face of length 1, over a soft one with 8 elements.
Scene<2> two_blocks(const contact::Method& law, contact::Region<2> where = {}) {
  Scene<2> scene;
  const auto block = [](double y) { return nurbs::rectangle(1, 1, Eigen::Vector2d(0, y)); };
  scene.bodies.push_back({"upper", make_body(block(0), {4, 2}, "N2", "south", solid::neo_hookean(20, 0.3))});
  scene.bodies.push_back({"lower", make_body(block(-1), {8, 2}, "N2", "north", solid::linear_elastic(3, 0.3))});
  scene.contacts = {{"joint", {0, south}, FaceReference{1, north}, law, 6, std::move(where)}};
  return scene;
}

InterfaceLaw default_law(Enforcement enforcement, double mu = 0) {
  return {.normal = 0, .friction = mu, .enforcement = enforcement};
}

contact::Method multipliers(double mu = 0) {
  return {default_law(Enforcement::multipliers, mu), contact::MultiplierSpace::equal};
}

InterfaceLaw filled(Scene<2> scene) {
  set_default_penalties(scene);
  return *penalty_law(scene.contacts[0]);
}

TEST(DefaultPenalty, IsAMultipleOfTheSofterModulusPerElement) {
  // h = 1/4 on the upper block's face, 1/8 on the lower one's; E = 3 is the softer modulus.
  Scene<2> scene = two_blocks(multipliers(0.2)); // on the stiffer body
  EXPECT_NEAR(filled(scene).normal, 10 * 3 * 8, 1e-10);
  EXPECT_EQ(filled(scene).tangential, filled(scene).normal);
  EXPECT_NEAR(filled(two_blocks(default_law(Enforcement::penalty, 0.2))).normal, 30 * 3 * 4, 1e-10);
  EXPECT_NEAR(filled(two_blocks(default_law(Enforcement::penalty, 0.2))).tangential, 30 * 3 * 4, 1e-10);
  scene.contacts[0].slave = {1, north};
  scene.contacts[0].master = FaceReference{0, south};
  EXPECT_NEAR(filled(scene).normal, 10 * 3 * 8, 1e-10);
  // Of an obstacle's slave; the part of the face in the contact has elements of the same size.
  scene = two_blocks(multipliers(), [](const Vec<2>& X) { return X(0) < 0.4; });
  scene.obstacles = {contact::make_plane<2>({0, 0}, {0, 1})};
  scene.contacts[0].master = ObstacleReference{0};
  EXPECT_NEAR(filled(scene).normal, 10 * 20 * 4, 1e-10);
}

TEST(DefaultPenalty, IsEqualForBothHalfPasses) {
  Scene<2> scene = two_blocks(default_law(Enforcement::penalty));
  scene.contacts[0].method = contact::Method{default_law(Enforcement::penalty), {}, contact::Pass::half};
  scene.contacts.push_back(scene.contacts[0]);
  scene.contacts[1].slave = {1, north};
  scene.contacts[1].master = FaceReference{0, south};
  scene.contacts[0].other_pass = 1;
  scene.contacts[1].other_pass = 0;
  set_default_penalties(scene);
  for (const Contact<2>& pass : scene.contacts) EXPECT_NEAR(penalty_law(pass)->normal, 30 * 3 * 4, 1e-10);
}

TEST(DefaultPenalty, DoesNotReplaceGivenParameters) {
  InterfaceLaw law = default_law(Enforcement::penalty, 0.2);
  law.normal = 7;
  EXPECT_EQ(filled(two_blocks(law)).normal, 7);
  EXPECT_EQ(filled(two_blocks(law)).tangential, 7);
  law.tangential = 5;
  EXPECT_EQ(filled(two_blocks(law)).tangential, 5);
  law.normal = -1;
  EXPECT_ERROR(Model<2>(two_blocks(law)), "contact.penalty.normal");
}

/// Graded to elements of sizes 1/16, 1/16, 1/8, 1/4, 1/2 whose mean of 1/h is (16 + 16 + 8 + 4 + 2)/5.
TEST(DefaultPenalty, CountsElementsOfAGradedMesh) {
  Scene<2> scene = two_blocks(default_law(Enforcement::penalty));
  nurbs::Patch patch = nurbs::rectangle(1, 1, Eigen::Vector2d(0, 0));
  patch = nurbs::insert_knots(patch, 0, {0.0625, 0.125, 0.25, 0.5});
  scene.bodies[0].body = make_body(patch, {5, 2}, "N2", "south", solid::neo_hookean(20, 0.3));
  scene.contacts[0].points = 4;
  EXPECT_NEAR(filled(scene).normal, 30 * 3 * 46 / 5.0, 1e-9);
}

TEST(DefaultPenalty, FilesKeepTheEnforcementAndTheDefault) {
  const signorini::test::ScratchFolder folder;
  const auto region = [](const Vec<2>& X) { return X(0) < 0.4; };
  for (const contact::Method& method :
       {contact::Method(default_law(Enforcement::penalty, 0.1)), contact::Method(multipliers(0.1))}) {
    Scene<2> scene = two_blocks(InterfaceLaw{1}, region);
    scene.contacts[0].method = method;
    Model<2> model(std::move(scene));
    save(model, folder.file("a.sgn"));
    const auto loaded = std::get<std::shared_ptr<Model<2>>>(load(folder.file("a.sgn")));
    const auto* law = penalty_law(loaded->system.scene.contacts[0]);
    EXPECT_EQ(law->enforcement, method.law.enforcement);
    EXPECT_EQ(law->normal, model.system.contacts[0]->parameters().penalty(model.accepted.contacts[0].changes));
    EXPECT_TRUE(loaded->system.scene.contacts[0].default_penalty);
  }
  auto other = std::make_shared<Model<2>>(two_blocks(InterfaceLaw{1}, region));
  EXPECT_ERROR(restore(other, folder.file("a.sgn")), "contact 'joint'");
}

TEST(DefaultPenalty, CombinationsThatDoNotExistAreErrors) {
  EXPECT_ERROR(Model<2>(two_blocks(InterfaceLaw{.normal = 1, .enforcement = Enforcement::multipliers})),
               "contact.enforcement.points");
  Scene<2> scene = two_blocks(InterfaceLaw{1});
  scene.contacts[0].method =
      contact::Method{{.normal = 1, .enforcement = Enforcement::multipliers}, {}, contact::Pass::half};
  EXPECT_ERROR(Model<2>(std::move(scene)), "contact.enforcement.half_passes");
}

} // namespace default_penalty_test
} // namespace signorini::model
