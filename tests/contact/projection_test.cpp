// The closest point against brute force, and the rules at ends, kinks and element borders.
#include "contact/closest/projection.hpp"

#include "contact/faces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace signorini::contact {
namespace projection_test {

using namespace test;

double distance(const Surface<2>& surface, int element, double xi, const Vec<2>& x) {
  FacePoint<2> point;
  surface.locate(element, FaceCoordinates<2>(xi), 0, point);
  return (x - point.position).norm();
}

/// Dense samples of every element, each local minimum refined by golden section search.
double least_distance(const Surface<2>& surface, const Vec<2>& x) {
  constexpr int samples = 200;
  const double golden = (std::sqrt(5.0) - 1) / 2;
  double least = std::numeric_limits<double>::infinity();
  for (int e = 0; e < surface.elements(); ++e) {
    const auto [a, b] = surface.interval(e, 0);
    std::vector<double> values;
    for (int k = 0; k <= samples; ++k) values.push_back(distance(surface, e, a + (b - a) * k / samples, x));
    for (int k = 0; k <= samples; ++k) {
      const std::size_t i = static_cast<std::size_t>(k);
      if ((k > 0 && values[i - 1] < values[i]) || (k < samples && values[i + 1] < values[i])) continue;
      double low = a + (b - a) * std::max(k - 1, 0) / samples, high = a + (b - a) * std::min(k + 1, samples) / samples;
      for (int step = 0; step < 60; ++step) {
        const double left = high - golden * (high - low), right = low + golden * (high - low);
        (distance(surface, e, left, x) < distance(surface, e, right, x) ? high : low) =
            distance(surface, e, left, x) < distance(surface, e, right, x) ? right : left;
      }
      least = std::min({least, values[i], distance(surface, e, low, x)});
    }
  }
  return least;
}

Projection<2> project_from(const Surface<2>& surface, const Vec<2>& x, const Projection<2>& seed = {}) {
  ElementBoxes<2> boxes;
  boxes.update(surface);
  FacePoint<2> point;
  return project(surface, boxes, x, seed, point);
}

/// Squares of such distances overflow, so that no element is near.
TEST(Projection, FindsNoContactBeyondTheRangeOfSquares) {
  Random random(4);
  const Surface<2> surface(wavy(random, 3, 0.6, 2, 1), nurbs::side_of("north", 2));
  EXPECT_EQ(project_from(surface, Vec<2>(1e200, 0)).foot, Foot::none);
  EXPECT_EQ(project_from(surface, Vec<2>(1, std::numeric_limits<double>::quiet_NaN())).foot, Foot::none);
}

TEST(Projection, IsTheGlobalMinimumFromAnySeed) {
  Random random(1);
  int regular = 0, corners = 0, ends = 0;
  for (int curve = 0; curve < 60; ++curve) {
    const Surface<2> surface(wavy(random, 3, 0.6, integer(random, 1, 4), integer(random, 0, 5)),
                             nurbs::side_of("north", 2));
    ElementBoxes<2> boxes;
    boxes.update(surface);
    for (int trial = 0; trial < 40; ++trial) {
      const Vec<2> x(uniform(random, -0.5, 3.5), uniform(random, -1.2, 1.2));
      Projection<2> seed;
      if (trial % 4 > 0) {
        seed.element = integer(random, 0, surface.elements() - 1);
        const auto [a, b] = surface.interval(seed.element, 0);
        seed.xi(0) = trial % 4 == 1 ? a : uniform(random, a, b);
      }
      FacePoint<2> point;
      const Projection<2> found = project(surface, boxes, x, seed, point);
      const double distance = (x - point.position).norm();
      EXPECT_NEAR(distance, least_distance(surface, x), 1e-9) << "curve " << curve << " trial " << trial;
      if (found.foot != Foot::none) {
        EXPECT_NEAR(std::abs(found.gap), distance, 1e-9);
      }
      EXPECT_EQ(point.element, found.element);
      const nurbs::KnotVector& knots = *surface.direction(0).knots();
      const bool at_end = found.xi(0) == knots.first() || found.xi(0) == knots.last();
      const double slope = (x - point.position).dot(point.tangent[0]) / point.tangent[0].norm();
      switch (found.foot) {
      case Foot::regular:
        ++regular;
        EXPECT_NEAR(slope, 0, 1e-8);
        EXPECT_NEAR(found.gap, (x - point.position).dot(outward(surface, point).normalized()), 1e-14);
        break;
      case Foot::corner:
        ++corners;
        EXPECT_FALSE(at_end);
        EXPECT_GE(knots.multiplicity(found.xi(0)), knots.degree());
        break;
      case Foot::edge:
        ADD_FAILURE() << "a curve has no edges";
        break;
      case Foot::none:
        ++ends;
        EXPECT_TRUE(at_end);
      }
    }
  }
  EXPECT_GT(regular, 1000);
  EXPECT_GT(corners, 100);
  EXPECT_GT(ends, 100);
}

TEST(Projection, HasNoContactAtOpenEnds) {
  const Surface<2> flat(discretize(nurbs::rectangle(3, 1, Eigen::Vector2d(0, 0)), {8, 3}, "N2", "north"),
                        nurbs::side_of("north", 2));
  for (const Vec<2>& x : {Vec<2>(-0.1, 0.9), Vec<2>(3.2, 0.5), Vec<2>(3.01, 1.5)})
    EXPECT_EQ(project_from(flat, x).foot, Foot::none) << x.transpose();
  const Projection<2> last = project_from(flat, Vec<2>(2.99, 0.9));
  EXPECT_EQ(last.foot, Foot::regular);
  EXPECT_NEAR(last.gap, -0.1, 1e-15);
}

TEST(Projection, ValleyIsACornerInside) {
  // Material is outside the notch: below the valley the vertex is the closest point for all x in the cone between the
  // faces' normals.
  const Vec<2> vertex(1, 0);
  const Surface<2> valley(polyline({{0, 1}, vertex, {2, 1}}), nurbs::side_of("north", 2));
  for (const Vec<2>& x : {Vec<2>(1, -0.2), Vec<2>(1.1, -0.15), Vec<2>(0.95, -0.3)}) {
    for (int seed_element : {-1, 0, 1}) {
      Projection<2> seed;
      seed.element = seed_element;
      seed.xi(0) = seed_element == 1 ? 1.7 : 0.2;
      const Projection<2> found = project_from(valley, x, seed);
      EXPECT_EQ(found.foot, Foot::corner);
      EXPECT_EQ(found.xi(0), 1.0);
      EXPECT_NEAR(found.gap, -(x - vertex).norm(), 1e-15);
    }
  }
  // Above the valley either face is closer than the vertex.
  const Projection<2> above = project_from(valley, Vec<2>(1.2, 0.6));
  EXPECT_EQ(above.foot, Foot::regular);
  EXPECT_NEAR(above.gap, 0.4 / std::sqrt(2.0), 1e-15);
}

TEST(Projection, RidgeIsACornerOutside) {
  const Vec<2> vertex(1, 0);
  const Surface<2> ridge(polyline({{0, -1}, vertex, {2, -1}}), nurbs::side_of("north", 2));
  const Projection<2> outside = project_from(ridge, Vec<2>(1.05, 0.3));
  EXPECT_EQ(outside.foot, Foot::corner);
  EXPECT_NEAR(outside.gap, (Vec<2>(1.05, 0.3) - vertex).norm(), 1e-15);
  const Projection<2> inside = project_from(ridge, Vec<2>(1.1, -0.4));
  EXPECT_EQ(inside.foot, Foot::regular);
  EXPECT_NEAR(inside.gap, -0.3 / std::sqrt(2.0), 1e-15);
}

/// A collinear vertex is not a kink, and sliding across it or across a smooth border changes nothing.
TEST(Projection, CrossesBordersSmoothly) {
  const Surface<2> straight(polyline({{0, 0}, {1, 0}, {2, 0}}), nurbs::side_of("north", 2));
  const Projection<2> on_border = project_from(straight, Vec<2>(1, -0.1));
  EXPECT_EQ(on_border.foot, Foot::regular);
  EXPECT_NEAR(on_border.gap, -0.1, 1e-15);

  const Surface<2> arc(discretize(nurbs::half_annulus(0.3, 0.5, Eigen::Vector2d(0, 0)), {6, 1}, "N2", "south"),
                       nurbs::side_of("south", 2));
  Projection<2> seed;
  for (int k = 1; k < 400; ++k) {
    const double angle = std::acos(-1.0) * (1 + k / 400.0), radius = 0.48;
    const Vec<2> x = radius * Vec<2>(std::cos(angle), std::sin(angle));
    seed = project_from(arc, x, seed);
    ASSERT_EQ(seed.foot, Foot::regular) << k;
    EXPECT_NEAR(seed.gap, radius - 0.5, 1e-14);
  }
  EXPECT_EQ(seed.element, 5);
}

} // namespace projection_test
} // namespace signorini::contact
