// Curves, surfaces and solids in space made by extrusion, revolution, ruling and blending, in random cases.
#include "nurbs/constructions.hpp"

#include "measure.hpp"
#include "nurbs/refine.hpp"
#include "nurbs/shapes.hpp"
#include "random_patch.hpp"

#include <gtest/gtest.h>

namespace signorini::nurbs {
namespace solids_test {

using namespace test;
using std::numbers::pi;

VectorX with(const VectorX& xi, double last) {
  VectorX result(xi.size() + 1);
  result << xi, last;
  return result;
}

TEST(SolidConstructions, ExtrudedPointsAreAlongTheVector) {
  Random random(71);
  for (int run = 0; run < 40; ++run) {
    const int dimension = 2 + run % 2;
    const Patch patch = random_patch(random, 1 + run / 2 % 2, dimension, 3);
    const Vec<3> along = Vec<3>::NullaryExpr([&] { return uniform(random, -2, 2); });
    const Patch swept = extrude(patch, along);
    ASSERT_EQ(swept.parametric_dimension(), patch.parametric_dimension() + 1);
    const VectorX xi = random_parameter(random, patch);
    Vec<3> start = Vec<3>::Zero();
    start.head(dimension) = evaluate(patch, xi);
    for (double t : {0.0, 0.3, 1.0}) EXPECT_LT((evaluate(swept, with(xi, t)) - (start + t * along)).norm(), 1e-13);
  }
}

TEST(SolidConstructions, RuledPointsAreBetweenBothEnds) {
  Random random(72);
  for (int run = 0; run < 40; ++run) {
    // Both with different degrees, knots and weights, on one interval
    const int parametric = 1 + run % 2;
    const Patch a = random_patch(random, parametric, 3, 3), b = random_patch(random, parametric, 3, 3);
    const Patch between = ruled(a, b);
    const VectorX xi = random_parameter(random, a);
    const Vec<3> from = evaluate(a, xi), to = evaluate(b, xi);
    EXPECT_LT((evaluate(between, with(xi, 0)) - from).norm(), 1e-13);
    EXPECT_LT((evaluate(between, with(xi, 1)) - to).norm(), 1e-13);
    // On the segment, and monotonic in the parameter
    double before = 0;
    for (double t : {0.2, 0.5, 0.9}) {
      const Vec<3> arm = Vec<3>(evaluate(between, with(xi, t))) - from, whole = to - from;
      const double share = arm.dot(whole) / whole.squaredNorm();
      EXPECT_LT((arm - share * whole).norm(), 1e-13);
      EXPECT_GT(share, before);
      EXPECT_LT(share, 1);
      before = share;
    }
  }
}

/// A rectangle of random size in the half plane x > 0 of x and z, with slightly moved corners.
Patch random_profile(Random& random) {
  const double x = uniform(random, 0.5, 2), z = uniform(random, -1, 1);
  const double a = uniform(random, 0.5, 1.5), b = uniform(random, 0.5, 1.5);
  MatrixX points(3, 4);
  points << x, x + a, x, x + a, 0, 0, 0, 0, z, z, z + b, z + b;
  for (int n = 0; n < 4; ++n) {
    points(0, n) += uniform(random, -0.1, 0.1);
    points(2, n) += uniform(random, -0.1, 0.1);
  }
  return make_patch({KnotVector::single(1), KnotVector::single(1)}, points);
}

TEST(SolidConstructions, RevolvedSolidsHaveTheVolumeOfPappus) {
  Random random(73);
  for (int run = 0; run < 20; ++run) {
    const Patch profile = random_profile(random);
    const double angle = (run % 2 == 0 ? 1 : -1) * uniform(random, 20, 360);
    const Patch solid = revolve(profile, Vec<3>(0, 0, 0), Vec<3>(0, 0, 1), angle);
    const Measure flat = measure(profile, 8), full = measure(solid, 8);
    // ξ¹ outwards, ξ² up, ξ³ around: right-handed for a rotation from x towards −y
    EXPECT_NEAR(full.content, -angle * pi / 180 * flat.centroid(0) * flat.content, 1e-10);
    EXPECT_EQ(full.least > 0, angle < 0);
    // Revolution about a skew axis gives the same solid, moved.
    const Vec<3> point = Vec<3>::Random(), axis = Vec<3>(1, 2, 3).normalized();
    const Mat<3> tilt =
        Eigen::AngleAxisd(std::acos(axis(2)), Vec<3>(0, 0, 1).cross(axis).normalized()).toRotationMatrix();
    const Patch tilted = revolve(transform(profile, tilt, point), point, axis, angle);
    EXPECT_LT((tilted.points() - transform(solid, tilt, point).points()).cwiseAbs().maxCoeff(), 1e-13);
  }
}

TEST(SolidConstructions, ProfileAcrossItsAxisIsInverted) {
  const MatrixX upright = (MatrixX(3, 2) << 1, 0, 0, 0, 0, 1).finished();
  const Patch across = transform(extrude(line(Vec<2>(-1, 0), Vec<2>(2, 0)), Vec<2>(0, 1)), upright, Vec<3>::Zero());
  EXPECT_LT(measure(revolve(across, Vec<3>(0, 0, 0), Vec<3>(0, 0, 1), -90), 4).least, 0);
}

TEST(SolidConstructions, CoonsVolumesReproduceTheFacesOfAnySolid) {
  Random random(74);
  for (int run = 0; run < 20; ++run) {
    // Faces of one solid always meet. Their weights are similar enough for a blend.
    const Patch wild = random_patch(random, 3, 3, 2);
    const Patch solid = make_patch(wild.directions(), wild.points(), wild.weights().array().pow(0.25));
    std::vector<Patch> faces;
    for (int f = 0; f < 6; ++f) faces.push_back(face(solid, {f / 2, f % 2 == 1}));
    const Patch volume = coons(faces);
    for (int f = 0; f < 6; ++f) {
      const Patch& expected = faces[f];
      const VectorX xi = random_parameter(random, expected);
      EXPECT_LT((evaluate(face(volume, {f / 2, f % 2 == 1}), xi) - evaluate(expected, xi)).norm(), 1e-12);
    }
  }
}

TEST(SolidConstructions, WeightsWithoutAPositiveBlendAreRejected) {
  // Middle control points of weight 0.01 on all faces: the boolean sum subtracts the edges' weights, 1, which are
  // larger.
  const KnotVector two = KnotVector::single(2);
  const Patch solid = elevate(elevate(elevate(block({1, 1, 1}, Vec<3>(0, 0, 0)), 0, 1), 1, 1), 2, 1);
  VectorX weights = VectorX::Ones(27);
  for (int n : {4, 10, 12, 14, 16, 22}) weights(n) = 0.01;
  const Patch heavy = make_patch({two, two, two}, solid.points(), weights);
  std::vector<Patch> faces;
  for (int f = 0; f < 6; ++f) faces.push_back(face(heavy, {f / 2, f % 2 == 1}));
  EXPECT_ERROR(coons(faces), "nurbs.coons.blend: weight = -1.97");
}

} // namespace solids_test
} // namespace signorini::nurbs
