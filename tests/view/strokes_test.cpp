#include "view/drawing.hpp"

#include <gtest/gtest.h>

#include <cmath>
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

TEST(ClipLine, AgreesWithDenseSampling) {
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

} // namespace strokes_test
} // namespace signorini::view
