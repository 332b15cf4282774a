#include "view/obstacle.hpp"

#include "surfaces.hpp"
#include "svg.hpp"
#include "view/camera.hpp"
#include "view/cut.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace signorini::view {
namespace rigid_test {

const Bounds box{{0, 0, 0}, {4, 2, 1}};

Bounds extent(const RigidSurface& rigid) {
  Bounds all;
  all.take(rigid.surface.points);
  return all;
}

TEST(Rigid, IsShownCompletelyIfSmall) {
  const RigidSurface ball = shown(RigidBall{{2, 1, 2}, 1}, box);
  EXPECT_NEAR(extent(ball).high[2], 3, 1e-9);
  EXPECT_TRUE(ball.rim.empty());
  for (Eigen::Index i = 0; i < ball.surface.points.cols(); ++i) {
    const Vec<3> out = ball.surface.points.col(i) - Vec<3>(2, 1, 2);
    EXPECT_NEAR(out.norm(), 1, 1e-12);
    EXPECT_LT((out - ball.surface.normals.col(i)).norm(), 1e-12);
  }
}

TEST(Rigid, IsCutToTheBoxOfTheBodies) {
  const double margin = 0.05 * 4;
  const RigidSurface ball = shown(RigidBall{{2, 1, 51}, 50}, box);
  EXPECT_LE(extent(ball).high[0], 4 + margin + 1e-9);
  EXPECT_NEAR(extent(ball).low[1], -margin, 1e-9);
  EXPECT_FALSE(ball.rim.empty());
  const RigidSurface floor = shown(RigidPlane{{100, 100, -0.5}, {0, 0, 3}}, box);
  EXPECT_LT((extent(floor).low - Vec<3>(-margin, -margin, -0.5)).norm(), 1e-9);
  EXPECT_LT((extent(floor).high - Vec<3>(4 + margin, 2 + margin, -0.5)).norm(), 1e-9);
  const RigidSurface cylinder = shown(RigidCylinder{{2, 70, 1.5}, {0, 0.1, 0}, 0.5}, box);
  EXPECT_LT((extent(cylinder).low - Vec<3>(1.5, -margin, 1)).norm(), 1e-9);
  EXPECT_LT((extent(cylinder).high - Vec<3>(2.5, 2 + margin, 2)).norm(), 1e-9);
}

TEST(Rigid, IsRoundInMagnifiedRegions) {
  // From +x, at the highest point of the ball, with 1000 pixels for a hundredth of its radius
  Eigen::Matrix<double, 2, 3> axes;
  axes << 0, 1, 0, 0, 0, 1;
  const double side = 0.01;
  const Window window =
      box_window(axes, {2, 1 - side / 2, 2 - side / 2}, {2, 1 + side / 2, 2 + side / 2}, {1000, 1000});
  const auto departure = [&](const RigidSurface& ball) {
    double largest = 0;
    for (Eigen::Index t = 0; t < ball.surface.triangles.cols(); ++t)
      for (int k = 0; k < 3; ++k) {
        const Vec<3> middle = 0.5 * (ball.surface.points.col(ball.surface.triangles(k, t)) +
                                     ball.surface.points.col(ball.surface.triangles((k + 1) % 3, t)));
        if ((axes * middle - Vec<2>(1, 2)).cwiseAbs().maxCoeff() > side / 2) continue;
        largest = std::max(largest, 1 - (middle - Vec<3>(2, 1, 1)).norm());
      }
    return largest;
  };
  const RigidSurface fine = shown(RigidBall{{2, 1, 1}, 1}, box, {window});
  EXPECT_GT(departure(fine), 0); // some edges are in the window
  EXPECT_LT(departure(fine), 0.5 * window.pixel);
  EXPECT_LT(fine.surface.triangles.cols(), 80000); // limits the refinement at the pole, where all columns meet
}

TEST(Rigid, IsOmittedIfFar) {
  EXPECT_EQ(shown(RigidPlane{{0, 0, -3}, {0, 0, 1}}, box).surface.points.cols(), 0);
  EXPECT_EQ(shown(RigidBall{{2, 1, 9}, 1}, box).surface.points.cols(), 0);
}

TEST(Rigid, HasAnImageUnlessSymmetric) {
  EXPECT_FALSE(mirrored(RigidPlane{{3, 1, 2}, {0, 0, 1}}, 0));
  EXPECT_TRUE(mirrored(RigidPlane{{3, 1, 2}, {0, 0, 1}}, 2));
  EXPECT_TRUE(mirrored(RigidPlane{{0, 0, 0}, {1, 0, 1}}, 0));
  EXPECT_FALSE(mirrored(RigidBall{{0, 1, 2}, 1}, 0));
  const auto ball = mirrored(RigidBall{{0, 1, 2}, 1}, 1);
  ASSERT_TRUE(ball);
  EXPECT_EQ(std::get<RigidBall>(*ball).center, Vec<3>(0, -1, 2));
  EXPECT_FALSE(mirrored(RigidCylinder{{0, 1, 2}, {0, 1, 0}, 1}, 0));
  EXPECT_FALSE(mirrored(RigidCylinder{{0, 1, 2}, {0, 1, 0}, 1}, 1));
  EXPECT_TRUE(mirrored(RigidCylinder{{0, 1, 2}, {0, 1, 1}, 1}, 1));
}

TEST(Camera, LooksAlongTheAxes) {
  for (const std::string& name : camera_names()) {
    const Mat<3> axes = picture_axes(camera(name));
    EXPECT_LT((axes * axes.transpose() - Mat<3>::Identity()).norm(), 1e-12) << name;
    EXPECT_NEAR(axes.determinant(), 1, 1e-12) << name;
  }
  const Mat<3> front = picture_axes(camera("front")), top = picture_axes(camera("top")),
               left = picture_axes(camera("left")), bottom = picture_axes(camera("bottom"));
  EXPECT_EQ(front, (Mat<3>() << 1, 0, 0, 0, 0, 1, 0, -1, 0).finished());
  EXPECT_EQ(top, (Mat<3>() << 1, 0, 0, 0, 1, 0, 0, 0, 1).finished());
  EXPECT_EQ(left, (Mat<3>() << 0, -1, 0, 0, 0, 1, -1, 0, 0).finished());
  EXPECT_EQ(bottom, (Mat<3>() << 1, 0, 0, 0, -1, 0, 0, 0, -1).finished());
  const Mat<3> iso = picture_axes(camera("iso"));
  EXPECT_TRUE(iso(0, 0) > 0 && iso(1, 2) > 0 && iso(2, 1) < 0 && iso(2, 2) > 0);
}

TEST(Camera, RejectsInvalidDirections) {
  EXPECT_TRUE(holds(message_of([] { camera("above"); }),
                    {"view.camera.unknown: camera = above, known = (iso, front, back, left, right, top, bottom)"}));
  EXPECT_TRUE(holds(message_of([] { picture_axes({{0, 0, 0}, {0, 0, 1}}); }), {"view.camera.zero"}));
  EXPECT_TRUE(holds(message_of([] { picture_axes({{0, 0, 2}, {0, 0, -1}}); }), {"view.camera.parallel"}));
}

TEST(Outline, OfABallIsACircleOfTheSameRadius) {
  const Surface ball = shown(RigidBall{{1, 2, 3}, 0.5}, Bounds{{0, 1, 2}, {2, 3, 4}}).surface;
  const auto lines = zeros(ball, ball.normals.row(2).transpose());
  for (const SurfaceLine& line : lines)
    for (const auto& point : line.points.colwise()) {
      EXPECT_NEAR((point - Vec<3>(1, 2, 3)).head<2>().norm(), 0.5, 1e-3);
      EXPECT_NEAR(point[2], 3, 0.02);
    }
  EXPECT_NEAR(test::length(lines), 2 * std::numbers::pi * 0.5, 5e-3);
}

} // namespace rigid_test
} // namespace signorini::view
