#include "nurbs/shapes.hpp"

#include "measure.hpp"
#include "random_patch.hpp"

#include <gtest/gtest.h>

namespace signorini::nurbs {
namespace shapes_test {

using namespace test;
using std::numbers::pi;

VectorX parameters(std::initializer_list<double> values) {
  return Eigen::Map<const VectorX>(values.begin(), static_cast<int>(values.size()));
}

template <class Expected> void expect_point(const Patch& patch, std::initializer_list<double> xi, const Expected& x) {
  EXPECT_LT((evaluate(patch, parameters(xi)) - x).norm(), 1e-14) << evaluate(patch, parameters(xi)).transpose();
}

TEST(Shapes, RectangleFollowsXAndY) {
  const Patch patch = rectangle(3, 1, Vec<2>(-1, 2));
  expect_point(patch, {0, 0}, Vec<2>(-1, 2));
  expect_point(patch, {1, 0}, Vec<2>(2, 2));
  expect_point(patch, {0.5, 1}, Vec<2>(0.5, 3));
  EXPECT_NEAR(measure(patch).content, 3, 1e-14);
  EXPECT_ERROR(rectangle(0, 1, Vec<2>(0, 0)), "nurbs.shapes.length: argument = width, length = 0");
  EXPECT_ERROR(rectangle(1, -1, Vec<2>(0, 0)), "nurbs.shapes.length: argument = height, length = -1");
  EXPECT_ERROR(rectangle(1, 1, Vec<3>(0, 0, 0)),
               "nurbs.transform.coordinates: argument = corner, expected = 2, count = 3");
}

TEST(Shapes, HalfAnnulusRunsFromLeftOverTheBottomToRight) {
  const Patch patch = half_annulus(0.3, 0.5, Vec<2>(0.75, 1.5));
  EXPECT_EQ(patch.direction(0), KnotVector(2, {0, 0, 0, 0.5, 0.5, 1, 1, 1}));
  EXPECT_EQ(patch.direction(1), KnotVector::single(1));
  expect_point(patch, {0, 0}, Vec<2>(0.25, 1.5));
  expect_point(patch, {0.5, 0}, Vec<2>(0.75, 1));
  expect_point(patch, {1, 0}, Vec<2>(1.25, 1.5));
  expect_point(patch, {0.5, 1}, Vec<2>(0.75, 1.2));
  const Measure half = measure(patch);
  EXPECT_NEAR(half.content, pi / 2 * (0.25 - 0.09), 1e-13);
  EXPECT_NEAR(half.centroid(1), 1.5 - 4 * (0.125 - 0.027) / (3 * pi * 0.16), 1e-13);
  EXPECT_GT(half.least, 0);
}

TEST(Shapes, QuarterAnnulusIsExact) {
  const Patch patch = quarter_annulus(1, 2, Vec<2>(1, 1), 180);
  EXPECT_EQ(patch.functions(), 6);
  expect_point(patch, {0, 0}, Vec<2>(-1, 1));
  expect_point(patch, {1, 1}, Vec<2>(1, 0));
  EXPECT_NEAR(measure(patch).content, 3 * pi / 4, 1e-13);
  EXPECT_GT(measure(patch).least, 0);
  EXPECT_ERROR(quarter_annulus(2, 1, Vec<2>(0, 0), 0), "nurbs.shapes.radii: inner = 2, outer = 1");
  EXPECT_ERROR(quarter_annulus(1, 1, Vec<2>(0, 0), 0), "nurbs.shapes.radii: inner = 1, outer = 1");
  EXPECT_ERROR(quarter_annulus(0, 1, Vec<2>(0, 0), 0), "nurbs.shapes.length: argument = inner, length = 0");
  EXPECT_ERROR(half_annulus(0.3, std::nan(""), Vec<2>(0, 0)), "nurbs.shapes.length");
  EXPECT_ERROR(quarter_annulus(1, 2, Vec<2>(0, 0), HUGE_VAL), "nurbs.arc.angles: start = inf, stop = inf");
}

TEST(Shapes, BlockFollowsXYZ) {
  const Patch patch = block({1, 2, 3}, Vec<3>(1, 1, 1));
  expect_point(patch, {1, 0, 0}, Vec<3>(2, 1, 1));
  expect_point(patch, {0, 1, 0}, Vec<3>(1, 3, 1));
  expect_point(patch, {0, 0, 1}, Vec<3>(1, 1, 4));
  EXPECT_NEAR(measure(patch).content, 6, 1e-13);
  EXPECT_NEAR(measure(patch).least, 6, 1e-13);
  EXPECT_ERROR(block({1, 0, 3}, Vec<3>(0, 0, 0)), "nurbs.shapes.length: argument = size y, length = 0");
}

TEST(Shapes, HalfCylinderShellHasItsOuterFaceInFront) {
  const Patch patch = half_cylinder_shell(0.4, 0.5, 0.6, Vec<3>(1, 2, 3));
  expect_point(patch, {0, 0, 0}, Vec<3>(0.5, 2, 3));
  expect_point(patch, {0.5, 0, 0}, Vec<3>(1, 2, 2.5));
  expect_point(patch, {0.5, 1, 1}, Vec<3>(1, 2.6, 2.6));
  expect_point(patch, {1, 0, 0}, Vec<3>(1.5, 2, 3));
  const Measure shell = measure(patch, 8);
  EXPECT_NEAR(shell.content, pi / 2 * 0.09 * 0.6, 1e-12);
  EXPECT_GT(shell.least, 0);
  EXPECT_NEAR(measure(face(patch, {2, false})).content, pi * 0.5 * 0.6, 1e-12);
  EXPECT_ERROR(half_cylinder_shell(0.4, 0.5, 0, Vec<3>(0, 0, 0)), "nurbs.shapes.length: argument = width, length = 0");
  EXPECT_ERROR(half_cylinder_shell(0.5, 0.4, 1, Vec<3>(0, 0, 0)), "nurbs.shapes.radii: inner = 0.5, outer = 0.4");
}

TEST(Shapes, SphereOctantIsExactAndDegenerateOnlyAtThePole) {
  const Vec<3> center(1, 2, 3);
  const Patch patch = sphere_octant(1, 2, center);
  expect_point(patch, {0, 0, 0}, center + Vec<3>(2, 0, 0));
  expect_point(patch, {1, 0, 0}, center + Vec<3>(0, 2, 0));
  for (double t : {0.0, 0.4, 1.0}) expect_point(patch, {t, 1, 1}, center + Vec<3>(0, 0, -1));
  for (double a : {0.1, 0.6})
    for (double b : {0.2, 0.9}) {
      EXPECT_NEAR((evaluate(patch, parameters({a, b, 0})) - center).norm(), 2, 1e-14);
      EXPECT_NEAR((evaluate(patch, parameters({a, b, 1})) - center).norm(), 1, 1e-14);
    }
  const Measure octant = measure(patch, 10);
  EXPECT_NEAR(octant.content, pi / 6 * 7, 1e-11);
  EXPECT_GT(octant.least, 0);
  // Centroid of half a spherical shell: z = −3/8 (b⁴ − a⁴)/(b³ − a³)
  EXPECT_NEAR(octant.centroid(2), 3 - 3 * 15.0 / (8 * 7), 1e-11);
  EXPECT_ERROR(sphere_octant(1, 1, center), "nurbs.shapes.radii: inner = 1, outer = 1");
  EXPECT_ERROR(sphere_octant(1, 2, Vec<2>(0, 0)),
               "nurbs.transform.coordinates: argument = center, expected = 3, count = 2");
}

TEST(Shapes, HollowHemispheresAreExactAndHaveTheFullVolume) {
  const Vec<3> center(1, 2, 3);
  Random random(43);
  for (Poles poles : {Poles::ends, Poles::bottom}) {
    const Patch patch = hollow_hemisphere(2, 3, center, poles);
    for (int n = 0; n < 200; ++n) {
      VectorX xi = random_parameter(random, patch);
      EXPECT_LE(evaluate(patch, xi)(2), center(2) + 1e-14);
      for (double end : {0.0, 1.0}) {
        xi(2) = end;
        EXPECT_NEAR((evaluate(patch, xi) - center).norm(), 3 - end, 1e-14);
      }
    }
    // The volume converges spectrally to 2π/3 (R_o³ − R_i³): each Gauss point adds about two digits.
    const double volume = 2 * pi / 3 * (27 - 8);
    double before = 1;
    for (int points : {3, 5, 7}) {
      const Measure half = measure(patch, points);
      const double error = std::abs(half.content / volume - 1);
      EXPECT_GT(half.least, 0);
      EXPECT_LT(error, before / 50);
      before = error;
    }
    const Measure half = measure(patch, 12);
    EXPECT_NEAR(half.content, volume, 1e-10);
    EXPECT_LT((half.centroid.head(2) - center.head(2)).norm(), 1e-12);
    // Centroid of half a spherical shell: z = −3/8 (b⁴ − a⁴)/(b³ − a³)
    EXPECT_NEAR(half.centroid(2), 3 - 3 * 65.0 / (8 * 19), 1e-11);
    EXPECT_NEAR(measure(face(patch, side_of("front", 3))).content, 2 * pi * 9, 1e-10);
    EXPECT_ERROR(hollow_hemisphere(3, 3, center, poles), "nurbs.shapes.radii: inner = 3, outer = 3");
    EXPECT_ERROR(hollow_hemisphere(1, 3, Vec<2>(0, 0), poles),
                 "nurbs.transform.coordinates: argument = center, expected = 3, count = 2");
  }
}

TEST(Shapes, HollowHemispheresHaveRingAndPolesAsDocumented) {
  const Vec<3> origin(0, 0, 0);
  const Patch ends = hollow_hemisphere(1, 2, origin, Poles::ends);
  expect_point(ends, {0, 0.5, 0}, Vec<3>(-2, 0, 0));
  expect_point(ends, {0.5, 0.5, 0}, Vec<3>(0, 0, -2));
  expect_point(ends, {1, 0.5, 1}, Vec<3>(1, 0, 0));
  for (double t : {0.0, 0.3, 1.0}) {
    expect_point(ends, {t, 0, 0}, Vec<3>(0, -2, 0));
    expect_point(ends, {t, 1, 1}, Vec<3>(0, 1, 0));
    EXPECT_EQ(evaluate(ends, parameters({0, t, 0.5}))(2), 0);
    EXPECT_EQ(evaluate(ends, parameters({1, t, 0.5}))(2), 0);
  }
  const double ring = measure(face(ends, side_of("west", 3))).content;
  EXPECT_NEAR(ring, pi / 2 * 3, 1e-12);

  const Patch bottom = hollow_hemisphere(1, 2, origin, Poles::bottom);
  expect_point(bottom, {0, 0, 0}, Vec<3>(2, 0, 0));
  expect_point(bottom, {0.25, 0, 1}, Vec<3>(0, 1, 0));
  for (double t : {0.0, 0.3, 1.0}) {
    expect_point(bottom, {t, 1, 0}, Vec<3>(0, 0, -2));
    EXPECT_EQ(evaluate(bottom, parameters({t, 0, 0.5}))(2), 0);
  }
  EXPECT_NEAR(measure(face(bottom, side_of("south", 3))).content, pi * 3, 1e-12);
}

/// Largest distance of the indenter's cap from its sphere.
double cap_error(int elements) {
  const Patch patch = spherical_indenter(10, 8, 11, 12, elements, Vec<3>(1, 2, 3));
  const Vec<3> center(6, 6, 3 + 12);
  double worst = 0;
  for (int i = 0; i <= 40; ++i)
    for (int j = 0; j <= 40; ++j)
      worst = std::max(worst, std::abs((evaluate(patch, parameters({i / 40.0, j / 40.0, 0})) - center).norm() - 12));
  return worst;
}

TEST(Shapes, SphericalIndenterConvergesToItsSphereWithThirdOrder) {
  const double coarse = cap_error(5), fine = cap_error(10), finest = cap_error(20);
  EXPECT_LT(coarse, 5e-3);
  EXPECT_GT(std::log2(coarse / fine), 2.6);
  EXPECT_GT(std::log2(fine / finest), 2.6);
}

TEST(Shapes, SphericalIndenterIsABlockLowestInTheMiddle) {
  const Patch patch = spherical_indenter(10, 10, 11, 8, 5, Vec<3>(12.5, 10, 22));
  EXPECT_EQ(patch.direction(0).functions(), 7);
  EXPECT_EQ(patch.direction(1).functions(), 7);
  EXPECT_EQ(patch.direction(2), KnotVector::single(1));
  expect_point(patch, {0.5, 0.5, 0}, Vec<3>(17.5, 15, 22));
  const double cap = 8 - std::sqrt(64.0 - 50);
  expect_point(patch, {0, 1, 0}, Vec<3>(12.5, 20, 22 + cap));
  expect_point(patch, {0.3, 0.8, 1}, Vec<3>(15.5, 18, 33));
  for (double x : {0.1, 0.4, 0.7}) EXPECT_GT(evaluate(patch, parameters({x, 0.3, 0}))(2), 22);
  EXPECT_GT(measure(patch, 4).least, 0);
}

TEST(Shapes, SphericalIndenterRejectsInvalidArguments) {
  const Vec<3> corner(0, 0, 0);
  EXPECT_ERROR(spherical_indenter(10, 10, 11, 7, 5, corner), "nurbs.shapes.cap_radius: radius = 7, least = 7.07107");
  EXPECT_ERROR(spherical_indenter(10, 10, 2, 8, 5, corner), "nurbs.shapes.cap_height: cap = 4.25834, height = 2");
  EXPECT_ERROR(spherical_indenter(10, 10, 11, 8, 0, corner), "nurbs.shapes.cap_elements: elements = 0");
  EXPECT_ERROR(spherical_indenter(0, 10, 11, 8, 5, corner), "nurbs.shapes.length: argument = width, length = 0");
  EXPECT_ERROR(spherical_indenter(10, -1, 11, 8, 5, corner), "nurbs.shapes.length: argument = depth, length = -1");
  EXPECT_ERROR(spherical_indenter(10, 10, 11, std::nan(""), 5, corner), "nurbs.shapes.length");
}

TEST(Transform, MovesRotatesAndScalesEveryPoint) {
  Random random(41);
  for (int run = 0; run < 20; ++run) {
    const int dimension = 2 + run % 2;
    const Patch patch = random_patch(random, 1 + run % dimension, dimension);
    const VectorX xi = random_parameter(random, patch), x = evaluate(patch, xi), center = VectorX::Random(dimension);
    const VectorX by = VectorX::Random(dimension), factors = VectorX::Random(dimension).cwiseAbs();
    const double angle = uniform(random, -720, 720);
    EXPECT_LT((evaluate(translate(patch, by), xi) - (x + by)).norm(), 1e-14);
    EXPECT_LT((evaluate(scale(patch, factors, center), xi) - (center + factors.cwiseProduct(x - center))).norm(),
              1e-14);
    if (dimension == 2) {
      const VectorX turned = Eigen::Rotation2Dd(angle * pi / 180) * Vec<2>(x - center);
      EXPECT_LT((evaluate(rotate(patch, angle, center), xi) - (center + turned)).norm(), 1e-13);
    } else {
      const Vec<3> axis = Vec<3>::Random();
      const VectorX turned = Eigen::AngleAxisd(angle * pi / 180, axis.normalized()) * Vec<3>(x - center);
      EXPECT_LT((evaluate(rotate(patch, angle, center, axis), xi) - (center + turned)).norm(), 1e-13);
    }
  }
}

TEST(Transform, QuarterTurnsAreExact) {
  const Patch patch = rotate(rectangle(2, 1, Vec<2>(0, 0)), 90, Vec<2>(0, 0));
  EXPECT_EQ(patch.points(), (MatrixX(2, 4) << 0, 0, -1, -1, 0, 2, 0, 2).finished());
  EXPECT_EQ(direction_of(-270), Vec<2>(0, 1));
  EXPECT_EQ(direction_of(540), Vec<2>(-1, 0));
  EXPECT_NEAR(direction_of(30)(1), 0.5, 1e-16);
}

TEST(Transform, RejectsInvalidArguments) {
  const Patch flat = rectangle(1, 1, Vec<2>(0, 0)), solid = block({1, 1, 1}, Vec<3>(0, 0, 0));
  const Vec<2> origin(0, 0);
  EXPECT_ERROR(translate(flat, Vec<3>(0, 0, 1)), "nurbs.transform.coordinates: argument = by, expected = 2, count = 3");
  EXPECT_ERROR(scale(flat, Vec<2>(1, 0), origin), "nurbs.transform.zero_factor: factor = 0");
  EXPECT_ERROR(scale(flat, Vec<2>(1, -2), origin), "nurbs.transform.negative_factor: factor = -2");
  EXPECT_ERROR(scale(flat, Vec<2>(1, std::nan("")), origin), "nurbs.transform.finite");
  EXPECT_ERROR(rotate(flat, std::nan(""), origin), "nurbs.transform.angle");
  EXPECT_ERROR(rotate(flat, 30, origin, Vec<3>(0, 0, 1)), "nurbs.transform.plane_axis");
  EXPECT_ERROR(rotate(solid, 30, Vec<3>(0, 0, 0)),
               "nurbs.transform.coordinates: argument = axis, expected = 3, count = 0");
  EXPECT_ERROR(rotate(solid, 30, Vec<3>(0, 0, 0), Vec<3>(0, 0, 0)), "nurbs.transform.axis");
}

} // namespace shapes_test
} // namespace signorini::nurbs
