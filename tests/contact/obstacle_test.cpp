// Closed-form rigid masters: closest points against brute force, geometry against differences, slip points, and the
// same shapes as NURBS curves.
#include "contact/point/master.hpp"

#include "contact/faces.hpp"
#include "differences.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace signorini::contact {
namespace obstacle_test {

using namespace test;
using std::numbers::pi;

/// A shape and its translation.
struct Case {
  Obstacle<2> shape;
  Vec<2> translation;
  Master<2> master() const {
    Master<2> result(shape);
    result.move(translation.data());
    return result;
  }
};

Case random_plane(Random& random) {
  return {
      make_plane<2>({uniform(random, -1, 1), uniform(random, -1, 1)}, {uniform(random, -3, 3), uniform(random, -3, 3)}),
      {uniform(random, -1, 1), uniform(random, -1, 1)}};
}
Case random_ball(Random& random) {
  return {make_ball<2>({uniform(random, -1, 1), uniform(random, -1, 1)}, uniform(random, 0.2, 3),
                       uniform(random, 0, 1) < 0.5),
          {uniform(random, -1, 1), uniform(random, -1, 1)}};
}

Vec<2> position(const Master<2>& master, double xi) {
  FacePoint<2> point;
  master.locate(FaceCoordinates<2>(xi), point);
  return point.position;
}

/// Samples of ξ from −10 to 10, the best one refined by golden section.
double least_distance(const Master<2>& master, const Vec<2>& x) {
  const auto distance = [&](double xi) { return (x - position(master, xi)).norm(); };
  constexpr double step = 0.01, golden = 0.6180339887498949;
  double best = -10;
  for (double xi = -10; xi <= 10; xi += step)
    if (distance(xi) < distance(best)) best = xi;
  double low = best - step, high = best + step;
  for (int k = 0; k < 60; ++k) {
    const double left = high - golden * (high - low), right = low + golden * (high - low);
    (distance(left) < distance(right) ? high : low) = distance(left) < distance(right) ? right : left;
  }
  return distance(low);
}

TEST(Obstacle, ClosestPointIsTheGlobalMinimum) {
  Random random(1);
  for (int trial = 0; trial < 60; ++trial) {
    const bool plane = trial % 2 == 0;
    const Case obstacle = plane ? random_plane(random) : random_ball(random);
    const Master<2> master = obstacle.master();
    const Vec<2> x(uniform(random, -3, 3), uniform(random, -3, 3));
    FacePoint<2> point;
    const Projection<2> found = master.project(x, {}, point);
    EXPECT_EQ(found.foot, Foot::regular);
    const Vec<2> normal = master.normal(point);
    EXPECT_NEAR(normal.norm(), 1, 1e-15);
    EXPECT_NEAR((x - point.position - found.gap * normal).norm(), 0, 1e-14);
    EXPECT_NEAR(std::abs(found.gap), least_distance(master, x), 1e-9);
    EXPECT_NEAR((position(master, found.xi(0)) - point.position).norm(), 0, 1e-15);
    // The gap is negative inside the shape by its definition.
    if (plane) {
      const auto& [through, out] = std::get<Plane<2>>(obstacle.shape);
      EXPECT_NEAR(found.gap, (x - obstacle.translation - through).dot(out), 1e-14);
    } else {
      const auto& [center, radius, hollow] = std::get<Ball<2>>(obstacle.shape);
      EXPECT_NEAR(found.gap, (hollow ? -1 : 1) * ((x - obstacle.translation - center).norm() - radius), 1e-14);
    }
  }
}

TEST(Obstacle, GeometryIsTheDerivativeOfThePosition) {
  Random random(2);
  for (int trial = 0; trial < 40; ++trial) {
    const Case obstacle = trial % 2 == 0 ? random_plane(random) : random_ball(random);
    const Master<2> master = obstacle.master();
    const Vec<2> x(uniform(random, -3, 3), uniform(random, -3, 3));
    FacePoint<2> point;
    const double xi = master.project(x, {}, point).xi(0);
    const auto along = [&](double h) { return position(master, xi + h); };
    const Vec<2> tangent = signorini::test::derivative<Vec<2>>(along, 1e-2);
    const Vec<2> second = (along(1e-3) - 2 * along(0) + along(-1e-3)) / 1e-6;
    EXPECT_NEAR((tangent - point.tangent[0]).norm(), 0, 1e-11);
    EXPECT_NEAR((second - point.second[0]).norm(), 0, 1e-6);
  }
}

TEST(Obstacle, HasOneNodeForItsTranslation) {
  Random random(3);
  const nurbs::Patch arc = nurbs::arc(Eigen::Vector2d(0, 0), 1, 20, 160);
  for (const Obstacle<2>& shape : {random_plane(random).shape, random_ball(random).shape, Obstacle<2>(arc)}) {
    Master<2> master(shape);
    EXPECT_TRUE(master.rigid());
    EXPECT_EQ(master.most_functions(), 1);
    const Vec<2> before = position(master, 0.3), by(0.3, -0.4);
    EXPECT_NEAR(master.move(by.data()), 0.5, 1e-15);
    EXPECT_NEAR((position(master, 0.3) - before - by).norm(), 0, 1e-15);
    EXPECT_EQ(master.move(by.data()), 0);
    const Vec<2> home(0, 0);
    master.move(home.data());
    EXPECT_EQ(position(master, 0.3), before);
    FacePoint<2> point;
    master.project(Vec<2>(0.1, 1.2), {}, point);
    master.functions(point, 1);
    EXPECT_EQ(point.value[0], 1);
    EXPECT_EQ(point.derivative[0][0], 0);
  }
}

/// The slip point ends at the given distance from the foot point, on the shorter path between its old position and the
/// foot point.
TEST(Obstacle, SlipPointFollowsUntilItIsAtTheGivenDistance) {
  Random random(4);
  for (int trial = 0; trial < 200; ++trial) {
    const bool plane = trial % 2 == 0;
    const Case obstacle = plane ? random_plane(random) : random_ball(random);
    const Master<2> master = obstacle.master();
    FacePoint<2> foot;
    // On the ball the foot points are near the seam at ±π, with slip points on both sides of it.
    foot.xi(0) = plane ? uniform(random, -2, 2) : std::remainder(pi + uniform(random, -0.5, 0.5), 2 * pi);
    const double apart = uniform(random, -1.5, 1.5);
    const double slip = plane ? foot.xi(0) + apart : std::remainder(foot.xi(0) + apart, 2 * pi);
    master.locate(foot.xi, foot);
    const double before = (position(master, slip) - foot.position).norm();
    const double length = uniform(random, 0, 1) * before;
    const double after = master.advance(FaceCoordinates<2>(slip), foot, length).xi(0);
    EXPECT_NEAR((position(master, after) - foot.position).norm(), length, 1e-14);
    // On that path: the chords from the old slip point to it and from it to the foot point form less than a right
    // angle.
    EXPECT_GE((position(master, after) - position(master, slip)).dot(foot.position - position(master, slip)), 0);
    EXPECT_EQ(master.advance(FaceCoordinates<2>(slip), foot, 2 * before).xi(0), slip);
  }
}

TEST(Obstacle, CurvesAgreeWithClosedForms) {
  Random random(5);
  const Eigen::Vector2d center(0.4, -0.3);
  // Both curves run from right to left, with the outside above.
  const Master<2> arc(nurbs::arc(center, 1.3, 10, 170)),
      line(nurbs::line(Eigen::Vector2d(4, 1), Eigen::Vector2d(-4, -1)));
  const Master<2> ball(make_ball<2>(center, 1.3)), plane(make_plane<2>({0, 0}, {-1, 4}));
  for (int trial = 0; trial < 100; ++trial) {
    const bool round = trial % 2 == 0;
    const double angle = uniform(random, 0.1 * pi, 0.9 * pi), radius = uniform(random, 0.9, 2);
    const Vec<2> x = round ? Vec<2>(center + radius * Vec<2>(std::cos(angle), std::sin(angle)))
                           : Vec<2>(uniform(random, -3, 3), uniform(random, -0.5, 0.5));
    FacePoint<2> curve, closed;
    const auto by_curve = (round ? arc : line).project(x, {}, curve),
               by_form = (round ? ball : plane).project(x, {}, closed);
    EXPECT_EQ(by_curve.foot, Foot::regular);
    EXPECT_NEAR(by_curve.gap, by_form.gap, 1e-14);
    EXPECT_NEAR((curve.position - closed.position).norm(), 0, 1e-14);
    EXPECT_NEAR(((round ? arc : line).normal(curve) - (round ? ball : plane).normal(closed)).norm(), 0, 1e-14);
  }
}

TEST(Obstacle, ErrorsNameTheArgument) {
  const double nan = std::nan("");
  EXPECT_ERROR(make_plane<2>({0, 0}, {0, 0}), "contact.plane.normal");
  EXPECT_ERROR(make_plane<2>({0, nan}, {0, 1}), "contact.plane.finite");
  EXPECT_ERROR(make_ball<2>({0, 0}, 0), "contact.obstacle.radius: radius = 0");
  EXPECT_ERROR(make_ball<2>({0, 0}, nan), "contact.obstacle.radius");
  EXPECT_ERROR(make_ball<2>({nan, 0}, 1), "contact.obstacle.center");
}

} // namespace obstacle_test
} // namespace signorini::contact
