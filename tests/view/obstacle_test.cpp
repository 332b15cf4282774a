#include "view/obstacle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace signorini::view {
namespace obstacle_test {

const Style style = style_for({1600, 1000});

/// Draws with 100 pixels per unit, x and y from −4 to 4.
void draw_in_square(Drawing& drawing, Outline outline) {
  outline.line = (100 * outline.line).colwise() + Vec<3>(500, 450, 0);
  draw_obstacle(drawing, outline, {100, 900, 50, 850}, style);
}

struct Drawn {
  std::vector<Vec2> rim, hatching; ///< points in model units
};

/// The ends of all strokes; those of the rim are the thickest.
Drawn draw(const Outline& outline) {
  Drawing drawing{{1000, 900}, {}};
  draw_in_square(drawing, outline);
  double thickest = 0;
  for (const Mark& mark : drawing.marks) thickest = std::max(thickest, std::get<Stroke>(mark).width);
  Drawn drawn;
  for (const Mark& mark : drawing.marks) {
    const Stroke& stroke = std::get<Stroke>(mark);
    for (const auto& [x, y] : stroke.points)
      (stroke.width == thickest ? drawn.rim : drawn.hatching).push_back({(x - 500) / 100, (y - 450) / 100});
  }
  return drawn;
}

double length(const std::vector<Vec2>& line) {
  double sum = 0;
  for (std::size_t i = 1; i < line.size(); ++i)
    sum += std::hypot(line[i][0] - line[i - 1][0], line[i][1] - line[i - 1][1]);
  return sum;
}

TEST(Obstacle, PlaneIsHatchedBehindItsNormalAcrossThePicture) {
  std::mt19937 random(41);
  std::uniform_real_distribution<double> angle(0, 6.3), offset(-3, 3), far(-500, 500);
  for (int trial = 0; trial < 200; ++trial) {
    const double turn = angle(random), height = offset(random), away = far(random);
    const Vec<2> normal(std::cos(turn), std::sin(turn)), along(-normal[1], normal[0]);
    const Drawn drawn = draw(half_plane(height * normal + away * along, 3 * normal));
    const auto above = [&](const Vec2& p) { return normal.dot(Vec<2>(p[0], p[1])) - height; };
    ASSERT_EQ(drawn.rim.size(), 2u);
    for (const Vec2& p : drawn.rim) {
      EXPECT_NEAR(above(p), 0, 1e-9);
      EXPECT_NEAR(std::max(std::abs(p[0]), std::abs(p[1])), 4, 1e-9); // it ends at the frame
    }
    double deepest = 0;
    for (const Vec2& p : drawn.hatching) {
      EXPECT_LE(above(p), 1e-9);
      EXPECT_LE(std::max(std::abs(p[0]), std::abs(p[1])), 4 + 1e-9);
      deepest = std::min(deepest, above(p));
    }
    if (length(drawn.rim) < 1) continue; // only a corner of the picture
    EXPECT_LT(deepest, -0.1);
    EXPECT_GT(drawn.hatching.size() / 2.0, 0.8 * length(drawn.rim) / 0.14 - 2);
  }
}

TEST(Obstacle, CircleIsHatchedInside) {
  const Drawn drawn = draw(circle({0.5, -1}, 1.5));
  const auto radius = [](const Vec2& p) { return std::hypot(p[0] - 0.5, p[1] + 1); };
  EXPECT_NEAR(length(drawn.rim), 2 * 3.14159 * 1.5, 0.01);
  for (const Vec2& p : drawn.hatching) EXPECT_LT(radius(p), 1.5 + 1e-9);
  EXPECT_GT(drawn.hatching.size(), 100u);
  EXPECT_TRUE(draw(circle({20, 0}, 2)).rim.empty());
}

TEST(Obstacle, KeepsItsSideInTheMirror) {
  const Outline plane = half_plane({1, 0.5}, {0.6, 0.8});
  for (int axis : {0, 1}) {
    Vec<2> point(1, 0.5), normal(0.6, 0.8);
    point[axis] *= -1, normal[axis] *= -1;
    for (const Vec2& p : draw(mirrored(plane, axis)).hatching) EXPECT_LE(normal.dot(Vec<2>(p[0], p[1]) - point), 1e-9);
    EXPECT_EQ(mirrored(mirrored(plane, axis), axis).line, plane.line);
  }
  const Drawn drawn = draw(mirrored(circle({2, 0}, 1.5), 0));
  for (const Vec2& p : drawn.hatching) EXPECT_LT(std::hypot(p[0] + 2, p[1]), 1.5 + 1e-9);
}

TEST(Obstacle, HasABandInsteadOfHatchingIfSmall) {
  Drawing drawing{{1000, 900}, {}};
  draw_in_square(drawing, circle({0, 0}, 1));
  int strokes = 0;
  for (const Mark& mark : drawing.marks) {
    strokes += std::holds_alternative<Stroke>(mark);
    const auto* fill = std::get_if<Fill>(&mark);
    for (const Vec2& p : fill ? fill->outline : std::vector<Vec2>()) {
      const double radius = std::hypot(p[0] - 500, p[1] - 450);
      EXPECT_TRUE(radius < 100 + 1e-9 && radius > 88);
    }
  }
  EXPECT_EQ(strokes, 1);
}

TEST(Obstacle, ExtendsThePictureOnlyIfSmallOrNear) {
  const Bounds box = {{0, 0, 0}, {200, 10, 0}};
  EXPECT_EQ(worth_showing(circle({100, 60}, 40), box).cols(), circle({100, 60}, 40).line.cols());
  EXPECT_EQ(worth_showing(circle({100, 600}, 500), box).cols(), 0);
  const Points foot = worth_showing(half_plane({-7, -0.4}, {0, 1}), box);
  ASSERT_EQ(foot.cols(), 1);
  EXPECT_NEAR(foot(0, 0), 100, 1e-9);
  EXPECT_NEAR(foot(1, 0), -0.4, 1e-12);
  EXPECT_EQ(worth_showing(half_plane({0, -300}, {0, 1}), box).cols(), 0);
}

TEST(Obstacle, IsRoundInMagnifiedRegions) {
  const double side = 0.01;
  const Window window =
      box_window(Mat<3>::Identity().topRows<2>(), {2, -side / 2, 0}, {2 + side, side / 2, 0}, {1000, 1000});
  const Points line = circle({1, 0}, 1.001, {window}).line;
  int within = 0;
  for (Eigen::Index i = 1; i < line.cols(); ++i) {
    const Vec<3> middle = 0.5 * (line.col(i) + line.col(i - 1));
    if (middle[0] < 2 || std::abs(middle[1]) > side / 2) continue;
    ++within;
    EXPECT_LT(1.001 - (middle - Vec<3>(1, 0, 0)).norm(), 0.5 * window.pixel);
  }
  EXPECT_GE(within, 2);
  EXPECT_LT(line.cols(), 250);
}

} // namespace obstacle_test
} // namespace signorini::view
