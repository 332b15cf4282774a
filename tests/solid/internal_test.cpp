// Internal force compared with the derivative of the stored energy, tangent with that of the force, and results that do
// not depend on the discretization: homogeneous states, rigid motions, inversion.
#include "solid/internal.hpp"

#include "solid/many_bodies.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace signorini::solid {
namespace internal_test {

using namespace test;

const NeoHookean rubber = neo_hookean(2, 0.3);
const LinearElastic steel = linear_elastic(2, 0.3);

TEST(Internal, ForceAndTangentAreDerivativesInThePlane) {
  force_and_tangent_are_derivatives(plane_bodies(rubber));
  force_and_tangent_are_derivatives(plane_bodies(neo_hookean(5, 0.45)));
}
TEST(Internal, ForceAndTangentAreDerivativesInSpace) {
  force_and_tangent_are_derivatives(space_bodies(neo_hookean(5, 0.45)));
}
TEST(Internal, ForceAndTangentAreDerivativesOfBodiesOfRevolution) {
  force_and_tangent_are_derivatives(bodies_of_revolution(rubber));
  force_and_tangent_are_derivatives(bodies_of_revolution(neo_hookean(5, 0.45)));
}
TEST(Internal, ForceAndTangentAreDerivativesAtSmallStrains) {
  force_and_tangent_are_derivatives(plane_bodies(steel));
  force_and_tangent_are_derivatives(space_bodies(steel));
  force_and_tangent_are_derivatives(bodies_of_revolution(steel));
}

/// Both laws have Hooke's tangent at zero strain.
template <int D> void neo_hookean_tangent_at_rest(const std::vector<Body<D>>& rubbers) {
  for (const Body<D>& body : rubbers) {
    const Body<D> linear(body.shared_space(), linear_elastic(2, 0.3), body.kind());
    const VectorX zero = VectorX::Zero(D * body.functions());
    const Assembled of_rubber = assemble(body, zero), of_steel = assemble(linear, zero);
    EXPECT_LT((of_rubber.tangent - of_steel.tangent).norm(), 1e-14 * of_steel.tangent.norm());
    EXPECT_EQ(of_steel.force.norm(), 0);
  }
}

TEST(Internal, NeoHookeanTangentAtRestIsThatOfLinearElasticity) {
  neo_hookean_tangent_at_rest(plane_bodies(rubber));
  neo_hookean_tangent_at_rest(space_bodies(rubber));
  neo_hookean_tangent_at_rest(bodies_of_revolution(rubber));
}

TEST(Internal, SmallStrainsHaveNoInversion) {
  std::vector<Body<2>> bodies = plane_bodies(steel);
  for (const Body<2>& body : bodies_of_revolution(steel)) bodies.push_back(body);
  for (const Body<2>& body : bodies) {
    const VectorX u = affine<2>(body, Vec<2>(-1.5, 1).asDiagonal().toDenseMatrix());
    const Assembled at = assemble(body, u);
    EXPECT_FALSE(at.inversion);
    EXPECT_LT((at.force - at.tangent * u).norm(), 1e-13 * at.force.norm());
    EXPECT_TRUE(std::isfinite(stored_energy(body, u.data())));
  }
}

/// f(R(X + u) + c − X) = R f(u): rigid motion causes no force, and forces rotate with the body.
template <int D> void forces_rotate_with_the_body(const std::vector<Body<D>>& bodies, const Mat<D>& rotation) {
  Random random(5);
  for (const Body<D>& body : bodies) {
    const Vec<D> shift = Vec<D>::Constant(0.7);
    const double scale = assemble(body, VectorX::Zero(D * body.functions())).tangent.norm();
    EXPECT_LT(assemble(body, affine<D>(body, rotation, shift)).force.norm(), 1e-14 * scale);
    const VectorX u = random_displacement(random, body, 0.01);
    const VectorX force = assemble(body, u).force;
    VectorX turned = affine<D>(body, rotation, shift), expected(u.size());
    for (int a = 0; a < body.functions(); ++a) {
      turned.template segment<D>(D * a) += rotation * u.template segment<D>(D * a);
      expected.template segment<D>(D * a) = rotation * force.template segment<D>(D * a);
    }
    EXPECT_LT((assemble(body, turned).force - expected).norm(), 1e-13 * scale);
  }
}

TEST(Internal, ForcesRotateWithTheBody) {
  forces_rotate_with_the_body<2>(plane_bodies(rubber),
                                 nurbs::rotation(140, Eigen::Vector3d(0, 0, 1)).topLeftCorner<2, 2>());
  forces_rotate_with_the_body<3>(space_bodies(rubber), nurbs::rotation(140, Eigen::Vector3d(1, -2, 0.5)));
}

/// Functions that vanish on all faces.
template <int D> std::vector<int> inner_functions(const nurbs::Discretization& space) {
  std::vector<bool> outer(static_cast<std::size_t>(space.functions()), false);
  for (int d = 0; d < D; ++d)
    for (bool at_end : {false, true})
      for (int a : space.face_functions({d, at_end})) outer[a] = true;
  std::vector<int> inner;
  for (int a = 0; a < space.functions(); ++a)
    if (!outer[a]) inner.push_back(a);
  return inner;
}

/// Patch test: linear displacements give uniform strain and stress, inner forces vanish, forces and moments balance,
/// the energy is W(F) times the volume.
template <int D> void homogeneous_state(const Body<D>& body, const Mat<D>& f, double volume) {
  const VectorX u = affine<D>(body, f);
  const Assembled at = assemble(body, u);
  ASSERT_FALSE(at.inversion);
  const double scale = at.force.cwiseAbs().maxCoeff();
  const std::vector<int> inner = inner_functions<D>(body.space());
  ASSERT_FALSE(inner.empty());
  for (int a : inner) EXPECT_LT(at.force.segment<D>(D * a).norm(), 1e-13 * scale);
  EXPECT_NEAR(stored_energy(body, u.data()), body.material().energy(in_space<D>(f)) * volume, 1e-13 * volume);

  const MatrixX points = body.space().points();
  Vec<D> sum = Vec<D>::Zero();
  Mat<D> virial = Mat<D>::Zero();
  for (int a = 0; a < body.functions(); ++a) {
    sum += at.force.segment<D>(D * a);
    virial += at.force.segment<D>(D * a) * points.col(a).transpose();
  }
  // Σ_A f_A ⊗ X_A = ∫ P dV
  EXPECT_LT(sum.norm(), 1e-12 * scale);
  EXPECT_LT((virial - volume * body.material().stress(in_space<D>(f)).template topLeftCorner<D, D>()).norm(), 1e-12);
}

TEST(Internal, PatchTestInThePlane) {
  Random random(6);
  Mat<2> f;
  f << 1.2, 0.3, -0.1, 0.8;
  for (const char* label : {"N2", "N3.1", "N2-N4", "N2-N2.2", "N2-N2.1x2"}) {
    const nurbs::Patch patch = distorted(random, false);
    double area = 0;
    const Body<2> body = make_body<2>(patch, {4, 3}, label, "north", rubber);
    for (int e = 0; e < body.elements(); ++e)
      for (int q = 0; q < body.tables().element(e).points; ++q) area += body.tables().weights_of(e)[q];
    homogeneous_state<2>(body, f, area);
    homogeneous_state<2>({body.shared_space(), steel}, f, area);
  }
}

TEST(Internal, PatchTestInSpace) {
  Mat<3> f;
  f << 1.2, 0.3, 0, -0.1, 0.8, 0.2, 0.1, 0, 1.1;
  const nurbs::Patch block = nurbs::block({2, 1, 1}, Eigen::Vector3d(0, 0, 0));
  for (const Material& material : {Material(rubber), Material(steel)})
    homogeneous_state<3>(make_body<3>(block, {2, 2, 2}, "N2-N2.1", "back", material), f, 2);
}

TEST(Internal, MemoryIsThatOfTheTables) {
  // 18 functions and 18 points per element: weights, gradients, and one block of the tangent, or all six.
  const nurbs::Patch block = nurbs::block({2, 1, 1}, Eigen::Vector3d(0, 0, 0));
  const Body<3> of_rubber = make_body<3>(block, {6, 5, 4}, "N2", "back", rubber);
  const Body<3> of_steel(of_rubber.shared_space(), steel);
  const auto bytes = [](double blocks) { return 6 * 5 * 4 * 8 * (18 + 3 * 18 * 18 + blocks * 18 * 18); };
  for (const auto& [body, expected] : {std::pair(&of_rubber, bytes(1)), std::pair(&of_steel, bytes(6))}) {
    EXPECT_GT(static_cast<double>(body->memory()), expected);
    EXPECT_LT(static_cast<double>(body->memory()), 1.03 * expected); // function indices and offsets
  }
  EXPECT_GT(ElementArrays<3>(of_rubber).memory(), 8u * 6 * 18 * 18);
  EXPECT_LT(ElementArrays<3>(of_rubber).memory(), 3u * 8 * 6 * 18 * 18);
}

TEST(Internal, InvertedElementIsReported) {
  const Body<2> strip = make_body<2>(nurbs::rectangle(3, 1, Eigen::Vector2d(0, 0)), {3, 1}, "N1", "north", rubber);
  VectorX u = VectorX::Zero(2 * strip.functions());
  // The right end moves past the adjacent column of nodes: only the last element is inverted.
  for (int a : strip.space().face_functions(nurbs::side_of("east", 2))) u(2 * a) = -1.5;
  const Assembled at = assemble(strip, u);
  ASSERT_TRUE(at.inversion);
  EXPECT_EQ(at.inversion->element, 2);
  EXPECT_LE(at.inversion->jacobian, 0);
  EXPECT_GT(at.inversion->point(0), 2);
  EXPECT_LT(at.inversion->point(0), 3);
  EXPECT_EQ(stored_energy(strip, u.data()), std::numeric_limits<double>::infinity());
  u(0) = std::numeric_limits<double>::quiet_NaN();
  ASSERT_TRUE(assemble(strip, u).inversion);
  EXPECT_EQ(assemble(strip, u).inversion->element, 0);
}

TEST(Internal, LeftHandedPatchIsAnError) {
  const nurbs::Patch mirrored =
      nurbs::transform(nurbs::rectangle(3, 1, Eigen::Vector2d(0, 0)),
                       Eigen::Vector2d(-1, 1).asDiagonal().toDenseMatrix(), Eigen::Vector2d(0, 0));
  EXPECT_ERROR(make_body<2>(mirrored, {3, 1}, "N2", "north", rubber), "solid.body.left_handed");
}

} // namespace internal_test
} // namespace signorini::solid
