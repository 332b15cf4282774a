// Points that pass through a master in one step are distinguished from points that it pushes, passes or leaves.
#include "contact/point/crossing.hpp"

#include "contact/faces.hpp"

#include <gtest/gtest.h>

namespace signorini::contact {
namespace crossing_test {

using namespace test;

template <int D> Vec<D> any(Random& random, double size) {
  Vec<D> x;
  for (int k = 0; k < D; ++k) x(k) = uniform(random, -size, size);
  return x;
}

/// Points on straight paths past a moving ball: they cross if the path relative to the ball intersects it and ends with
/// the ball behind the face.
template <int D> void compare_with_balls() {
  Random random(3);
  int crossed = 0, passed = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const double radius = uniform(random, 0.2, 1);
    const Vec<D> center = any<D>(random, 1), shift = any<D>(random, 2);
    Master<D> before(contact::make_ball<D>(center, radius)), now = before;
    now.move(shift.data());
    const Vec<D> from = any<D>(random, 2), to = any<D>(random, 4), outward = any<D>(random, 1).normalized();
    const Vec<D> a = from - center, b = to - shift - center;
    const double t = std::clamp(-a.dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0), nearest = (a + t * (b - a)).norm();
    const double facing = b.normalized().dot(outward);
    if (a.norm() < radius || b.norm() < radius || std::abs(nearest - radius) < 0.02 * radius ||
        std::abs(facing - 0.5) < 1e-6)
      continue;
    const bool expected = nearest < radius && facing > 0.5;
    EXPECT_EQ((has_crossed<D>(before, now, from, to, outward, {}, 0)), expected) << trial;
    EXPECT_FALSE((has_crossed<D>(before, now, from, to, outward, {}, -1e3))) << trial; // deep overlaps are allowed
    ++(expected ? crossed : passed);
  }
  EXPECT_GT(crossed, 20);
  EXPECT_GT(passed, 200);
}

TEST(Crossing, IsDetectedIfAStraightPathIntersectsABallThatEndsBehindTheFace) {
  compare_with_balls<2>();
  compare_with_balls<3>();
}

TEST(Crossing, PointsThatWerePressedInMayLeaveOnTheSameSide) {
  const Master<2> ball(contact::make_ball<2>(Vec<2>(0, 0), 0.5));
  for (const double depth : {0.05, 0.3}) {
    const Vec<2> from(0, depth - 0.5), below(0, -0.52), above(0, 0.52);
    EXPECT_FALSE((has_crossed<2>(ball, ball, from, below, Vec<2>(0, -1), {}, 0))); // a face that has folded over
    EXPECT_TRUE((has_crossed<2>(ball, ball, from, above, Vec<2>(0, 1), {}, 0)));
  }
}

/// A rigid roller above a flat undeformed strip; returns the number of points crossed after steps to these positions of
/// its center.
std::size_t crossed(const std::vector<Vec<2>>& places, const Law& law) {
  const nurbs::Discretization strip =
      discretize(nurbs::rectangle(4, 1, Eigen::Vector2d(0, -1)), {16, 1}, "N2", "north");
  Pair<2> pair(Surface<2>(strip, nurbs::side_of("north", 2)), Obstacle<2>(make_ball<2>(places.front(), 0.5)), law, 3);
  const VectorX rest = VectorX::Zero(2 * strip.functions());
  std::size_t count = 0;
  const auto crossed_now = [&] { return contact::crossed(pair.formulation(), pair.present(), pair.history()).size(); };
  for (const Vec<2>& place : places) {
    const Vec<2> shift = place - places.front();
    pair.evaluate(rest.data(), shift.data());
    count += crossed_now();
    pair.rollback();
    EXPECT_EQ(crossed_now(), 0U);
    pair.evaluate(rest.data(), shift.data());
    pair.accept();
    EXPECT_EQ(crossed_now(), 0U);
  }
  return count;
}

TEST(Crossing, PairCountsPointsThatTheMasterHasPassed) {
  for (const Law& law : {Law(InterfaceLaw{1}), Law(InterfaceLaw{1, 1, 0.3})}) {
    const std::size_t wide = crossed({{2, 1}, {2, -2}}, law), inside = crossed({{2, 1}, {2, -0.6}}, law);
    EXPECT_GT(wide, 8U); // 12 points per length, within its width of 1
    EXPECT_LT(wide, 48U);
    EXPECT_GT(inside, 8U);
    EXPECT_EQ(crossed({{2, 1}, {2, -2}, {2, -3}}, law), wide);  // the last step does not cross
    EXPECT_EQ(crossed({{2, 1}, {2, 0.4}, {2, -2}}, law), wide); // starts in contact
  }
}

TEST(Crossing, IgnoresOtherMotions) {
  for (const Law& law : {Law(InterfaceLaw{1}), Law(InterfaceLaw{1, 1, 0.3})}) {
    EXPECT_EQ(crossed({{2, 1}, {2, 0.4}, {2, 1}, {2, 3}}, law), 0U);          // down and up
    EXPECT_EQ(crossed({{1, 0.4}, {3, 0.4}, {1, 0.3}, {3.4, 0.45}}, law), 0U); // along, farther than its width
    EXPECT_EQ(crossed({{3.5, 0.45}, {4.2, 0.45}, {4.6, 0.2}, {4.6, -0.2}, {4.6, -2}}, law), 0U); // off the end
  }
}

} // namespace crossing_test
} // namespace signorini::contact
