#include "nurbs/directions.hpp"

#include "measure.hpp"
#include "nurbs/shapes.hpp"
#include "nurbs/transform.hpp"
#include "random_patch.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace signorini::nurbs {
namespace directions_test {

using namespace test;

TEST(Reverse, TraversesTheSamePointsBackwards) {
  Random random(71);
  for (int run = 0; run < 20; ++run) {
    const int directions = 1 + run % 3, d = integer(random, 0, directions - 1);
    const Patch patch = random_patch(random, directions, 3, 3), back = reverse(patch, d);
    for (int i = 0; i < 5; ++i) {
      const VectorX xi = random_parameter(random, patch);
      VectorX mirrored = xi;
      mirrored(d) = -1 + (3 - xi(d)); // knots from −1 to 3
      EXPECT_LT((evaluate(back, mirrored) - evaluate(patch, xi)).norm(), 1e-12);
    }
    EXPECT_EQ(reverse(back, d).homogeneous(), patch.homogeneous());
  }
}

TEST(Reverse, PreservesEndKnotsBitwise) {
  const KnotVector knots(1, {0.1, 0.1, 0.2, 0.7, 0.7});
  const Patch back = reverse(make_patch({knots}, MatrixX::Random(2, 3)), 0);
  EXPECT_EQ(back.direction(0).first(), 0.1);
  EXPECT_EQ(back.direction(0).last(), 0.7);
  EXPECT_NEAR(back.direction(0).breaks()[1], 0.6, 1e-15);
}

TEST(Swap, ExchangesParameters) {
  Random random(72);
  for (int run = 0; run < 10; ++run) {
    const Patch patch = random_patch(random, 3, 3, 2), swapped = swap_directions(patch, 0, 2);
    EXPECT_EQ(swapped.direction(0), patch.direction(2));
    const VectorX xi = random_parameter(random, patch);
    EXPECT_LT((evaluate(swapped, xi.reverse()) - evaluate(patch, xi)).norm(), 1e-13);
  }
}

TEST(Directions, InvalidOnesAreRejected) {
  const Patch flat = rectangle(1, 1, Vec<2>(0, 0));
  EXPECT_ERROR(reverse(flat, 2), "nurbs.patch.direction: direction = 2, count = 2");
  EXPECT_ERROR(swap_directions(flat, 0, -1), "nurbs.patch.direction: direction = -1, count = 2");
}

TEST(Mirror, ReflectsEveryPoint) {
  Random random(73);
  const Vec<3> point(0.3, -0.2, 0.5), normal(1, 2, -2);
  const Patch curve = random_patch(random, 1, 3), image = mirror(curve, point, normal);
  for (int i = 0; i < 5; ++i) {
    // A curve in space keeps its direction.
    const VectorX xi = random_parameter(random, curve), x = evaluate(curve, xi), y = evaluate(image, xi);
    EXPECT_NEAR((0.5 * (x + y) - point).dot(normal), 0, 1e-13);
    EXPECT_LT(Vec<3>((y - x).head<3>()).cross(normal).norm(), 1e-13);
  }
}

TEST(Mirror, KeepsBodiesRightHandedAndFaceNames) {
  const Patch slab = mirror(rectangle(3, 1, Vec<2>(1, 0)), Vec<2>(0, 0), Vec<2>(2, 0));
  EXPECT_EQ(evaluate(slab, Vec<2>(0, 0)), Vec<2>(-4, 0)); // west is still on the left
  EXPECT_NEAR(measure(slab, 2).content, 3, 1e-14);        // signed: positive when right-handed
  const Patch ring = mirror(quarter_annulus(1, 2, Vec<2>(0, 0), 0), Vec<2>(0, 0), Vec<2>(0, 1));
  EXPECT_NEAR(measure(ring, 12).content, 0.75 * std::numbers::pi, 1e-12);
  const Patch box = mirror(block({1, 2, 3}, Vec<3>(0, 0, 0)), Vec<3>(0, 0, 0), Vec<3>(0, 0, 1));
  EXPECT_EQ(evaluate(box, Vec<3>(0, 0, 0)), Vec<3>(0, 0, -3));
  EXPECT_NEAR(measure(box, 2).content, 6, 1e-13);
}

TEST(Mirror, KeepsTheOutsideOfCurvesAndSurfaces) {
  // The outside of a plane curve is on its right: an upper half circle traversed from left to right.
  const Patch image = mirror(arc(Vec<2>(0, 0), 1, 180, 0), Vec<2>(0, 0), Vec<2>(0, 1));
  const VectorX middle = VectorX::Constant(1, 0.5 * (image.direction(0).first() + image.direction(0).last()));
  const VectorX tangent = derivatives(image, middle, 1)[1].value, place = evaluate(image, middle);
  EXPECT_NEAR(place(1), -1, 1e-14);
  EXPECT_LT(tangent(1) * place(0) - tangent(0) * place(1), 0); // the inside is still on the right
  EXPECT_ERROR(mirror(image, Vec<2>(0, 0), Vec<2>(0, 0)), "nurbs.mirror.normal");
  EXPECT_ERROR(mirror(image, Vec<2>(0, 0), Vec<3>(0, 0, 1)),
               "nurbs.transform.coordinates: argument = normal, expected = 2, count = 3");
}

} // namespace directions_test
} // namespace signorini::nurbs
