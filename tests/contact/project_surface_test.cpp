// The closest point of a surface against brute force, and the rules at borders, kinks and poles.
#include "contact/closest/projection.hpp"

#include "contact/faces3d.hpp"
#include "nurbs/curves.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini::contact {
namespace project_surface_test {

using namespace test;
using Coordinates = FaceCoordinates<3>;

double distance2(const Surface<3>& surface, int element, const Coordinates& xi, const Vec<3>& x) {
  FacePoint<3> point;
  surface.locate(element, xi, 0, point);
  return (x - point.position).squaredNorm();
}

/// Dense samples of every element, with successively finer grids around the best ones.
double least_distance(const Surface<3>& surface, const Vec<3>& x) {
  constexpr int samples = 24;
  double least = std::numeric_limits<double>::infinity();
  for (int e = 0; e < surface.elements(); ++e) {
    const std::array<double, 2> u = surface.interval(e, 0), v = surface.interval(e, 1);
    Coordinates best = Coordinates::Zero();
    double here = std::numeric_limits<double>::infinity();
    const auto look = [&](const Coordinates& middle, const Coordinates& half, int count) {
      const Coordinates around = middle;
      for (int j = 0; j <= count; ++j)
        for (int i = 0; i <= count; ++i) {
          Coordinates xi(around(0) + half(0) * (2.0 * i / count - 1), around(1) + half(1) * (2.0 * j / count - 1));
          xi = Coordinates(std::clamp(xi(0), u[0], u[1]), std::clamp(xi(1), v[0], v[1]));
          const double value = distance2(surface, e, xi, x);
          if (value < here) {
            here = value;
            best = xi;
          }
        }
    };
    Coordinates half((u[1] - u[0]) / 2, (v[1] - v[0]) / 2);
    look({(u[0] + u[1]) / 2, (v[0] + v[1]) / 2}, half, samples);
    for (half *= 2.0 / samples; half.maxCoeff() > 1e-9; half *= 0.5) look(best, half, 4);
    least = std::min(least, here);
  }
  return std::sqrt(least);
}

/// A place on a face above which a point is, and where the search for it starts.
struct Draw {
  Coordinates place, start;
};

/// The largest error of foot points along both tangents, in elements. draw(trial, corner, length): from the end of the
/// face's first element and its lengths.
template <class Drawn> double largest_error(Random& random, const Drawn& draw) {
  double largest = 0;
  int count = 0;
  for (int round = 0; round < 4; ++round) {
    const Surface<3> face = top_of(wavy_plate(random, 3, 0.1, 2, 3));
    ElementBoxes<3> boxes;
    boxes.update(face);
    const auto [left, right] = face.interval(0, 0);
    const auto [low, high] = face.interval(0, 1);
    const Coordinates corner(right, high), length(right - left, high - low);
    for (int trial = 0; trial < 2000; ++trial) {
      const Draw drawn = draw(trial, corner, length);
      FacePoint<3> at, foot;
      face.locate(face.find_element(drawn.place), drawn.place, 1, at);
      const Vec<3> x = at.position + 0.05 * outward(face, at).normalized();
      Projection<3> seed;
      seed.element = 0;
      seed.xi = drawn.start;
      if (project(face, boxes, x, seed, foot).foot != Foot::regular) continue;
      for (int a = 0; a < 2; ++a) {
        const Vec<3>& along = foot.tangent[static_cast<std::size_t>(a)];
        largest = std::max(largest, std::abs((x - foot.position).dot(along)) / (along.squaredNorm() * length(a)));
      }
      ++count;
    }
  }
  EXPECT_GT(count, 5000);
  return largest;
}

TEST(ProjectSurface, FeetNextToBordersOfElementsAreFoundToRoundingError) {
  // A border that cuts off the last step must not shorten it along the border: that error would be of first order in
  // what depends on the coordinates, such as the fading of tractions, and would differ with the start of the search.
  Random random(21);
  const auto draw = [&](int, const Coordinates& corner, const Coordinates& length) {
    const Coordinates place =
        corner + length.cwiseProduct(Coordinates(uniform(random, -2e-9, 2e-9), uniform(random, -1, 0)));
    const double far = std::pow(10, uniform(random, -8, -2));
    const Coordinates apart(uniform(random, -1, 0), uniform(random, -1, 1));
    return Draw{place, Coordinates(corner(0), place(1)) + far * length.cwiseProduct(apart)};
  };
  EXPECT_LT(largest_error(random, draw), 1e-12);
}

TEST(ProjectSurface, FeetBeyondABorderOrACornerAreFoundWhereTheDistanceNoLongerDecreases) {
  // The squared distance changes by less than its rounding error while the foot is 1e-7 of the distance off.
  Random random(22);
  const auto offset = [&] { return std::pow(10, uniform(random, -10, -6)) * (uniform(random, -1, 1) < 0 ? -1 : 1); };
  const auto draw = [&](int trial, const Coordinates& corner, const Coordinates& length) {
    Coordinates place = corner + length.cwiseProduct(Coordinates(offset(), offset()));
    if (trial % 2 == 0) place(1) = corner(1) - length(1) * uniform(random, 0, 1);
    return Draw{place, {corner(0) - length(0) * std::abs(offset()), std::min(place(1), corner(1))}};
  };
  EXPECT_LT(largest_error(random, draw), 1e-12);
}

TEST(ProjectionOnSurface, IsTheGlobalMinimumFromAnySeed) {
  Random random(1);
  int regular = 0, edges = 0, corners = 0, borders = 0, missed = 0;
  for (int face = 0; face < 60; ++face) {
    const Surface<3> surface =
        top_of(wavy_plate(random, 3, face % 2 == 0 ? 0.2 : 0.5, integer(random, 1, 3), integer(random, 0, 4)));
    ElementBoxes<3> boxes;
    boxes.update(surface);
    for (int trial = 0; trial < 30; ++trial) {
      const Vec<3> x(uniform(random, -0.3, 3.3), uniform(random, -0.3, 3.3), uniform(random, -0.8, 0.8));
      Projection<3> seed;
      if (trial % 3 > 0) {
        seed.element = integer(random, 0, surface.elements() - 1);
        for (int a = 0; a < 2; ++a) {
          const auto [from, to] = surface.interval(seed.element, a);
          seed.xi(a) = trial % 3 == 1 ? from : uniform(random, from, to);
        }
      }
      FacePoint<3> point;
      const Projection<3> found = project(surface, boxes, x, seed, point);
      const double distance = (x - point.position).norm();
      missed += distance > least_distance(surface, x) + 1e-8;
      FacePoint<3> again;
      surface.locate(found.element, found.xi, 2, again);
      EXPECT_NEAR((again.position - point.position).norm(), 0, 1e-12);
      EXPECT_NEAR((again.tangent[0] - point.tangent[0]).norm(), 0, 1e-10);
      const Vec<3> line = x - point.position;
      const auto across = [&](int a) {
        return std::abs(line.dot(point.tangent[static_cast<std::size_t>(a)]) /
                        point.tangent[static_cast<std::size_t>(a)].norm());
      };
      switch (found.foot) {
      case Foot::regular:
        ++regular;
        EXPECT_NEAR(across(0), 0, 1e-8);
        EXPECT_NEAR(across(1), 0, 1e-8);
        EXPECT_NEAR(std::abs(found.gap), distance, 1e-8);
        break;
      case Foot::edge:
        ++edges;
        EXPECT_NEAR(across(found.along), 0, 1e-8);
        EXPECT_GE(surface.direction(1 - found.along).knots()->multiplicity(found.xi(1 - found.along)),
                  surface.direction(1 - found.along).degree());
        break;
      case Foot::corner:
        ++corners;
        break;
      case Foot::none:
        ++borders;
      }
      if (found.foot == Foot::edge || found.foot == Foot::corner) {
        EXPECT_NEAR(std::abs(found.gap), distance, 1e-12);
      }
    }
  }
  EXPECT_EQ(missed, 0);
  EXPECT_GT(regular, 200);
  EXPECT_GT(edges, 20);
  EXPECT_GT(corners, 5);
  EXPECT_GT(borders, 50);
}

TEST(ProjectionOnSurface, FollowsAPointAcrossElementsFromItsLastFootPoint) {
  Random random(2);
  const Surface<3> surface = top_of(wavy_plate(random, 3, 0.05, 2, 6));
  ElementBoxes<3> boxes;
  boxes.update(surface);
  Projection<3> seed;
  FacePoint<3> point;
  for (int step = 0; step <= 200; ++step) {
    const double t = 0.2 + 2.6 * step / 200;
    const Vec<3> x(t, 1.5 + std::sin(2 * t), 0.02);
    seed = project(surface, boxes, x, seed, point);
    const Projection<3> fresh = project(surface, boxes, x, {}, point);
    EXPECT_NEAR(seed.gap, fresh.gap, 1e-13);
    EXPECT_EQ(seed.element, fresh.element);
  }
}

TEST(ProjectionOnSurface, SphereGivesItsRadialGapUpToThePole) {
  // The octant's outer face: ξ² ends at the lower pole, a collapsed border.
  nurbs::Plan plan;
  plan.elements = {3, 4, 1};
  plan.contact = {nurbs::side_of("front", 3)};
  plan.labels.assign(2, nurbs::parse_label("N2"));
  plan.thickness_degree = 1;
  const nurbs::Discretization octant(nurbs::sphere_octant(0.5, 1, Eigen::Vector3d::Zero()), plan);
  Surface<3> surface(octant, nurbs::side_of("front", 3));
  surface.extend(0.3);
  ElementBoxes<3> boxes;
  boxes.update(surface);
  Random random(3);
  Projection<3> seed;
  for (int trial = 0; trial < 300; ++trial) {
    const double polar = trial % 3 == 0 ? uniform(random, 1e-9, 1e-3) : uniform(random, 0.01, 1.5);
    const double azimuth = uniform(random, 0.01, 1.56), radius = uniform(random, 0.8, 1.2);
    const Vec<3> out(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth), -std::cos(polar));
    FacePoint<3> point;
    seed = project(surface, boxes, radius * out, seed, point);
    EXPECT_NE(seed.foot, Foot::none) << "polar angle " << polar;
    EXPECT_NEAR(seed.gap, radius - 1, 1e-12) << "polar angle " << polar << ", azimuth " << azimuth;
  }
  // Straight below the pole
  FacePoint<3> point;
  const Projection<3> below = project(surface, boxes, Vec<3>(0, 0, -1.25), {}, point);
  EXPECT_NE(below.foot, Foot::none);
  EXPECT_NEAR(below.gap, 0.25, 1e-12);
  EXPECT_FALSE(boxes.is_beyond_ends({-0.1, -0.1, -1.25})); // the pole is its closest point
  EXPECT_TRUE(boxes.is_beyond_ends({1, 1, 1}));
}

