// Elements with one foot point only: bounds on derivatives, the distance below which they hold, and folds within an
// element, where a foot point on one side must not hide the other one.
#include "contact/closest/projection.hpp"
#include "contact/faces3d.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace signorini::contact {
namespace lone_foot_test {

using namespace test;

/// ξ at fractions of an element.
template <int D> FaceCoordinates<D> place(const Surface<D>& surface, int element, double u, double v) {
  FaceCoordinates<D> xi;
  for (int a = 0; a < D - 1; ++a) {
    const auto [from, to] = surface.interval(element, a);
    xi(a) = from + (a == 0 ? u : v) * (to - from);
  }
  return xi;
}

template <int D> Surface<D> random_face(Random& random, int kind) {
  const int degree = integer(random, 1, 3), breaks = integer(random, 0, 4);
  if constexpr (D == 2)
    return {wavy(random, 3, 0.2 + 0.4 * kind, degree, breaks), nurbs::side_of("north", 2)};
  else
    return top_of(wavy_plate(random, 3, 0.02 + 0.1 * kind, degree, breaks));
}

template <int D> void expect_derivatives_within_bounds(unsigned seed) {
  Random random(seed);
  FaceGeometry<D> point;
  for (int face = 0; face < 12; ++face) {
    Surface<D> surface = random_face<D>(random, face % 3);
    if (face % 2 == 0) surface.extend(0.3);
    for (int e = 0; e < surface.elements(); ++e) {
      const DerivativeBounds<D> bounds = derivative_bounds(surface.bezier(e));
      for (int k = 0; k < (D == 2 ? 9 : 81); ++k) {
        surface.locate(e, place<D>(surface, e, (k % 9) / 8.0, (k / 9) / 8.0), 2, point);
        for (std::size_t a = 0; a < D - 1; ++a)
          for (int i = 0; i < D; ++i) {
            EXPECT_GE(point.tangent[a](i), bounds.lower[a](i) - 1e-10);
            EXPECT_LE(point.tangent[a](i), bounds.upper[a](i) + 1e-10);
          }
        for (std::size_t a = 0; a < point.second.size(); ++a)
          EXPECT_LE(point.second[a].norm(), bounds.second[a] * (1 + 1e-10) + 1e-9);
      }
    }
  }
}

TEST(LoneFoot, DerivativesAreWithinTheirBounds) {
  expect_derivatives_within_bounds<2>(1);
  expect_derivatives_within_bounds<3>(2);
}

/// Points on normals, nearer than the distance of their foot point's element: the foot point is the closest of samples
/// of the whole neighborhood.
template <int D> int expect_lone_feet(unsigned seed) {
  Random random(seed);
  int tested = 0;
  FaceGeometry<D> foot, sample;
  for (int face = 0; face < 80; ++face) {
    const Surface<D> surface = random_face<D>(random, face % 3);
    ElementBoxes<D> boxes;
    boxes.update(surface);
    for (int e = 0; e < surface.elements(); ++e) {
      const double most = std::min(std::sqrt(boxes.unique_distance2(e)), 10.0);
      if (most == 0) continue;
      surface.locate(e, place<D>(surface, e, uniform(random, 0.0, 1.0), uniform(random, 0.0, 1.0)), 2, foot);
      const double distance = most * uniform(random, 0.5, 1.0);
      const Vec<D> normal = outward(surface, foot).normalized() * (integer(random, 0, 1) == 0 ? 1 : -1);
      const Vec<D> x = foot.position + distance * normal;
      ++tested;
      for (int other = 0; other < surface.elements(); ++other) {
        if (!smoothly_adjacent(surface, e, other)) continue;
        for (int k = 0; k < (D == 2 ? 33 : 33 * 33); ++k) {
          surface.locate(other, place<D>(surface, other, (k % 33) / 32.0, (k / 33) / 32.0), 0, sample);
          EXPECT_GE((sample.position - x).norm(), distance * (1 - 1e-12));
        }
      }
    }
  }
  return tested;
}

TEST(LoneFoot, IsTheClosestPointOfItsNeighborhood) {
  EXPECT_GT(expect_lone_feet<2>(3), 50);
  EXPECT_GT(expect_lone_feet<3>(4), 50);
}

/// Points around a face: how many have an open end as closest point, and how many of them the quick test finds. It must
/// find no others.
template <int D> std::array<int, 2> count_beyond_ends(Random& random, const Surface<D>& surface) {
  ElementBoxes<D> boxes;
  boxes.update(surface);
  const Vec<D> lower = surface.points().rowwise().minCoeff(), upper = surface.points().rowwise().maxCoeff();
  std::array<int, 2> count{};
  FaceGeometry<D> point;
  for (int trial = 0; trial < 60; ++trial) {
    Vec<D> x;
    for (int i = 0; i < D; ++i) x(i) = uniform(random, 2 * lower(i) - upper(i), 2 * upper(i) - lower(i));
    const bool beyond = project(surface, boxes, x, {}, point).foot == Foot::none, quick = boxes.is_beyond_ends(x);
    EXPECT_TRUE(beyond || !quick) << x.transpose();
    count[0] += beyond;
    count[1] += quick;
  }
  return count;
}

/// Points around random faces, with and without extensions: how many the quick test finds.
template <int D> int count_beyond_ends(unsigned seed) {
  Random random(seed);
  int found = 0;
  for (int face = 0; face < 60; ++face) {
    Surface<D> surface = random_face<D>(random, face % 3);
    if (face % 4 != 0) surface.extend(0.3);
    found += count_beyond_ends(random, surface)[1];
  }
  return found;
}

TEST(LoneFoot, PointsBeyondTheEndsNeedNoSearch) {
  EXPECT_GT(count_beyond_ends<2>(5), 100);
  EXPECT_GT(count_beyond_ends<3>(6), 20);
  Random random(7);
  Surface<2> arc(discretize(nurbs::quarter_annulus(1, 2, Eigen::Vector2d(0, 0), 0), {4, 1}, "N2", "south"),
                 nurbs::side_of("south", 2));
  arc.extend(0.3);
  Surface<3> plate =
      top_of(below({nurbs::KnotVector::single(2), nurbs::KnotVector::single(2)},
                   MatrixX{{0, 1, 2, 0, 1, 2, 0, 1, 2}, {0, 0, 0, 1, 1, 1, 2, 2, 2}, {0, 0, 0, 0, 0.4, 0, 0, 0, 0}},
                   VectorX::Ones(9)));
  plate.extend(0.3);
  for (const auto& [beyond, found] : {count_beyond_ends(random, arc), count_beyond_ends(random, plate)})
    EXPECT_GT(2 * found, beyond);
}

TEST(LoneFoot, KinksAreNoOpenEnds) {
  // Above the ridge of a roof, no line is normal to it.
  Surface<2> roof(polyline({{0, 0}, {1, 1}, {2, 0}}), nurbs::side_of("north", 2));
  roof.extend(0.3);
  ElementBoxes<2> boxes;
  boxes.update(roof);
  FaceGeometry<2> point;
  EXPECT_EQ(project(roof, boxes, {1, 2}, {}, point).foot, Foot::corner);
  EXPECT_FALSE(boxes.is_beyond_ends({1, 2}));
  EXPECT_TRUE(boxes.is_beyond_ends({-3, 0}));
}

TEST(LoneFoot, DistanceIsBelowTheRadiusOfACylinder) {
  // Beyond the axis of an arc of radius 2, all its points are as near as the foot point.
  const Surface<2> arc(discretize(nurbs::quarter_annulus(1, 2, Eigen::Vector2d(0, 0), 0), {16, 1}, "N2", "south"),
                       nurbs::side_of("south", 2));
  ElementBoxes<2> boxes;
  boxes.update(arc);
  for (int e = 0; e < arc.elements(); ++e) {
    EXPECT_LT(std::sqrt(boxes.unique_distance2(e)), 2);
    EXPECT_GT(std::sqrt(boxes.unique_distance2(e)), 0.4);
  }
}

/// A groove y = 20 u² of one quadratic element, −1 ≤ u ≤ 1: its walls are 1.41 apart at y = 10.
MatrixX groove() {
  return MatrixX{{-1, 0, 1}, {20, -20, 20}};
}

TEST(LoneFoot, WallOfAGrooveDoesNotHideTheOppositeOne) {
  const Surface<2> curve(below(nurbs::KnotVector::single(2), groove(), VectorX::Ones(3)), nurbs::side_of("north", 2));
  MatrixX points(3, 9);
  for (int k = 0; k < 9; ++k) points.col(k) << groove()(0, k % 3), 0.5 * (k / 3), groove()(1, k % 3);
  const Surface<3> surface =
      top_of(below({nurbs::KnotVector::single(2), nurbs::KnotVector::single(2)}, points, VectorX::Ones(9)));
  ElementBoxes<2> boxes2;
  boxes2.update(curve);
  ElementBoxes<3> boxes3;
  boxes3.update(surface);
  const double wall = std::sqrt(0.5);
  for (const double depth : {-0.05, 0.01, 0.05}) { // beyond the right wall
    Projection<2> left;
    left.element = 0;
    left.xi(0) = (1 - wall) / 2;
    FaceGeometry<2> point;
    const Projection<2> found = project(curve, boxes2, Vec<2>(wall + depth, 10), left, point);
    // The gap of a straight wall with the slope 40 u, whose curvature changes it by less than 0.1 % here
    const double gap = -depth * 40 * wall / std::hypot(1, 40 * wall);
    EXPECT_NEAR(found.gap, gap, 0.002 * std::abs(gap));
    Projection<3> wide;
    wide.element = 0;
    wide.xi << left.xi(0), 0.4;
    FaceGeometry<3> foot;
    EXPECT_NEAR(project(surface, boxes3, Vec<3>(wall + depth, 0.4, 10), wide, foot).gap, found.gap, 1e-12);
  }
}

} // namespace lone_foot_test
} // namespace signorini::contact
