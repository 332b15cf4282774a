#include "view/strokes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace signorini::view {
namespace strokes_test {

double length(const std::vector<std::vector<Vec2>>& parts) {
  double sum = 0;
  for (const auto& part : parts)
    for (std::size_t i = 1; i < part.size(); ++i)
      sum += std::hypot(part[i][0] - part[i - 1][0], part[i][1] - part[i - 1][1]);
  return sum;
}

std::vector<Vec2> random_line(std::mt19937& random, int count) {
  std::uniform_real_distribution<double> coordinate(-2, 3);
  std::vector<Vec2> line;
  for (int i = 0; i < count; ++i) line.push_back({coordinate(random), coordinate(random)});
  return line;
}

TEST(ClipLine, KeepsWhatLiesInsideAsOftenSampledPointsDo) {
  std::mt19937 random(5);
  const Box box = {0, 1, -1, 2};
  for (int trial = 0; trial < 20; ++trial) {
    const auto line = random_line(random, 8);
    constexpr int samples = 20000;
    double inside = 0;
    for (std::size_t i = 1; i < line.size(); ++i)
      for (int k = 0; k < samples; ++k) {
        const double t = (k + 0.5) / samples;
        const double x = line[i - 1][0] + t * (line[i][0] - line[i - 1][0]),
                     y = line[i - 1][1] + t * (line[i][1] - line[i - 1][1]);
        if (x >= 0 && x <= 1 && y >= -1 && y <= 2) inside += length({{line[i - 1], line[i]}}) / samples;
      }
    EXPECT_NEAR(length(clip_line(line, box)), inside, 5e-3);
  }
}

TEST(ClipLine, KeepsALineInsideInOnePiece) {
  const std::vector<Vec2> line = {{0.1, 0}, {0.5, 1}, {0.9, 0}};
  ASSERT_EQ(clip_line(line, {0, 1, -1, 2}).size(), 1u);
  EXPECT_EQ(clip_line(line, {0, 1, -1, 2})[0], line);
  EXPECT_EQ(clip_line({{0.5, 0}, {0.5, 5}, {0.6, 0}}, {0, 1, -1, 2}).size(), 2u);
  EXPECT_TRUE(clip_line({{2, 0}, {2, 1}}, {0, 1, -1, 2}).empty());
}

TEST(DashLine, DrawsTheShareOfItsPattern) {
  std::mt19937 random(6);
  const auto line = random_line(random, 400);
  EXPECT_NEAR(length(dash_line(line, {0.03, 0.01})) / length({line}), 0.75, 1e-3);
  EXPECT_EQ(dash_line(line, {}).size(), 1u);
  EXPECT_EQ(dash_line({{0, 0}, {1, 0}}, {0.3, 0.2}).size(), 2u);
}

TEST(StrokeTriangles, CoverLengthTimesWidth) {
  const auto corners = stroke_triangles({{{0, 0}, {3, 4}}, black, 2});
  double area = 0;
  for (std::size_t t = 0; t < corners.size(); t += 3) {
    const Vec2 &a = corners[t], &b = corners[t + 1], &c = corners[t + 2];
    area += 0.5 * std::abs((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]));
  }
  EXPECT_NEAR(area, 10, 1e-12);
}

} // namespace strokes_test
} // namespace signorini::view
