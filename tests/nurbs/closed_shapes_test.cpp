// Shapes of one patch that are closed or converge to a point, and the hook.
#include "nurbs/shapes.hpp"

#include "measure.hpp"
#include "random_patch.hpp"

#include <gtest/gtest.h>

namespace signorini::nurbs {
namespace closed_shapes_test {

using namespace test;
using std::numbers::pi;

const Vec<3> center(1, 2, 3);

/// Largest difference from `radius` of distance(x) at random points of a face.
template <class Distance> double off(const Patch& patch, Side side, double radius, Distance distance) {
  Random random(11);
  const Patch surface = face(patch, side);
  double most = 0;
  for (int n = 0; n < 200; ++n)
    most = std::max(most, std::abs(distance(evaluate(surface, random_parameter(random, surface))) - radius));
  return most;
}

double from_center(const VectorX& x) {
  return (x - center.head(x.size())).norm();
}
double from_axis(const VectorX& x) {
  return std::hypot(x(0) - 1, x(2) - 3);
}

bool is_closed(const Patch& patch) {
  return face(patch, {0, false}).homogeneous().isApprox(face(patch, {0, true}).homogeneous(), 1e-14);
}

TEST(ClosedShapes, RingAndDiscStartAtTheTop) {
  const Patch closed = ring(1, 2, center.head<2>()), solid = polar_disc(2, center.head<2>());
  for (const Patch& patch : {closed, solid}) {
    EXPECT_TRUE(is_closed(patch));
    EXPECT_LT(off(patch, {1, false}, 2, from_center), 1e-14);
    EXPECT_LT((evaluate(patch, Vec<2>(0, 0)) - Vec<2>(1, 4)).norm(), 1e-14);
    EXPECT_LT((evaluate(patch, Vec<2>(0.25, 0)) - Vec<2>(-1, 2)).norm(), 1e-14);
    EXPECT_GT(measure(patch).least, 0);
  }
  EXPECT_LT(off(closed, {1, true}, 1, from_center), 1e-14);
  EXPECT_LT(off(solid, {1, true}, 0, from_center), 1e-14);
  EXPECT_NEAR(measure(closed).content, 3 * pi, 1e-12);
  EXPECT_NEAR(measure(solid).content, 4 * pi, 1e-12);
  EXPECT_ERROR(ring(2, 1, Vec<2>(0, 0)), "nurbs.shapes.radii: inner = 2, outer = 1");
  EXPECT_ERROR(polar_disc(0, Vec<2>(0, 0)), "nurbs.shapes.length: argument = radius, length = 0");
}

TEST(ClosedShapes, TubeAndCylinderAreAlongY) {
  const Patch closed = tube(1, 2, 4, center), solid = polar_cylinder(2, 4, center);
  for (const Patch& patch : {closed, solid}) {
    EXPECT_TRUE(is_closed(patch));
    EXPECT_LT(off(patch, {2, false}, 2, from_axis), 1e-14);
    EXPECT_LT(off(patch, {1, false}, 2, [](const VectorX& x) { return x(1); }), 1e-14);
    EXPECT_LT(off(patch, {1, true}, 6, [](const VectorX& x) { return x(1); }), 1e-14);
    EXPECT_LT((evaluate(patch, Vec<3>(0, 0, 0)) - Vec<3>(1, 2, 5)).norm(), 1e-14);
    EXPECT_GT(measure(patch, 8).least, 0);
  }
  EXPECT_LT(off(closed, {2, true}, 1, from_axis), 1e-14);
  EXPECT_LT(off(solid, {2, true}, 0, from_axis), 1e-14);
  EXPECT_NEAR(measure(closed).content, 12 * pi, 1e-11);
  EXPECT_NEAR(measure(solid).content, 16 * pi, 1e-11);
  EXPECT_ERROR(tube(1, 2, -4, center), "nurbs.shapes.length: argument = width, length = -4");
  EXPECT_ERROR(polar_cylinder(1, HUGE_VAL, center), "nurbs.shapes.length: argument = width, length = inf");
}

TEST(ClosedShapes, PolarBallIsExact) {
  const Patch patch = polar_ball(2, center);
  EXPECT_TRUE(is_closed(patch));
  EXPECT_LT(off(patch, {2, false}, 2, from_center), 1e-14);
  EXPECT_LT(off(patch, {2, true}, 0, from_center), 1e-14);
  for (const bool at_end : {false, true})
    EXPECT_LT(off(patch, {1, at_end}, 0, [](const VectorX& x) { return std::hypot(x(0) - 1, x(1) - 2); }), 1e-14);
  EXPECT_LT((evaluate(patch, Vec<3>(0, 0, 0)) - Vec<3>(1, 2, 5)).norm(), 1e-14);
  EXPECT_LT((evaluate(patch, Vec<3>(0, 0.5, 0)) - Vec<3>(3, 2, 3)).norm(), 1e-14);
  EXPECT_NEAR(measure(patch).content, 4 * pi / 3 * 8, 1e-10);
  EXPECT_GT(measure(patch).least, 0);
  EXPECT_ERROR(polar_ball(-1, center), "nurbs.shapes.length: argument = radius, length = -1");
}

TEST(ClosedShapes, HookHasItsNoseOnTop) {
  const Patch patch = hook(10, 2, 1, 3, 45, 90, Vec<2>(1, 1));
  const Patch top = face(patch, {1, true});
  const Vec<2> edges[] = {{1, 3}, {11, 3}, {11, 4}, {14, 4}, {15, 3}};
  for (int n = 0; n < 5; ++n) EXPECT_LT((top.points().col(n) - edges[n]).norm(), 1e-14) << n;
  EXPECT_NEAR(measure(patch).content, 14 * 2 + 3 + 0.5, 1e-12);
  for (const double insertion : {5, 45, 85})
    for (const double retention : {5, 45, 90})
      for (const double nose : {0.1, 1.0, 10.0})
        for (const double land : {0.01, 10.0})
          EXPECT_GT(measure(hook(10, 2, nose, land, insertion, retention, Vec<2>(0, 0))).least, 0);
  EXPECT_ERROR(hook(10, 2, 1, 3, 90, 90, Vec<2>(0, 0)), "nurbs.shapes.insertion: angle = 90");
  EXPECT_ERROR(hook(10, 2, 1, 3, 30, 91, Vec<2>(0, 0)), "nurbs.shapes.retention: angle = 91");
  EXPECT_ERROR(hook(10, 2, 0, 3, 30, 45, Vec<2>(0, 0)), "nurbs.shapes.length: argument = nose, length = 0");
  EXPECT_ERROR(hook(10, 2, 1, 0, 30, 45, Vec<2>(0, 0)), "nurbs.shapes.length: argument = land, length = 0");
}

} // namespace closed_shapes_test
} // namespace signorini::nurbs