/// The face 0 ≤ x ≤ 3, 0 ≤ y ≤ 2, z = 0, of one element.
Surface<3> flat_rectangle() {
  return top_of(below({nurbs::KnotVector::single(1), nurbs::KnotVector::single(1)},
                      (MatrixX(3, 4) << 0, 3, 0, 3, 0, 0, 2, 2, 0, 0, 0, 0).finished(), VectorX::Ones(4)));
}

TEST(ProjectionOnSurface, DoesNotDependOnWhatThePointHeldBefore) {
  const Surface<3> flat = flat_rectangle();
  ElementBoxes<3> boxes;
  boxes.update(flat);
  FacePoint<3> point;
  point.position = Vec<3>(1e308, 1e308, 0); // products with it overflow
  const Projection<3> found = project(flat, boxes, Vec<3>(-1, -1, 0.5), {}, point);
  EXPECT_EQ(point.position, Vec<3>(0, 0, 0));
  EXPECT_EQ(found.element, 0);
}

TEST(ProjectionOnSurface, HasNoContactAtOpenBorders) {
  const Surface<3> flat = flat_rectangle();
  ElementBoxes<3> boxes;
  boxes.update(flat);
  FacePoint<3> point;
  // Squares of such distances overflow, so that no element is near.
  EXPECT_EQ(project(flat, boxes, Vec<3>(0, -1e200, 0), {}, point).foot, Foot::none);
  for (const Vec<3>& x : {Vec<3>(-0.1, 1, -0.1), Vec<3>(3.1, 1, 0), Vec<3>(1, 2.2, 0.3), Vec<3>(3.2, 2.2, -0.1)})
    EXPECT_EQ(project(flat, boxes, x, {}, point).foot, Foot::none) << x.transpose();
  const Projection<3> inside = project(flat, boxes, Vec<3>(2.99, 0.01, -0.1), {}, point);
  EXPECT_EQ(inside.foot, Foot::regular);
  EXPECT_NEAR(inside.gap, -0.1, 1e-15);
}

