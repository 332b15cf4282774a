// Initial penetration: an obstacle inside a body is an error; contact and small overlap are not.
#include "model/scenes.hpp"

#include <gtest/gtest.h>

namespace signorini::model {
namespace clearance_test {

using namespace test;

/// A model of a square [0, 1]² with contact between a face and an obstacle.
void build(const contact::Obstacle<2>& obstacle, const std::string& face = "south") {
  Scene<2> scene = square({{"top", "north", {Constraint::fixed, Constraint::fixed}}});
  scene.obstacles = {obstacle};
  scene.contacts = {{"floor", {0, nurbs::side_of(face, 2)}, ObstacleReference{0}, contact::InterfaceLaw{100}, 3}};
  Model<2>{std::move(scene)};
}

contact::Obstacle<2> plane(double y, double up) {
  return contact::make_plane<2>({0, y}, {0, up});
}
contact::Obstacle<2> ball(double x, double y, double radius) {
  return contact::make_ball<2>({x, y}, radius);
}

TEST(Clearance, SmallOverlapIsAllowed) {
  build(plane(-0.3, 1));
  build(plane(0, 1));
  build(plane(0.009, 1)); // the body's size is √2
  build(ball(0.5, -1, 1));
  build(ball(0.5, -1, 1.01));
  build(ball(0.5, -2, 1));
  build(ball(0.5, 2, 0.3)); // next to another face
  build(ball(-0.4, 0.5, 0.3), "west");
  build(nurbs::line(Eigen::Vector2d(2, 0), Eigen::Vector2d(-1, 0)));
}

TEST(Clearance, ObstacleInsideTheBodyIsAnError) {
  EXPECT_ERROR(build(plane(0.02, 1)), "model.clearance.inside");
  EXPECT_ERROR(build(ball(0.5, -1, 1.2)), "model.clearance.inside");
  EXPECT_ERROR(build(ball(0.5, 0.2, 3)), "model.clearance.inside"); // contains the body
}

TEST(Clearance, ReversedNormalIsAnError) {
  EXPECT_ERROR(build(plane(-0.3, -1)), "model.clearance.inside");
  EXPECT_ERROR(build(plane(0, -1)), "model.clearance.middle"); // only touches
  EXPECT_ERROR(build(nurbs::line(Eigen::Vector2d(-1, -0.3), Eigen::Vector2d(2, -0.3))), "model.clearance.inside");
}

/// A disc in the middle of the body penetrates no face.
TEST(Clearance, DiscInTheBodyIsAnError) {
  EXPECT_ERROR(build(ball(0.5, 0.5, 0.1)),
               "model.clearance.center: contact = floor, body = block, center = (0.5, 0.5)");
  EXPECT_ERROR(build(ball(0.02, 0.98, 0.01)),
               "model.clearance.center: contact = floor, body = block, center = (0.02, 0.98)");
}

/// The check uses the curved body, not the hull of its control points.
TEST(Clearance, DiscInAHoleIsFine) {
  const auto shell = [](const Vec<2>& center, double radius) {
    Scene<2> scene;
    const nurbs::Patch arc = nurbs::half_annulus(0.6, 1, Eigen::Vector2d(0, 0));
    scene.bodies.push_back({"shell", make_body(arc, {4, 1}, "N2", "north", solid::neo_hookean(1, 0.3))});
    scene.supports = {{"bed", {face_points(scene, 0, "south")}, {Constraint::fixed, Constraint::fixed}}};
    scene.obstacles = {contact::make_ball<2>(center, radius)};
    scene.contacts = {{"roll", {0, nurbs::side_of("north", 2)}, ObstacleReference{0}, contact::InterfaceLaw{100}, 3}};
    Model<2>{std::move(scene)};
  };
  shell({0, 0}, 0.6);
  shell({0, -0.45}, 0.1);
  shell({0.9, -0.9}, 0.1); // in the corner of the control points' box
  EXPECT_ERROR(shell({0, -0.8}, 0.1), "model.clearance.center: contact = roll, body = shell, center = (0, -0.8)");
  EXPECT_ERROR(shell({0.56, -0.56}, 0.05),
               "model.clearance.center: contact = roll, body = shell, center = (0.56, -0.56)");
  EXPECT_ERROR(shell({0, 0}, 0.7), "model.clearance.inside");
}

} // namespace clearance_test
} // namespace signorini::model
