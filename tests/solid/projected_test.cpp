// Bodies with projected volume change: force and tangent against differences, homogeneous states, small strains as
// limit of large ones, macro-elements, and no locking.
#include "solid/many_bodies.hpp"
#include "solid/projected_volume.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace signorini::solid {
namespace projected_test {

using namespace test;

const NeoHookean rubber = neo_hookean(5, 0.49);
const LinearElastic soft = linear_elastic(5, 0.49);

template <int D> Body<D> projected(const Body<D>& body) {
  return {body.shared_space(), body.material(), body.kind(), Volumetric::projected};
}
template <int D> std::vector<Body<D>> projected(const std::vector<Body<D>>& bodies) {
  std::vector<Body<D>> result;
  for (const Body<D>& body : bodies) result.push_back(projected(body));
  return result;
}

/// Neo-Hooke without kernels of its own, with one internal variable that changes nothing.
struct WithVariable : NeoHookean {
  static constexpr auto name = "neo-Hooke with a variable";
  std::vector<double> initial_values(int) const { return {0}; }
  double energy(const Mat<3>& f, const Memory&) const { return NeoHookean::energy(f); }
  Mat<3> stress(const Mat<3>& f, const Memory& memory) const {
    memory.trial[0] = f.determinant();
    return NeoHookean::stress(f);
  }
  Moduli moduli(const Mat<3>& f, const Memory&) const { return NeoHookean::moduli(f); }
  Account account(const Mat<3>& f, std::span<const double>) const { return {NeoHookean::energy(f), 0}; }
  template <int D> static Kernels kernels(Kind kind, int) { return moduli_kernels_of<WithVariable, D>(kind); }
};

TEST(Projected, ForceAndTangentAreDerivativesInThePlane) {
  force_and_tangent_are_derivatives(projected(plane_bodies(rubber)));
  force_and_tangent_are_derivatives(projected(plane_bodies(soft)));
}
TEST(Projected, ForceAndTangentAreDerivativesInSpace) {
  force_and_tangent_are_derivatives(projected(space_bodies(rubber)));
  force_and_tangent_are_derivatives(projected(space_bodies(soft)));
}
TEST(Projected, ForceAndTangentAreDerivativesOfBodiesOfRevolution) {
  force_and_tangent_are_derivatives(projected(bodies_of_revolution(rubber)));
  force_and_tangent_are_derivatives(projected(bodies_of_revolution(soft)));
}

TEST(Projected, ElementsFormMacroElementsOfAsManyAsTheDegree) {
  const nurbs::Patch square = nurbs::rectangle(1, 1, Eigen::Vector2d(0, 0));
  const Body<2> body = projected(make_body<2>(square, {7, 2}, "N2", "north", rubber));
  // 7 elements of degree 2 along the face, 2 of degree 1 across it
  ASSERT_EQ(body.macro_elements(), 6);
  EXPECT_EQ(body.macro_elements(0), 3);
  EXPECT_EQ(body.macro_elements(1), 2);
  std::size_t elements = 0;
  for (int m = 0; m < body.macro_elements(); ++m) {
    EXPECT_EQ(body.macros().list[m].modes.cols(), 2);
    elements += body.macros().list[m].elements.size();
    for (int e : body.macros().list[m].elements) EXPECT_EQ(body.macros().containing(body.space(), e), m);
  }
  EXPECT_EQ(elements, 14u);
  EXPECT_EQ(body.macro_index(5, 0), 2);
  EXPECT_EQ(body.macro_index(5, 1), 1);
  EXPECT_EQ(body.macros().most_functions(), (3 + 2) * 2);
}

/// The macro-elements of a direction and their polynomials are symmetric about the middle, also where the degree does
/// not divide the number of elements; there is one constraint per element at most, except of fewer elements than the
/// degree.
TEST(Projected, MacroElementsAreSymmetricAboutTheMiddle) {
  for (int degree = 1; degree <= 4; ++degree)
    for (int count = 1; count <= 24; ++count) {
      const nurbs::Patch square = nurbs::rectangle(1, 1, Eigen::Vector2d(0, 0));
      const Body<2> body = projected(make_body<2>(square, {count, 1}, text("N", degree), "north", rubber));
      const int macros = body.macro_elements(0);
      int covered = 0;
      for (int m = 0; m < macros; ++m) {
        const MacroElement &own = body.macros().list[m], &mirrored = body.macros().list[macros - 1 - m];
        const int elements = std::ssize(own.elements);
        ASSERT_EQ(mirrored.elements.size(), own.elements.size()) << degree << ' ' << count;
        EXPECT_EQ(mirrored.degrees, own.degrees);
        EXPECT_EQ(own.elements.front(), covered);
        EXPECT_EQ(own.degrees[0], macros == 1 ? degree - 1 : std::min(elements, degree) - 1);
        EXPECT_LE(elements, count < degree ? count : 2 * degree);
        covered += elements;
      }
      EXPECT_EQ(covered, count);
    }
}

template <int D> void same_in_homogeneous_states(const std::vector<Body<D>>& bodies, const Mat<D>& f) {
  for (const Body<D>& body : bodies) {
    const VectorX u = affine<D>(body, f);
    const Assembled plain = assemble(body, u), at = assemble(projected(body), u);
    EXPECT_LT((plain.force - at.force).norm(), 1e-12 * plain.force.norm());
    EXPECT_NEAR(stored_energy(projected(body), u.data()), stored_energy(body, u.data()),
                1e-12 * stored_energy(body, u.data()));
  }
}
TEST(Projected, HomogeneousStatesAreThoseOfThePoints) {
  const Mat<2> plane{{1.2, 0.3}, {-0.1, 0.9}};
  const Mat<3> space{{1.2, 0.3, 0.1}, {-0.1, 0.9, 0}, {0.2, 0, 1.1}};
  same_in_homogeneous_states<2>(plane_bodies(rubber), plane);
  same_in_homogeneous_states<2>(plane_bodies(soft), plane);
  same_in_homogeneous_states<3>(space_bodies(rubber), space);
  same_in_homogeneous_states<3>(space_bodies(soft), space);
}

TEST(Projected, TangentAtRestIsThatOfSmallStrains) {
  for (const Body<2>& body : plane_bodies(rubber)) {
    const VectorX zero = VectorX::Zero(2 * body.functions());
    const Body<2> linear(body.shared_space(), soft, Kind::plane_strain, Volumetric::projected);
    const MatrixX large = assemble(projected(body), zero).tangent, small = assemble(linear, zero).tangent;
    EXPECT_LT((large - small).norm(), 1e-13 * small.norm());
  }
}

TEST(Projected, LawsWithInternalVariablesKeepThemAtTheirPoints) {
  Random random(8);
  for (const Body<2>& body : plane_bodies(WithVariable{rubber})) {
    const Body<2> own = projected(body), plain(body.shared_space(), rubber, Kind::plane_strain, Volumetric::projected);
    const VectorX u = random_displacement(random, body, 0.02);
    const std::vector<double> committed = initial_values(own);
    std::vector<double> trial(committed.size(), -1);
    const Assembled at = assemble(own, u, {committed, trial}), expected = assemble(plain, u);
    EXPECT_LT((at.force - expected.force).norm(), 1e-12 * expected.force.norm());
    EXPECT_LT((at.tangent - expected.tangent).norm(), 1e-12 * expected.tangent.norm());
    for (double determinant : trial) EXPECT_GT(determinant, 0); // of all points
  }
}

template <int D> void kept_coefficients_follow_the_displacements(const Body<D>& body) {
  Random random(3);
  ProjectedVolume<D> kept;
  for (int repeat = 0; repeat < 2; ++repeat) {
    const VectorX u = random_displacement(random, body, 0.02);
    for (int e = 0; e < body.elements(); ++e)
      for (int q : {0, body.tables().element(e).points / 2}) {
        const VectorX xi = element_quadrature(body.space(), e).points.col(q);
        const double change = ProjectedVolume<D>().change(body, e, xi, Mat<3>::Identity(), u.data());
        EXPECT_NE(change, 0);
        EXPECT_EQ(kept.change(body, e, xi, Mat<3>::Identity(), u.data()), change);
        EXPECT_NEAR(kept.change_at(body, e, q, Mat<3>::Identity(), u.data()), change, 1e-13);
      }
  }
}
TEST(Projected, KeptCoefficientsFollowTheDisplacements) {
  kept_coefficients_follow_the_displacements(projected(plane_bodies(rubber)[0]));
  kept_coefficients_follow_the_displacements(projected(bodies_of_revolution(soft)[0]));
  kept_coefficients_follow_the_displacements(projected(space_bodies(rubber)[0]));
}

TEST(Projected, InvertedElementsAreFound) {
  const Body<2> body = projected(plane_bodies(rubber)[0]);
  VectorX u = affine<2>(body, Vec<2>(-1, 1).asDiagonal().toDenseMatrix());
  EXPECT_TRUE(assemble(body, u).inversion);
  EXPECT_TRUE(std::isinf(stored_energy(body, u.data())));
}

} // namespace projected_test
} // namespace signorini::solid