TEST(ProjectionOnSurface, ValleyIsAnEdgeInside) {
  // Two planes that meet along x = 1, with material outside the notch
  const nurbs::KnotVector two(1, {0, 0, 1, 2, 2});
  const Surface<3> valley = top_of(
      below({two, nurbs::KnotVector::single(1)},
            (MatrixX(3, 6) << 0, 1, 2, 0, 1, 2, 0, 0, 0, 2, 2, 2, 1, 0, 1, 1, 0, 1).finished(), VectorX::Ones(6)));
  ElementBoxes<3> boxes;
  boxes.update(valley);
  for (int seed_element : {-1, 0, 1})
    for (const Vec<3>& x : {Vec<3>(1, 0.7, -0.2), Vec<3>(1.1, 1.3, -0.15), Vec<3>(0.95, 0.2, -0.3)}) {
      Projection<3> seed;
      seed.element = seed_element;
      seed.xi = Coordinates(seed_element, 0.1);
      FacePoint<3> point;
      const Projection<3> found = project(valley, boxes, x, seed, point);
      EXPECT_EQ(found.foot, Foot::edge);
      EXPECT_EQ(found.along, 1);
      EXPECT_NEAR((point.position - Vec<3>(1, x(1), 0)).norm(), 0, 1e-13);
      EXPECT_NEAR(found.gap, -std::hypot(x(0) - 1, x(2)), 1e-13);
    }
}

} // namespace project_surface_test
} // namespace signorini::contact
