// Cameras of pictures.

#include "view/camera.hpp"

#include <gtest/gtest.h>

namespace signorini::view {
namespace camera_test {

TEST(Camera, FacesTheNormal) {
  const Camera iso = camera("iso");
  for (const double x : {-1.0, 0.0, 1.0})
    for (const double y : {-1.0, 0.0, 1.0})
      for (const double z : {-1.0, 0.0, 1.0}) {
        const Vec<3> normal(x, y, z);
        if (normal.norm() == 0) continue;
        const Camera turned = turned_to(iso, normal);
        EXPECT_GT(turned.from.dot(normal), 0.1 * turned.from.norm() * normal.norm()) << normal.transpose();
        EXPECT_EQ(turned.from.cwiseAbs(), iso.from.cwiseAbs());
        EXPECT_EQ(turned.up, iso.up);
      }
  EXPECT_EQ(turned_to(iso, -Vec<3>::UnitY()).from, iso.from);
  EXPECT_EQ(turned_to(iso, Vec<3>::UnitY()).from, Vec<3>(0.75, 1.5, 1));
}

} // namespace camera_test
} // namespace signorini::view
