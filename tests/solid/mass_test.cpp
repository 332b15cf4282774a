#include "solid/mass.hpp"

#include "solid/bodies.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace signorini::solid {
namespace mass_test {

using namespace test;

/// Σ x_A m_AB y_B over all elements, of values at control points.
template <int D> double product(const Body<D>& body, const VectorX& x, const VectorX& y) {
  double sum = 0;
  for (int e = 0; e < body.elements(); ++e) {
    const std::span<const int> functions = body.tables().functions_of(e);
    const std::vector<int> own(functions.begin(), functions.end());
    sum += x(own).dot(element_mass(body, e) * y(own));
  }
  return sum;
}

TEST(Mass, OfABlockAndItsMomentOfInertia) {
  const Body<2> plane(
      make_body<2>(nurbs::rectangle(2, 1, Eigen::Vector2d(1, 0)), {3, 2}, "N2-N2.1", "south", neo_hookean(1, 0.3))
          .shared_space(),
      neo_hookean(1, 0.3), Kind::plane_strain, Volumetric::pointwise, 5);
  const VectorX ones = VectorX::Ones(plane.functions()), x = plane.space().points().row(0).transpose();
  EXPECT_NEAR(product(plane, ones, ones), 10, 1e-12);
  EXPECT_NEAR(product(plane, x, x), 5 * (27 - 1) / 3.0, 1e-11); // ∫ ρ x² dx dy
  const auto round = revolved(plane);
  EXPECT_EQ(round->density(), 5);
  EXPECT_NEAR(product(*round, ones, ones), 5 * std::numbers::pi * (9 - 1), 1e-11);
  EXPECT_EQ(in_plane_stress(plane)->density(), 5);
}

} // namespace mass_test
} // namespace signorini::solid
