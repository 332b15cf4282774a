#include "view/clip.hpp"
#include "view/panel.hpp"

#include "scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace signorini::view {
namespace panel_test {

TEST(Mirrored, TurnsOneCoordinateAndTheSignOfTheValues) {
  Body body = bent_ring({1.5, 0.2}, 0.5, 1, 0, 4, 2);
  body.rim = body.undeformed = {body.mesh_lines[0].points};
  for (int axis : {0, 1}) {
    const Body image = mirrored(body, axis, -1);
    EXPECT_EQ(image.points.row(axis), -body.points.row(axis));
    EXPECT_EQ(image.points.row(1 - axis), body.points.row(1 - axis));
    EXPECT_EQ(image.control_points.row(axis), -body.control_points.row(axis));
    EXPECT_EQ(image.mesh_lines[3].points.row(axis), -body.mesh_lines[3].points.row(axis));
    EXPECT_EQ(image.rim[0].row(axis), -body.rim[0].row(axis));
    EXPECT_EQ(image.undeformed[0].row(axis), -body.undeformed[0].row(axis));
    EXPECT_EQ(image.values, -body.values);
    EXPECT_EQ(mirrored(image, axis, -1).points, body.points);
  }
}

struct Integral {
  double area = 0, value = 0;
};

/// Area and ∫ value dA over a field's triangles.
Integral integral(const Field& field) {
  Integral sum;
  for (const auto& [a, b, c] : field.triangles) {
    const Vec2 &p = field.points[a], &q = field.points[b], &r = field.points[c];
    const double area = 0.5 * std::abs((q[0] - p[0]) * (r[1] - p[1]) - (r[0] - p[0]) * (q[1] - p[1]));
    sum.area += area;
    sum.value += area * (field.values[a] + field.values[b] + field.values[c]) / 3;
  }
  return sum;
}

TEST(ClipField, KeepsAreaAndValuesInTheBoxesThatTileThePlane) {
  std::mt19937 random(51);
  std::uniform_real_distribution<double> coordinate(-3, 3);
  Field field{{}, {}, {}, {0, 1}, {}};
  for (int i = 0; i < 90; ++i) {
    field.points.push_back({coordinate(random), coordinate(random)});
    field.values.push_back(coordinate(random));
    if (i % 3 == 2) field.triangles.push_back({i - 2, i - 1, i});
  }
  const Integral whole = integral(field);
  const double cuts[] = {-9, -0.7, 1.1, 9};
  Integral sum;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const Box box = {cuts[i], cuts[i + 1], cuts[j], cuts[j + 1]};
      const Field part = clip_field(field, box);
      for (const Vec2& p : part.points) {
        EXPECT_TRUE(p[0] >= box[0] - 1e-12 && p[0] <= box[1] + 1e-12);
        EXPECT_TRUE(p[1] >= box[2] - 1e-12 && p[1] <= box[3] + 1e-12);
      }
      sum.area += integral(part).area, sum.value += integral(part).value;
    }
  EXPECT_NEAR(sum.area, whole.area, 1e-10);
  EXPECT_NEAR(sum.value, whole.value, 1e-10);
}

} // namespace panel_test
} // namespace signorini::view
