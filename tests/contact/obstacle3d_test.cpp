// Planes, balls, cylinders, tori and level sets in 3D: closest points, geometry against differences, slip points on the
// shortest path; and slip points on surfaces.
#include "contact/point/master.hpp"
#include "contact/point/slip.hpp"

#include "contact/faces3d.hpp"
#include "contact/level_sets.hpp"
#include "differences.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace signorini::contact {
namespace obstacle3d_test {

using namespace test;

Vec<3> anywhere(Random& random, double size) {
  return {uniform(random, -size, size), uniform(random, -size, size), uniform(random, -size, size)};
}

double distance(const Torus& torus, const Vec<3>& x) {
  const double height = torus.axis.dot(x - torus.center);
  return std::hypot((x - torus.center - height * torus.axis).norm() - torus.ring, height) - torus.radius;
}

/// A random shape, its closed-form signed distance, and the radius of the tube of a torus.
struct Shape {
  Obstacle<3> shape;
  std::function<double(const Vec<3>&)> gap;
  double tube = 1;
};

std::vector<Shape> shapes(Random& random) {
  const auto plane = make_plane<3>(anywhere(random, 1), anywhere(random, 2));
  const auto ball = make_ball<3>(anywhere(random, 1), uniform(random, 0.3, 2));
  const auto cylinder = make_cylinder(anywhere(random, 1), anywhere(random, 2), uniform(random, 0.3, 2));
  const auto hollow_ball = make_ball<3>(anywhere(random, 1), uniform(random, 0.3, 2), true);
  const auto bore = make_cylinder(anywhere(random, 1), anywhere(random, 2), uniform(random, 0.3, 2), true);
  const double ring = uniform(random, 0.8, 2);
  const auto torus = make_torus(anywhere(random, 1), anywhere(random, 2), ring, uniform(random, 0.3, 0.7) * ring);
  const auto groove =
      make_torus(anywhere(random, 1), anywhere(random, 2), ring, uniform(random, 0.3, 0.7) * ring, true);
  return {
      {plane, [=](const Vec<3>& x) { return plane.normal.dot(x - plane.point); }},
      {ball, [=](const Vec<3>& x) { return (x - ball.center).norm() - ball.radius; }},
      {cylinder, [=](const Vec<3>& x) { return (x - cylinder.point).cross(cylinder.axis).norm() - cylinder.radius; }},
      {hollow_ball, [=](const Vec<3>& x) { return hollow_ball.radius - (x - hollow_ball.center).norm(); }},
      {bore, [=](const Vec<3>& x) { return bore.radius - (x - bore.point).cross(bore.axis).norm(); }},
      {torus, [=](const Vec<3>& x) { return distance(torus, x); }, torus.radius},
      {groove, [=](const Vec<3>& x) { return -distance(groove, x); }, groove.radius},
      {level_set_of(ball, 4), [=](const Vec<3>& x) { return (x - ball.center).norm() - ball.radius; }},
      {level_set_of(torus, 5), [=](const Vec<3>& x) { return distance(torus, x); }, torus.radius}};
}

TEST(ObstacleIn3D, GapIsTheSignedDistance) {
  Random random(1);
  for (int trial = 0; trial < 20; ++trial)
    for (const Shape& shape : shapes(random)) {
      Master<3> master(shape.shape);
      const Vec<3> shift = anywhere(random, 1), x = anywhere(random, 3);
      master.move(shift.data());
      FacePoint<3> point;
      const Projection<3> found = master.project(x, {}, point);
      EXPECT_EQ(found.foot, Foot::regular);
      EXPECT_NEAR(found.gap, shape.gap(x - shift), 1e-13);
      EXPECT_NEAR((point.position + found.gap * master.normal(point) - x).norm(), 0, 1e-13);
      EXPECT_NEAR(master.normal(point).dot(point.tangent[0]), 0, 1e-14);
      EXPECT_NEAR(master.normal(point).dot(point.tangent[1]), 0, 1e-14);
      FacePoint<3> again;
      master.locate(found.point(), again);
      EXPECT_NEAR((again.position - point.position).norm(), 0, 1e-13);
    }
}

TEST(ObstacleIn3D, DerivativeOfTheNormalFollowsFromTangentsAndSecondDerivatives) {
  // Changes of the closest point, τ_α δξ^α, and of the normal, −m^{αβ} (n·x_,βγ) τ_α δξ^γ, against differences in x.
  Random random(2);
  for (int trial = 0; trial < 12; ++trial)
    for (const Shape& shape : shapes(random)) {
      const Master<3> master(shape.shape);
      const Vec<3> x = anywhere(random, 3), direction = anywhere(random, 1);
      FacePoint<3> point, other;
      const Projection<3> found = master.project(x, {}, point);
      if (std::abs(found.gap) < 0.05 || std::abs(shape.gap(x)) > 3) continue;
      const Vec<3> n = master.normal(point);
      Mat<2> metric, hessian;
      for (int a = 0; a < 2; ++a)
        for (int b = 0; b < 2; ++b) {
          const auto& tangents = point.tangent;
          metric(a, b) = tangents[static_cast<std::size_t>(a)].dot(tangents[static_cast<std::size_t>(b)]);
          hessian(a, b) = metric(a, b) - found.gap * n.dot(point.second[static_cast<std::size_t>(a + b)]);
        }
      if (std::abs(hessian.determinant()) < 0.05 * metric.determinant()) continue;
      const Vec<2> shift = hessian.inverse() * Vec<2>(direction.dot(point.tangent[0]), direction.dot(point.tangent[1]));
      const Vec<3> slope = signorini::test::derivative<Vec<3>>(
          [&](double h) {
            master.project(x + h * direction, {}, other);
            return other.position;
          },
          1e-4);
      EXPECT_NEAR((slope - shift(0) * point.tangent[0] - shift(1) * point.tangent[1]).norm(), 0, 1e-8);
    }
}

TEST(ObstacleIn3D, SlipPointFollowsOnTheShortestPath) {
  Random random(3);
  for (int trial = 0; trial < 20; ++trial)
    for (const Shape& shape : shapes(random)) {
      const Master<3> master(shape.shape);
      FacePoint<3> foot, slip, after;
      const Projection<3> at = master.project(anywhere(random, 3), {}, foot);
      const Projection<3> old = master.project(foot.position + anywhere(random, 0.3), {}, slip);
      const double before = (slip.position - foot.position).norm(), length = uniform(random, 0, 1) * before;
      const MasterPoint<3> moved = master.advance(old.point(), foot, length);
      master.locate(moved, after);
      EXPECT_NEAR((after.position - foot.position).norm(), length, 1e-12) << "trial " << trial;
      // Between the two, up to the curvature; not across a tube, from one side to the other
      if (before < shape.tube) {
        EXPECT_LE((after.position - slip.position).norm(), before - length + 0.05 * before);
      }
      EXPECT_EQ((master.advance(old.point(), foot, 1.001 * before).xi - old.xi).norm(), 0);
      EXPECT_TRUE(at.xi.allFinite());
    }
}

TEST(ObstacleIn3D, SlipPointOnASurfaceKeepsLengthAndDirection) {
  Random random(4);
  for (int trial = 0; trial < 60; ++trial) {
    const Surface<3> surface = top_of(wavy_plate(random, 3, 0.05, integer(random, 2, 3), 3));
    FacePoint<3> foot, slip, after;
    const FaceCoordinates<3> middle(uniform(random, 0.3, 0.7), uniform(random, 0.3, 0.7));
    FaceCoordinates<3> from, to;
    for (int a = 0; a < 2; ++a) {
      const double first = surface.direction(a).first(), last = surface.direction(a).last();
      from(a) = first + middle(a) * (last - first);
      to(a) = first + (middle(a) + uniform(random, -0.1, 0.1)) * (last - first);
    }
    surface.locate(surface.find_element(from), from, 2, foot);
    surface.locate(surface.find_element(to), to, 0, slip);
    const Vec<3> chord = slip.position - foot.position;
    const double length = uniform(random, 0.05, 0.95) * chord.norm();
    const FaceCoordinates<3> moved = advance_slip(surface, to, foot, length);
    surface.locate(surface.find_element(moved), moved, 1, after);
    const Vec<3> rest = after.position - foot.position;
    EXPECT_NEAR(rest.norm(), length, 1e-12);
    // The slip point's offset from the chord is along the normal.
    const Vec<3> off = rest - chord * chord.dot(rest) / chord.squaredNorm();
    const Vec<3> normal = outward(surface, after).normalized();
    EXPECT_LE((off - normal * normal.dot(off)).norm(), 0.3 * off.norm() + 1e-12);
  }
}

TEST(ObstacleIn3D, ErrorsNameTheArgument) {
  EXPECT_ERROR(make_cylinder({0, 0, 0}, {0, 0, 0}, 1), "contact.cylinder.axis");
  EXPECT_ERROR(make_cylinder({0, 0, 0}, {0, 0, 1}, -1), "contact.obstacle.radius: radius = -1");
  EXPECT_ERROR(make_ball<3>({0, 0, 0}, 0), "contact.obstacle.radius: radius = 0");
  EXPECT_ERROR(make_plane<3>({0, 0, 0}, {0, 0, 0}), "contact.plane.normal");
}

} // namespace obstacle3d_test
} // namespace signorini::contact
