// The Bézier form of elements compared with the functions, for uniform and layered spaces.
#include "nurbs/bezier_element.hpp"

#include "nurbs/bezier.hpp"
#include "nurbs/shapes.hpp"

#include <gtest/gtest.h>

namespace signorini::nurbs {
namespace bezier_element_test {

/// Bernstein polynomials of a tensor product at t ∈ [0, 1]^d, the first direction's index fastest.
VectorX bernstein_at(const std::vector<int>& degrees, const VectorX& t) {
  VectorX result = VectorX::Ones(1);
  for (std::size_t d = 0; d < degrees.size(); ++d) {
    VectorX one(degrees[d] + 1);
    bernstein(degrees[d], t(static_cast<Eigen::Index>(d)), 1, 0, one.data());
    const VectorX before = result;
    result.resize(before.size() * one.size());
    for (Eigen::Index k = 0; k < one.size(); ++k) result.segment(k * before.size(), before.size()) = one(k) * before;
  }
  return result;
}

/// Compares the rational functions of every element, evaluated from its Bézier form, with those of the space.
void expect_same_functions(const Discretization& space) {
  const int dimensions = space.parametric_dimension();
  for (int e = 0; e < space.elements(); ++e) {
    const BezierElement element = bezier_element(space, e);
    const VectorX weights = space.homogeneous().row(space.dimension())(element.functions);
    for (int sample = 0; sample < 5; ++sample) {
      VectorX t(dimensions), xi(dimensions);
      for (int d = 0; d < dimensions; ++d) {
        t(d) = std::fmod(0.37 * (sample + 1) * (d + 2), 1.0);
        const auto [from, to] = space.interval(e, d);
        xi(d) = from + (to - from) * t(d);
      }
      VectorX values = weights.cwiseProduct(element.extraction * bernstein_at(element.degrees, t));
      values /= values.sum();
      VectorX all = VectorX::Zero(space.functions()), expected = all;
      for (std::size_t a = 0; a < element.functions.size(); ++a)
        all(element.functions[a]) += values(static_cast<Eigen::Index>(a));
      const ElementBasis basis = space.basis(e, xi);
      for (std::size_t a = 0; a < basis.functions.size(); ++a)
        expected(basis.functions[a]) = basis.values(static_cast<Eigen::Index>(a));
      EXPECT_LT((all - expected).cwiseAbs().maxCoeff(), 1e-14) << "element " << e;
    }
  }
}

Discretization space(const Patch& patch, std::vector<int> elements, std::vector<std::string> labels, Side contact) {
  Plan plan{std::move(elements), {}, {}, {contact}, 1};
  for (const std::string& label : labels) plan.labels.push_back(parse_label(label));
  return {patch, plan};
}

TEST(BezierElement, PlaneBodies) {
  const Patch ring = half_annulus(0.3, 0.5, Vec<2>(0.75, 1.5));
  for (const char* label : {"N2", "N4", "L2", "N2.1", "N2-N4", "N2-N2.2", "N2-N3x2"})
    expect_same_functions(space(ring, {6, 3}, {label}, {1, false}));
  EXPECT_EQ(bezier_element(space(ring, {6, 3}, {"N2-N2.2"}, {1, false}), 0).degrees, (std::vector{4, 1}));
  EXPECT_EQ(bezier_element(space(ring, {6, 3}, {"N2-N2.2"}, {1, false}), 6).degrees, (std::vector{2, 1}));
}

TEST(BezierElement, Solids) {
  const Patch cuboid = block({1, 2, 3}, Vec<3>::Zero());
  expect_same_functions(space(cuboid, {3, 2, 2}, {"N2-N2.2", "N3"}, {2, true}));
  expect_same_functions(space(cuboid, {2, 3, 2}, {"N2", "N2-N3"}, {0, false}));
  expect_same_functions(space(cuboid, {2, 3, 2}, {"N2-N4", "N2"}, {1, true}));
}

TEST(BezierElement, ElevationPreservesPolynomials) {
  for (double t : {0.0, 0.3, 0.9}) {
    const VectorX low = bernstein_at({2}, VectorX::Constant(1, t)), high = bernstein_at({5}, VectorX::Constant(1, t));
    EXPECT_LT((bernstein_elevation(2, 5) * high - low).norm(), 1e-15);
  }
}

} // namespace bezier_element_test
} // namespace signorini::nurbs
