#include "view/figure.hpp"
#include "view/panel.hpp"

#include "scenes.hpp"

#include <gtest/gtest.h>

namespace signorini::view {
namespace panel_test {

TEST(Mirrored, ReversesOneCoordinateAndTheSignOfValues) {
  Body body = bent_ring({1.5, 0.2}, 0.5, 1, 0, 4, 2);
  body.rim = body.undeformed_rim = {body.mesh_lines[0]};
  for (int axis : {0, 1}) {
    const Body image = mirrored(body, axis, -1);
    EXPECT_EQ(image.skin.points.row(axis), -body.skin.points.row(axis));
    EXPECT_EQ(image.skin.points.row(1 - axis), body.skin.points.row(1 - axis));
    EXPECT_EQ(image.control_points.row(axis), -body.control_points.row(axis));
    EXPECT_EQ(image.mesh_lines[3].points.row(axis), -body.mesh_lines[3].points.row(axis));
    EXPECT_EQ(image.rim[0].points.row(axis), -body.rim[0].points.row(axis));
    EXPECT_EQ(image.undeformed_rim[0].points.row(axis), -body.undeformed_rim[0].points.row(axis));
    EXPECT_EQ(image.skin.values, -body.skin.values);
    EXPECT_EQ(mirrored(image, axis, -1).skin.points, body.skin.points);
  }
}

TEST(Relief, ShowsNothingOutsideItsWindow) {
  Field field;
  field.points.resize(3, 3);
  field.points << -100, 300, -100, -100, -100, 300, 0, 0, 0;
  field.triangles = Eigen::Vector3i(0, 1, 2);
  field.values.setZero(3);
  field.range = {0, 1};
  field.colors = {{200, 0, 0}, {200, 0, 0}};
  for (const Box& window : {Box{20, 50, 10, 40}, Box{0, 80, 30, 60}}) {
    Plate plate{{{80, 60}, {}}};
    plate.reliefs.push_back({window, {field}});
    const Pixels pixels = image_of(plate, 1, false);
    for (int y = 0; y < 60; ++y)
      for (int x = 0; x < 80; ++x) {
        const bool inside = x >= window[0] && x < window[1] && y >= window[2] && y < window[3];
        EXPECT_EQ(pixels.argb[(59 - y) * 80 + x], inside ? 0xFFC80000 : 0xFFFFFFFF) << x << ", " << y;
      }
  }
}

} // namespace panel_test
} // namespace signorini::view
