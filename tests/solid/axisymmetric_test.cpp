// Bodies of revolution: exact homogeneous states, volumes, limits and errors at the axis.
#include "solid/bodies.hpp"
#include "solid/internal.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace signorini::solid {
namespace axisymmetric_test {

using namespace test;
using std::numbers::pi;

const NeoHookean rubber = neo_hookean(2, 0.3);
const LinearElastic steel = linear_elastic(2, 0.3);

double volume(const Body<2>& body) {
  double sum = 0;
  for (int e = 0; e < body.elements(); ++e)
    for (int q = 0; q < body.tables().element(e).points; ++q) sum += body.tables().weights_of(e)[q];
  return sum;
}

Body<2> bowl(const Material& material) {
  return *revolved(
      make_body<2>(nurbs::quarter_annulus(0.3, 0.6, Eigen::Vector2d(0, 0), 270), {8, 2}, "N2", "south", material));
}

Body<2> disc(const Material& material) {
  return *revolved(
      make_body<2>(nurbs::rectangle(1.5, 0.5, Eigen::Vector2d(0, -1)), {3, 3}, "N2-N2.1", "south", material, 2));
}

TEST(Axisymmetric, VolumesAreThoseOfTheFullCircle) {
  EXPECT_NEAR(volume(disc(rubber)), pi * 1.5 * 1.5 * 0.5, 1e-13);
  EXPECT_NEAR(volume(bowl(steel)), 2 * pi / 3 * (std::pow(0.6, 3) - std::pow(0.3, 3)), 1e-9);
}

TEST(Axisymmetric, RevolvedBodySharesSpaceAndMaterial) {
  const Body<2> plane = make_body<2>(nurbs::rectangle(1, 1, Eigen::Vector2d(0, 0)), {2, 2}, "N2", "south", steel);
  const auto twin = revolved(plane);
  EXPECT_EQ(twin->shared_space(), plane.shared_space());
  EXPECT_EQ(twin->kind(), Kind::axisymmetric);
  EXPECT_EQ(plane.kind(), Kind::plane_strain);
  EXPECT_TRUE(twin->linear());
  EXPECT_EQ(twin->material().constants().youngs_modulus, 2);
}

/// u = ((a−1) r, (b−1) z) gives uniform strain, F = diag(a, b, a): the energy is W(F) V, and the nodal forces do the
/// work of the exact stress, Σ_A f_rA R_A = (P_rr + P_θθ) V, Σ_A f_zA Z_A = P_zz V.
void homogeneous_state(const Body<2>& body, double a, double b) {
  Mat<2> plane;
  plane << a, 0, 0, b;
  const Mat<3> f = Vec<3>(a, b, a).asDiagonal();
  const VectorX u = affine<2>(body, plane);
  const Assembled at = assemble(body, u);
  ASSERT_FALSE(at.inversion);
  const double v = volume(body);
  EXPECT_NEAR(stored_energy(body, u.data()), body.material().energy(f) * v, 1e-13 * v);
  const Mat<3> p = body.material().stress(f);
  const MatrixX points = body.space().points();
  double radial = 0, axial = 0, lift = 0;
  for (int c = 0; c < body.functions(); ++c) {
    radial += at.force(2 * c) * points(0, c);
    axial += at.force(2 * c + 1) * points(1, c);
    lift += at.force(2 * c + 1);
  }
  EXPECT_NEAR(radial, (p(0, 0) + p(2, 2)) * v, 1e-13 * v);
  EXPECT_NEAR(axial, p(1, 1) * v, 1e-13 * v);
  EXPECT_NEAR(lift, 0, 1e-13 * v);
}

TEST(Axisymmetric, UniformStretchHasTheExactStress) {
  Random random(9);
  for (const Material& material : {Material(rubber), Material(steel)})
    for (int trial = 0; trial < 5; ++trial) {
      const double a = uniform(random, 0.6, 1.6), b = uniform(random, 0.6, 1.6);
      homogeneous_state(disc(material), a, b);
      homogeneous_state(bowl(material), a, b);
    }
}

/// Under a uniform stretch the inner control points are in equilibrium: a homogeneous stress needs no body force, as
/// P_rr = P_θθ. The rectangle's quadrature is exact.
TEST(Axisymmetric, UniformStretchLeavesInnerPointsInEquilibrium) {
  Mat<2> plane;
  plane << 1.3, 0, 0, 0.8;
  for (const Material& material : {Material(rubber), Material(steel)}) {
    const Body<2> body = disc(material);
    const VectorX force = assemble(body, affine<2>(body, plane)).force;
    std::vector<bool> loaded(static_cast<std::size_t>(body.functions()), false);
    for (const char* face : {"east", "south", "north"})
      for (int a : body.space().face_functions(nurbs::side_of(face, 2))) loaded[a] = true;
    int inside = 0;
    for (int a = 0; a < body.functions(); ++a) {
      if (loaded[a]) continue;
      EXPECT_LT(force.segment<2>(2 * a).norm(), 1e-13 * force.norm());
      ++inside;
    }
    EXPECT_GT(inside, 0);
  }
}

TEST(Axisymmetric, TranslationAlongTheAxisNeedsNoForce) {
  Random random(10);
  for (const Body<2>& body : {bowl(rubber), bowl(steel), disc(rubber), disc(steel)}) {
    const VectorX u = random_displacement(random, body, 0.01);
    VectorX shifted = u;
    for (int a = 0; a < body.functions(); ++a) shifted(2 * a + 1) += 0.7;
    const VectorX force = assemble(body, u).force;
    EXPECT_LT((assemble(body, shifted).force - force).norm(), 1e-12 * force.norm());
  }
}

/// A ring of radius R far from the axis is a plane body of length 2πR: the difference decreases as 1/R.
TEST(Axisymmetric, FarFromTheAxisAgreesWithPlaneStrain) {
  Random random(11);
  for (const Material& material : {Material(rubber), Material(steel)}) {
    double last = 1;
    for (double radius : {1e2, 1e4, 1e6}) {
      const Body<2> plane =
          make_body<2>(nurbs::rectangle(1, 1, Eigen::Vector2d(radius, 0)), {2, 2}, "N2", "south", material);
      Random same = random;
      const VectorX u = random_displacement(same, plane, 0.05);
      const VectorX expected = 2 * pi * radius * assemble(plane, u).force;
      const double difference = (assemble(*revolved(plane), u).force - expected).norm() / expected.norm();
      EXPECT_LT(difference, 2 / radius);
      EXPECT_LT(difference, 0.02 * last);
      last = difference;
    }
  }
}

TEST(Axisymmetric, InversionIsReportedInThePlaneAndAtTheAxis) {
  const Body<2> tube =
      *revolved(make_body<2>(nurbs::rectangle(1, 1, Eigen::Vector2d(0.5, 0)), {3, 1}, "N1", "south", rubber));
  VectorX u = VectorX::Zero(2 * tube.functions());
  for (int a = 0; a < tube.functions(); ++a) u(2 * a) = -1;
  const Assembled crossed = assemble(tube, u);
  ASSERT_TRUE(crossed.inversion);
  EXPECT_EQ(crossed.inversion->element, 0);
  EXPECT_LT(crossed.inversion->point(0), 1);
  // r/R of a point displaced from R to R − 1
  EXPECT_NEAR(crossed.inversion->jacobian, 1 - 1 / crossed.inversion->point(0), 1e-14);
  EXPECT_EQ(stored_energy(tube, u.data()), std::numeric_limits<double>::infinity());

  u.setZero();
  for (int a : tube.space().face_functions(nurbs::side_of("east", 2))) u(2 * a) = -0.5;
  const Assembled folded = assemble(tube, u);
  ASSERT_TRUE(folded.inversion);
  EXPECT_EQ(folded.inversion->element, 2);
  EXPECT_NEAR(folded.inversion->jacobian, -0.5, 1e-14);
  u(0) = std::numeric_limits<double>::quiet_NaN();
  ASSERT_TRUE(assemble(tube, u).inversion);
}

TEST(Axisymmetric, BodyBeyondTheAxisIsAnError) {
  // In the second case all Gauss points still have a positive radius.
  for (double left : {-2.0, -0.01}) {
    const Body<2> plane = make_body<2>(nurbs::rectangle(1, 1, Eigen::Vector2d(left, 0)), {1, 1}, "N2", "south", steel);
    EXPECT_ERROR(revolved(plane), "solid.body.beyond_axis");
    EXPECT_ERROR(revolved(plane), "solid.body.beyond_axis");
  }
  const nurbs::Patch block = nurbs::block({1, 1, 1}, Eigen::Vector3d(0, 0, 0));
  const Body<3> cube = make_body<3>(block, {1, 1, 1}, "N2", "back", steel);
  EXPECT_ERROR(Body<3>(cube.shared_space(), steel, Kind::axisymmetric), "solid.body.axisymmetric: dimension = 3");
}

} // namespace axisymmetric_test
} // namespace signorini::solid
