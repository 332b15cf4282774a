#include "nurbs/constructions.hpp"

#include "measure.hpp"
#include "nurbs/curves.hpp"
#include "nurbs/refine.hpp"
#include "random_patch.hpp"

#include <gtest/gtest.h>

namespace signorini::nurbs {
namespace constructions_test {

using namespace test;
using std::numbers::pi;

VectorX parameters(std::initializer_list<double> values) {
  return Eigen::Map<const VectorX>(values.begin(), static_cast<int>(values.size()));
}

TEST(Unify, PreservesMapsAndMatchesKnots) {
  Random random(31);
  for (int run = 0; run < 20; ++run) {
    const Patch first = random_patch(random, 1, 2), second = random_patch(random, 2, 3);
    Patch a = first, b = second;
    unify({{&a, 0}, {&b, 1}});
    EXPECT_EQ(a.direction(0), b.direction(1));
    EXPECT_EQ(b.direction(0), second.direction(0));
    for (int i = 0; i < 10; ++i) {
      const VectorX xi = random_parameter(random, second);
      EXPECT_LT((evaluate(a, xi.tail(1)) - evaluate(first, xi.tail(1))).norm(), 1e-13);
      EXPECT_LT((evaluate(b, xi) - evaluate(second, xi)).norm(), 1e-13);
    }
  }
}

TEST(Unify, MapsOtherIntervalsToTheFirst) {
  // Knots at a third of either interval become one knot despite rounding errors.
  Patch a = make_patch({KnotVector(1, {0, 0, 1 / 3.0, 1, 1})}, MatrixX::Random(2, 3));
  const Patch other = make_patch({KnotVector(1, {-1, -1, 0.1, 2.3, 2.3})}, MatrixX::Random(2, 3));
  Patch b = other;
  unify({{&a, 0}, {&b, 0}});
  EXPECT_EQ(b.direction(0).knots(), (std::vector<double>{0, 0, 1 / 3.0, 1, 1}));
  EXPECT_LT((evaluate(b, parameters({0.25})) - evaluate(other, parameters({-1 + 3.3 * 0.25}))).norm(), 1e-14);
}

TEST(Ruled, JoinsCurvesOfDifferentSpaces) {
  const Patch low = line(Vec<2>(-1, 0), Vec<2>(1, 0)), high = arc(Vec<2>(0, 0), 1, 180, 0);
  const Patch disc = ruled(low, high);
  EXPECT_EQ(disc.direction(0), high.direction(0));
  EXPECT_EQ(disc.direction(1), KnotVector::single(1));
  const Measure half = measure(disc, 16);
  EXPECT_NEAR(half.content, pi / 2, 1e-12);
  EXPECT_NEAR(half.centroid(1), 4 / (3 * pi), 1e-12);
  EXPECT_LT((evaluate(face(disc, {1, false}), parameters({0.3})) - evaluate(low, parameters({0.3}))).norm(), 1e-14);
  EXPECT_LT((evaluate(face(disc, {1, true}), parameters({0.3})) - evaluate(high, parameters({0.3}))).norm(), 1e-14);
}

TEST(Ruled, RejectsMismatchedPatches) {
  const Patch flat = line(Vec<2>(0, 0), Vec<2>(1, 0)), high = line(Vec<3>(0, 0, 1), Vec<3>(1, 0, 1));
  EXPECT_ERROR(ruled(flat, high), "nurbs.ruled.dimension: first = 2, second = 3");
  const Patch surface = extrude(high, Vec<3>(0, 1, 0));
  EXPECT_ERROR(ruled(high, surface), "nurbs.ruled.directions: first = 1, second = 2");
  const Patch volume = extrude(surface, Vec<3>(0, 0, 1));
  EXPECT_ERROR(ruled(volume, volume), "nurbs.ruled.volumes");
  const Patch square = extrude(flat, Vec<2>(0, 1));
  EXPECT_ERROR(ruled(square, square), "nurbs.patch.dimension: directions = 3, dimension = 2");
}

TEST(Extrude, HasTheDimensionOfTheVector) {
  const Patch curve = arc(Vec<2>(0, 0), 1, 0, 90);
  EXPECT_EQ(extrude(curve, Vec<2>(1, 1)).dimension(), 2);
  const Patch cylinder = extrude(curve, Vec<3>(0, 0, 2));
  EXPECT_NEAR(measure(cylinder).content, pi, 1e-13);
  EXPECT_LT((evaluate(cylinder, parameters({0, 0.5})) - Vec<3>(1, 0, 1)).norm(), 1e-15);
  // A sheared quarter disc: volume = area × rise.
  const Patch disc = ruled(line(Vec<2>(0, 0), Vec<2>(1e-3, 0)), arc(Vec<2>(0, 0), 1, 90, 0));
  EXPECT_NEAR(measure(extrude(disc, Vec<3>(3, 1, -2))).content, -2 * measure(disc).content, 1e-13);
  EXPECT_ERROR(extrude(curve, Vec<2>(0, 0)), "nurbs.extrude.length");
  EXPECT_ERROR(extrude(cylinder, Vec<2>(0, 1)),
               "nurbs.transform.coordinates: argument = along, expected = 3, count = 2");
  EXPECT_ERROR(extrude(extrude(cylinder, Vec<3>(1, 0, 0)), Vec<3>(0, 1, 0)), "nurbs.extrude.volume");
}

TEST(Revolve, SphereAndTorusInClosedForm) {
  // Meridian in the x-z plane from the lower to the upper pole, revolved about z.
  const MatrixX upright = (MatrixX(3, 2) << 1, 0, 0, 0, 0, 1).finished();
  const Patch meridian = transform(arc(Vec<2>(0, 0), 2, -90, 90), upright, Vec<3>::Zero());
  const Patch sphere = revolve(meridian, Vec<3>(0, 0, 5), Vec<3>(0, 0, 3), 360);
  EXPECT_NEAR(measure(sphere).content, 4 * pi * 4, 1e-11);
  const Patch ring = transform(circle(Vec<2>(3, 0), 1), upright, Vec<3>(1, 1, 1));
  const Patch torus = revolve(ring, Vec<3>(1, 1, 0), Vec<3>(0, 0, -1), 120);
  EXPECT_NEAR(measure(torus).content, 4 * pi * pi * 3 / 3, 1e-11); // Pappus: 2πr·2πR
}

TEST(Revolve, RotatesEveryPointRightHandedAboutASkewAxis) {
  Random random(32);
  for (int run = 0; run < 20; ++run) {
    const Patch patch = random_patch(random, 1 + run % 2, 3);
    const Vec<3> point = Vec<3>::Random(), axis = Vec<3>::Random();
    const double angle = uniform(random, -360, 360);
    const Patch turned = revolve(patch, point, axis, angle);
    const VectorX xi = random_parameter(random, patch);
    VectorX full(xi.size() + 1);
    full << xi, 1;
    const Eigen::AngleAxisd rotation(angle * pi / 180, axis.normalized());
    const Vec<3> x = evaluate(patch, xi);
    EXPECT_LT((evaluate(turned, full) - (point + rotation * (x - point))).norm(), 1e-13);
    full(full.size() - 1) = 0.37;
    const Vec<3> arm = Vec<3>(evaluate(turned, full)) - point, before = x - point;
    EXPECT_NEAR(arm.norm(), before.norm(), 1e-13);
    EXPECT_NEAR(arm.dot(axis), before.dot(axis), 1e-13);
  }
}

TEST(Revolve, RejectsInvalidArguments) {
  const Patch curve = line(Vec<3>(1, 0, 0), Vec<3>(2, 0, 0));
  const Vec<3> origin(0, 0, 0), z(0, 0, 1);
  EXPECT_ERROR(revolve(line(Vec<2>(1, 0), Vec<2>(2, 0)), origin, z, 90),
               "nurbs.revolve.patch: directions = 1, dimension = 2");
  EXPECT_ERROR(revolve(curve, origin, origin, 90), "nurbs.transform.axis");
  EXPECT_ERROR(revolve(curve, origin, z, 0), "nurbs.revolve.angle: angle = 0");
  EXPECT_ERROR(revolve(curve, origin, z, 361), "nurbs.revolve.angle: angle = 361");
  EXPECT_ERROR(revolve(curve, origin, z, std::nan("")), "nurbs.revolve.angle");
  EXPECT_ERROR(revolve(curve, Vec<2>(0, 0), z, 90),
               "nurbs.transform.coordinates: argument = point, expected = 3, count = 2");
}

TEST(Coons, PreservesItsFourCurves) {
  // A quarter annulus bounded by lines and arcs of different degrees and knots.
  const Patch inner = arc(Vec<2>(0, 0), 1, 90, 0), outer = arc(Vec<2>(0, 0), 2, 90, 0);
  const Patch west = elevate(line(Vec<2>(0, 1), Vec<2>(0, 2)), 0, 2);
  const Patch east = insert_knots(line(Vec<2>(1, 0), Vec<2>(2, 0)), 0, {0.3});
  const Patch surface = coons({west, east, insert_knots(inner, 0, {0.4, 0.4}), outer});
  const Patch faces[] = {west, east, inner, outer};
  for (int f = 0; f < 4; ++f)
    for (double t : {0.0, 0.2, 0.7, 1.0})
      EXPECT_LT(
          (evaluate(face(surface, {f / 2, f % 2 == 1}), parameters({t})) - evaluate(faces[f], parameters({t}))).norm(),
          1e-14);
  // Between concentric arcs the blend is the exact annulus.
  EXPECT_NEAR(measure(surface).content, 3 * pi / 4, 1e-12);
  EXPECT_GT(measure(surface).least, 0);
}

TEST(Coons, ReproducesTrilinearVolumes) {
  // Faces of a trilinear brick with random corners: the blend is the brick.
  Random random(33);
  MatrixX corners(3, 8);
  for (int n = 0; n < 8; ++n)
    corners.col(n) =
        Vec<3>(n & 1, n >> 1 & 1, n >> 2) + Vec<3>::NullaryExpr([&] { return uniform(random, -0.2, 0.2); });
  const KnotVector knots = KnotVector::single(1);
  const Patch brick = make_patch({knots, knots, knots}, corners);
  std::vector<Patch> faces;
  for (int f = 0; f < 6; ++f) faces.push_back(face(brick, {f / 2, f % 2 == 1}));
  faces[0] = k_refine(faces[0], 1, 3, {0.3});
  faces[4] = elevate(faces[4], 0, 1);
  const Patch volume = coons(faces);
  EXPECT_EQ(volume.direction(0).degree(), 2);
  EXPECT_EQ(volume.direction(1).degree(), 1);
  EXPECT_EQ(volume.direction(2).degree(), 3);
  for (int i = 0; i < 20; ++i) {
    const VectorX xi = random_parameter(random, brick);
    EXPECT_LT((evaluate(volume, xi) - evaluate(brick, xi)).norm(), 1e-14);
  }
}

TEST(Coons, PreservesItsSixCurvedSurfaces) {
  Random random(34);
  // The faces of a rational volume meet; the blend must reproduce them.
  const KnotVector two(2, {0, 0, 0, 0.4, 1, 1, 1}), one = KnotVector::single(1), three = KnotVector::single(3);
  MatrixX points(3, 4 * 2 * 4);
  VectorX weights(points.cols());
  for (int n = 0; n < points.cols(); ++n) {
    points.col(n) = Vec<3>(n % 4, n / 4 % 2, n / 8) + Vec<3>::NullaryExpr([&] { return uniform(random, -0.3, 0.3); });
    weights(n) = uniform(random, 0.9, 1.1);
  }
  const Patch solid = make_patch({two, one, three}, points, weights);
  std::vector<Patch> faces;
  for (int f = 0; f < 6; ++f) faces.push_back(face(solid, {f / 2, f % 2 == 1}));
  const Patch volume = coons(faces);
  for (int f = 0; f < 6; ++f)
    for (int i = 0; i < 5; ++i) {
      const Patch& expected = faces[f];
      const VectorX xi = random_parameter(random, expected);
      EXPECT_LT((evaluate(face(volume, {f / 2, f % 2 == 1}), xi) - evaluate(expected, xi)).norm(), 1e-13);
    }
}

TEST(Coons, RejectsBoundariesThatDoNotMeet) {
  const Patch west = line(Vec<2>(0, 0), Vec<2>(0, 1)), east = line(Vec<2>(1, 0), Vec<2>(1, 1));
  const Patch south = line(Vec<2>(0, 0), Vec<2>(1, 0)), north = line(Vec<2>(0, 1), Vec<2>(1, 1));
  EXPECT_NO_THROW(coons({west, east, south, north}));
  EXPECT_ERROR(coons({west, east, south}), "nurbs.coons.count: count = 3");
  EXPECT_ERROR(coons({west, east, south, line(Vec<2>(1, 1), Vec<2>(0, 1))}),
               "nurbs.coons.apart: first = west, second = north, at = (0, 1), other = (1, 1)");
  EXPECT_ERROR(coons({west, east, south, line(Vec<2>(0, 1), Vec<2>(1, 1 + 1e-8))}),
               "nurbs.coons.apart: first = east, second = north, at = (1, 1), other = (1, 1)");
  EXPECT_ERROR(coons({west, east, south, line(Vec<3>(0, 1, 0), Vec<3>(1, 1, 0))}),
               "nurbs.coons.dimension: face = north, dimension = 3, expected = 2");
  const Patch heavy = make_patch({KnotVector::single(1)}, south.points(), Vec<2>(1, 2));
  EXPECT_ERROR(coons({west, east, heavy, north}),
               "nurbs.coons.weights: first = east, second = south, at = (1, 0), one = 1, other = 2");
  const Patch surface = ruled(west, east);
  EXPECT_ERROR(coons({west, surface, south, north}),
               "nurbs.coons.directions: face = east, directions = 2, expected = 1, count = 4");
}

} // namespace constructions_test
} // namespace signorini::nurbs
