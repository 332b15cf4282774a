#include "view/cut.hpp"

#include "solid_scenes.hpp"
#include "surfaces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace signorini::view {
namespace cut_test {

using test::length;
using test::volume;

double linear(const Vec<3>& x) {
  return 0.3 + Vec<3>(2, -1, 0.5).dot(x);
}

Vec<3> random_vector(std::mt19937& random) {
  std::uniform_real_distribution<double> number(-1, 1);
  return {number(random), number(random), number(random)};
}

/// The lines in a plane.
std::vector<SurfaceLine> within(const std::vector<SurfaceLine>& lines, const CutPlane& plane) {
  std::vector<SurfaceLine> result;
  for (const SurfaceLine& line : lines)
    if ((plane.normal.normalized().transpose() * (line.points.colwise() - plane.point)).cwiseAbs().maxCoeff() < 1e-12)
      result.push_back(line);
  return result;
}

TEST(Cut, LeavesAClosedVolume) {
  std::mt19937 random(5);
  const Body block = mapped_solid(block_map({-2, -1, -0.5}, {2, 1, 0.5}), {4, 2, 3}, 3);
  const Body shell = mapped_solid(shell_map(0.5, 1), {3, 3, 2}, 4);
  ASSERT_NEAR(volume(block.skin), 8, 1e-12);
  for (int trial = 0; trial < 40; ++trial) {
    const Vec<3> normal = random_vector(random);
    // A plane through its center halves the block.
    EXPECT_NEAR(volume(cut(block, {{0, 0, 0}, normal}).skin), 4, 1e-9);
    // The volumes of both parts add up to the whole, for any tessellated solid.
    const Vec<3> point = 0.6 * (random_vector(random) + Vec<3>::Ones());
    const double rest = volume(cut(shell, {point, normal}).skin), taken = volume(cut(shell, {point, -normal}).skin);
    EXPECT_NEAR(rest + taken, volume(shell.skin), 1e-9);
    EXPECT_TRUE(rest > -1e-12 && taken > -1e-12);
  }
}

TEST(Cut, ColorsTheCutFaceByTheValuesInside) {
  std::mt19937 random(6);
  const Body block = mapped_solid(block_map({0, 0, 0}, {2, 1, 1}), {2, 2, 2}, 3, linear);
  for (int trial = 0; trial < 20; ++trial) {
    const Body left = cut(block, {{1, 0.5, 0.5}, random_vector(random)});
    ASSERT_EQ(left.skin.values.size(), left.skin.points.cols());
    for (Eigen::Index i = 0; i < left.skin.points.cols(); ++i)
      EXPECT_NEAR(left.skin.values[i], linear(left.skin.points.col(i)), 1e-12);
  }
}

TEST(Cut, ShowsElementBordersOnTheCutFace) {
  const Body block = mapped_solid(block_map({0, 0, 0}, {4, 2, 1}), {8, 4, 2}, 3);
  const CutPlane plane{{0, 0.9, 0}, {0, -2, 0}};
  const Body left = cut(block, plane);
  EXPECT_NEAR(area(left.skin) - area(cut(block.skin, plane, 0)), 4, 1e-12);
  EXPECT_NEAR(length(within(left.rim, plane)), 10, 1e-12);
  // Seven vertical lines and a horizontal one, each from both adjacent elements, and those at the rim
  EXPECT_NEAR(length(within(left.mesh_lines, plane)), 2 * (7 + 4) + 10, 1e-12);
  for (const SurfaceLine& line : within(left.rim, plane))
    EXPECT_LT((line.normals.col(0) - Vec<3>(0, -1, 0)).norm(), 1e-12);
  for (const SurfaceLine& line : left.mesh_lines) EXPECT_GE(line.points.row(1).minCoeff(), 0.9 - 1e-12);
  EXPECT_GE(left.skin.points.row(1).minCoeff(), 0.9 - 1e-12);
}

TEST(Cut, MakesOneFaceAtElementBorders) {
  // Rounding error, or that of a solution, moves the common border of elements to either side of the plane.
  const SolidMap exact = block_map({0, 0, 0}, {3, 1, 1});
  for (const double error : {1e-13, 1e-6}) {
    const SolidMap moved = [&](const Vec<3>& cube) {
      return Vec<3>(exact(cube) * (1 + error * std::sin(1e4 * cube[1])));
    };
    const Body block = mapped_solid(moved, {3, 2, 2}, 3);
    for (double side : {-1.0, 1.0}) {
      const CutPlane plane{{1, 0, 0}, {side, 0, 0}};
      const Body left = cut(block, plane), ideal = cut(mapped_solid(exact, {3, 2, 2}, 3), plane);
      EXPECT_NEAR(volume(left.skin), side < 0 ? 2 : 1, 1e-9 + 10 * error);
      EXPECT_NEAR(area(left.skin), side < 0 ? 10 : 6, 1e-9 + 10 * error);
      EXPECT_NEAR(length(left.mesh_lines), length(ideal.mesh_lines), 1e-9 + 100 * error);
    }
  }
}

TEST(Cut, RemovesAllOrNothing) {
  const Body block = mapped_solid(block_map({0, 0, 0}, {1, 1, 1}), {2, 2, 2}, 2, linear);
  const Body all = cut(block, {{2, 0, 0}, {1, 0, 0}}), none = cut(block, {{2, 0, 0}, {-1, 0, 0}});
  EXPECT_EQ(all.skin.triangles.cols(), block.skin.triangles.cols());
  EXPECT_NEAR(length(all.rim), length(block.rim), 1e-12);
  EXPECT_EQ(none.skin.triangles.cols(), 0);
  EXPECT_TRUE(none.rim.empty() && none.mesh_lines.empty());
  // A plane along a side of the block removes nothing, or everything.
  EXPECT_NEAR(area(cut(block, {{1, 0, 0}, {1, 0, 0}}).skin), 7, 1e-12); // that side is counted twice
  EXPECT_EQ(cut(block, {{1, 0, 0}, {-1, 0, 0}}).skin.triangles.cols(), 0);
}

TEST(Cut, KeepsControlPointsOnTheRemainingSide) {
  Body solid = mapped_solid(block_map({0, 0, 0}, {1, 1, 1}), {1, 1, 1}, 1);
  solid.control_points.resize(3, 4);
  solid.control_points << 0, 0.3, 0.6, 0.9, 0, 0, 0, 0, 0, 0, 0, 0;
  solid.net_lines = {{0, 1}, {1, 2}, {2, 3}};
  const Body left = cut(solid, {{0.5, 0, 0}, {-1, 0, 0}});
  ASSERT_EQ(left.control_points.cols(), 2);
  EXPECT_EQ(left.control_points(0, 0), 0.6);
  EXPECT_EQ(left.net_lines, (std::vector<std::array<int, 2>>{{0, 1}}));
}

TEST(Solid, IsJoinedWithItsMirrorImage) {
  Body block = mapped_solid(block_map({0, 0, 0}, {2, 1, 1}), {2, 2, 2}, 2, linear);
  const double whole = area(block.skin), rim = length(block.rim), mesh = length(block.mesh_lines);
  join_at_mirror(block, 0);
  EXPECT_NEAR(area(block.skin), whole - 1, 1e-12);
  EXPECT_NEAR(length(block.rim), rim - 2 * 4, 1e-12); // the side's own rim and that of its neighbors
  EXPECT_NEAR(length(block.mesh_lines), mesh - 2 + 4,
              1e-12); // its borders are removed, the rims of its neighbors become borders
  const Body image = mirrored(block, 0, -1);
  EXPECT_NEAR(volume(image.skin), 2, 1e-12);
  EXPECT_EQ(image.skin.points.row(0).minCoeff(), -2);
  EXPECT_EQ(image.skin.values, -block.skin.values);
  const Body back = mirrored(image, 0, -1);
  EXPECT_EQ(back.skin.points, block.skin.points);
  EXPECT_EQ(back.rim.back().normals, block.rim.back().normals);
  EXPECT_EQ(back.inside.back().points, block.inside.back().points);
}

} // namespace cut_test
} // namespace signorini::view
