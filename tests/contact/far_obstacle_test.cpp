// Round obstacles with a far center and planes through a far point: closest points, gaps and slip points as exact as
// coordinates near the contact, tangents of contacts, and coordinates of files of version 7.
#include "contact/point/master.hpp"

#include "contact/couple.hpp"
#include "contact/couple3d.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace signorini::contact {
namespace far_obstacle_test {

using namespace test;

/// Distance of x from a circle or sphere that touches the origin with the normal n: |x + R n| − R without cancellation.
template <int D> double distance(double radius, const Vec<D>& n, const Vec<D>& x) {
  return (2 * radius * n.dot(x) + x.squaredNorm()) / ((x + radius * n).norm() + radius);
}

template <int D> struct Case {
  Obstacle<D> shape;
  std::function<double(const Vec<D>&)> gap;
};

std::vector<Case<2>> discs(double radius) {
  const Vec<2> up(0, 1), oblique(0.6, 0.8), aside(7, 0);
  return {{make_ball<2>({0, -radius}, radius), [=](const Vec<2>& x) { return distance<2>(radius, up, x); }},
          {make_ball<2>({0, radius}, radius, true), [=](const Vec<2>& x) { return -distance<2>(radius, -up, x); }},
          {make_ball<2>({7, -radius}, radius), [=](const Vec<2>& x) { return distance<2>(radius, up, x - aside); }},
          // 3, 4, 5: touches the origin exactly
          {make_ball<2>({-3 * radius, -4 * radius}, 5 * radius),
           [=](const Vec<2>& x) { return distance<2>(5 * radius, oblique, x); }},
          {make_plane<2>({radius, 0}, {0, 1}), [](const Vec<2>& x) { return x(1); }}};
}

std::vector<Case<3>> round_shapes(double radius) {
  const Vec<3> up(0, 0, 1), oblique(0, 0.6, 0.8);
  const auto across_y = [](Vec<3> x) {
    x(1) = 0;
    return x;
  };
  // The tube touches the origin with its outermost circle, of radius L = R + r: √((L + x)² + y²) − L = o, then as a
  // disc
  const auto torus = [](double ring, double tube, const Vec<3>& x) {
    const double sum = ring + tube;
    const double out = (x(0) * (2 * sum + x(0)) + x(1) * x(1)) / (std::hypot(sum + x(0), x(1)) + sum);
    return distance<2>(tube, {1, 0}, {out, x(2)});
  };
  return {{make_ball<3>({0, 0, -radius}, radius), [=](const Vec<3>& x) { return distance<3>(radius, up, x); }},
          {make_ball<3>({0, 0, radius}, radius, true), [=](const Vec<3>& x) { return -distance<3>(radius, -up, x); }},
          {make_ball<3>({0, -3 * radius, -4 * radius}, 5 * radius),
           [=](const Vec<3>& x) { return distance<3>(5 * radius, oblique, x); }},
          {make_cylinder({0, radius, -radius}, {0, 1, 0}, radius),
           [=](const Vec<3>& x) { return distance<3>(radius, up, across_y(x)); }},
          {make_cylinder({0, 1, radius}, {0, 1, 0}, radius, true),
           [=](const Vec<3>& x) { return -distance<3>(radius, -up, across_y(x)); }},
          {make_torus({-radius - 2, 0, 0}, {0, 0, 1}, radius, 2), [=](const Vec<3>& x) { return torus(radius, 2, x); }},
          {make_torus({-2 * radius, 0, 0}, {0, 0, 1}, 1.25 * radius, 0.75 * radius),
           [=](const Vec<3>& x) { return torus(1.25 * radius, 0.75 * radius, x); }}};
}

template <int D> std::vector<Case<D>> cases(double radius) {
  if constexpr (D == 2)
    return discs(radius);
  else
    return round_shapes(radius);
}

template <int D> Vec<D> anywhere(Random& random, double size) {
  Vec<D> x;
  for (int i = 0; i < D; ++i) x(i) = uniform(random, -size, size);
  return x;
}

template <int D> void expect_exact() {
  Random random(1);
  for (const double radius : {4.0, 4e3, 4e6, 4e9})
    for (const Case<D>& one : cases<D>(radius)) {
      Master<D> master(one.shape);
      for (int trial = 0; trial < 50; ++trial) {
        const Vec<D> shift = anywhere<D>(random, 1), x = anywhere<D>(random, 1);
        master.move(shift.data());
        FacePoint<D> foot, slip, after;
        const Projection<D> found = master.project(x, {}, foot);
        EXPECT_NEAR(found.gap, one.gap(x - shift), 2e-14) << "R " << radius;
        EXPECT_NEAR((foot.position + found.gap * master.normal(foot) - x).norm(), 0, 1e-14);
        master.locate(found.point(), after);
        EXPECT_NEAR((after.position - foot.position).norm(), 0, 1e-15);
        // A slip point at a distance of 1e-8 is found again, and follows the foot point.
        const Vec<D> nearby = foot.position + 1e-8 * foot.tangent[0].normalized();
        const MasterPoint<D> old = master.project(nearby, {}, slip).point();
        EXPECT_NEAR((slip.position - nearby).norm(), 0, 4e-15) << "R " << radius;
        master.locate(master.advance(old, foot, 0.5e-8), after);
        EXPECT_NEAR((after.position - foot.position).norm(), 0.5e-8, 4e-15);
      }
    }
}

TEST(FarObstacle, PointsAndGapsHaveErrorsOfNearCoordinates) {
  expect_exact<2>();
  expect_exact<3>();
}

TEST(FarObstacle, TurnsAboutAFarCenter) {
  // A disc turned about (−P, 0) by an angle that lowers it by 1e-4
  constexpr double arm = 1e7, down = 1e-4, radius = 2;
  Master<2> turned(make_ball<2>({0, radius}, radius), Turning<2>{{-arm, 0}, arm}),
      moved(make_ball<2>({0, radius}, radius));
  const double angle = -down / arm;
  const std::array<double, 6> markers{
      0, 0, -arm * angle * angle / 2, arm * angle, -arm * angle, -arm * angle * angle / 2};
  turned.move(markers.data(), Eigen::Matrix<double, 2, Eigen::Dynamic>::Zero(2, 1));
  const Vec<2> by(-radius * angle, -down), x(0.3, -0.01); // of the disc's center
  moved.move(by.data());
  FacePoint<2> foot;
  const double gap = moved.project(x, {}, foot).gap;
  EXPECT_NEAR(turned.project(x, {}, foot).gap, gap, 1e-14);
}

TEST(FarObstacle, TangentIsTheForcesDerivative) {
  unsigned seed = 1;
  for (const double mu : {0.0, 0.3})
    for (const double radius : {4e3, 4e6}) {
      Census sum;
      for (const Obstacle<2>& shape :
           {Obstacle<2>(make_ball<2>({1.3, -radius}, radius)), Obstacle<2>(make_ball<2>({1.3, radius}, radius, true)),
            Obstacle<2>(make_plane<2>({radius, 0}, {0, 1}))})
        sum.add(press_and_drag(Couple("N2", shape, InterfaceLaw{100, 100, mu}, 1.3, 0.1), ++seed, 0.06, {1e-3, 0.1}));
      EXPECT_GE(sum.states, 6);
      EXPECT_GT(sum.stick, 20);
      EXPECT_EQ(sum.slip > 10, mu > 0);
    }
}

/// Presses, drags and turns.
template <class Look> void wander(Couple3& couple, const Look& look) {
  couple.touch();
  for (const Vec<3>& by : {Vec<3>(0, 0, -0.02), Vec<3>(1e-4, 0, 0), Vec<3>(0.03, 0.02, 0), Vec<3>(-0.01, 0, -0.01)}) {
    couple.move_die(by).evaluate();
    look(couple);
    couple.pair.accept();
  }
}

TEST(FarObstacle, ForcesOnLargeShapesAreThoseOnAPlane) {
  // Shapes of radius R leave the plane by x²/2R.
  constexpr double radius = 1e10;
  const Obstacle<3> plane = make_plane<3>({0, 0, 0}, {0, 0, 1});
  for (const Obstacle<3>& shape :
       {Obstacle<3>(make_ball<3>({0, 0, -radius}, radius)), Obstacle<3>(make_ball<3>({0, 0, radius}, radius, true)),
        Obstacle<3>(make_cylinder({radius, 0, -radius}, {1, 0, 0}, radius)),
        Obstacle<3>(make_cylinder({0, 3, radius}, {1, 1, 0}, radius, true)),
        Obstacle<3>(make_plane<3>({radius, radius, 0}, {0, 0, 1}))}) {
    const InterfaceLaw law{100, 100, 0.3};
    std::vector<Dense> expected;
    Couple3 flat("N2", plane, law, {0.2, 0.1, 0.1}), round("N2", shape, law, {0.2, 0.1, 0.1});
    wander(flat, [&](Couple3& now) { expected.push_back(now.dense()); });
    std::size_t next = 0;
    wander(round, [&](Couple3& now) {
      const Dense at = now.dense(), &right = expected[next++];
      ASSERT_GT(right.force.norm(), 0.01);
      EXPECT_NEAR((at.force - right.force).norm(), 0, 1e-7 * right.force.norm());
      EXPECT_NEAR((at.tangent - right.tangent).norm(), 0, 1e-7 * right.tangent.norm());
    });
  }
}

} // namespace far_obstacle_test
} // namespace signorini::contact
