#include "solid/load.hpp"

#include "base/error.hpp"

#include <numbers>

namespace signorini::solid {

namespace {

/// Gauss points of an element's face on a side, twice as many per direction as in the element: faces are curved and
/// rational, so that no rule is exact, and loads are integrated only once.
ElementQuadrature border_quadrature(const nurbs::Discretization& space, int e, nurbs::Side side) {
  std::vector<QuadratureRule> rules;
  for (int d = 0; d < space.parametric_dimension(); ++d) {
    const auto [a, b] = space.interval(e, d);
    rules.push_back(d == side.direction ? QuadratureRule{{side.at_end ? b : a}, {1}}
                                        : gauss_legendre(2 * (space.degree(e, d) + 1), a, b));
  }
  return tensor_product(rules);
}

/// Outward normal of a side times the surface measure, from ∂X/∂ξ.
template <int D> Vec<D> outward(const Mat<D>& jacobian, nurbs::Side side) {
  const int first = side.direction == 0 ? 1 : 0;
  Vec<D> normal;
  if constexpr (D == 2)
    normal << jacobian(1, first), -jacobian(0, first);
  else
    normal = Vec<3>(jacobian.col(first)).cross(Vec<3>(jacobian.col(side.direction == 2 ? 1 : 2)));
  return nurbs::outward_sign(side) * normal;
}

/// ∫ R_A t dξ over a side, element by element, so that the side may cross a layer, where it is not a tensor product;
/// `force` returns the load t for the normal times the surface measure.
template <int D, class Force> VectorX integrate(const Body<D>& body, nurbs::Side side, const Force& force) {
  const nurbs::Discretization& space = body.space();
  const MatrixX points = space.points();
  VectorX load = VectorX::Zero(D * body.functions());
  for (int f = 0; f < space.elements_on(side); ++f) {
    const int e = space.element_behind(side, f);
    const ElementQuadrature rule = border_quadrature(space, e, side);
    for (int q = 0; q < rule.weights.size(); ++q) {
      const nurbs::ElementBasis basis = space.basis(e, rule.points.col(q));
      const MatrixX nodes = points(Eigen::all, basis.functions);
      double weight = rule.weights(q);
      if (body.kind() == Kind::axisymmetric) weight *= 2 * std::numbers::pi * nodes.row(0).dot(basis.values);
      const Vec<D> density = weight * force(outward<D>(nodes.lazyProduct(basis.gradients.transpose()), side));
      for (std::size_t a = 0; a < basis.functions.size(); ++a)
        load.template segment<D>(D * basis.functions[a]) += basis.values(static_cast<int>(a)) * density;
    }
  }
  return load;
}

} // namespace

template <int D> VectorX traction_load(const Body<D>& body, nurbs::Side side, int component) {
  require(component >= 0 && component < D, "solid.load.component", {{"component", component}, {"most", D - 1}});
  return integrate(body, side, [&](const Vec<D>& normal) -> Vec<D> { return normal.norm() * Vec<D>::Unit(component); });
}

template <int D> VectorX pressure_load(const Body<D>& body, nurbs::Side side) {
  return integrate(body, side, [](const Vec<D>& normal) -> Vec<D> { return -normal; });
}

template VectorX traction_load<2>(const Body<2>&, nurbs::Side, int);
template VectorX traction_load<3>(const Body<3>&, nurbs::Side, int);
template VectorX pressure_load<2>(const Body<2>&, nurbs::Side);
template VectorX pressure_load<3>(const Body<3>&, nurbs::Side);

} // namespace signorini::solid
