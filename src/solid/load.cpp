#include "solid/load.hpp"

#include "base/error.hpp"
#include "solid/quadrature.hpp"

#include <numbers>

namespace signorini::solid {

namespace {

/// Gauss points of all knot spans, twice as many as the bulk has: faces are curved and rational, so that no rule is
/// exact, and loads are integrated once.
QuadratureRule along(const nurbs::KnotVector& knots) {
  QuadratureRule all;
  for (std::size_t e = 0; e + 1 < knots.breaks().size(); ++e) {
    const QuadratureRule rule = gauss_legendre(2 * (knots.degree() + 1), knots.breaks()[e], knots.breaks()[e + 1]);
    all.points.insert(all.points.end(), rule.points.begin(), rule.points.end());
    all.weights.insert(all.weights.end(), rule.weights.begin(), rule.weights.end());
  }
  return all;
}

/// A face's outward normal times the surface measure.
template <int D> Vec<D> outward(const std::vector<nurbs::Derivative>& face, nurbs::Side side) {
  Vec<D> normal;
  if constexpr (D == 2)
    normal << face[1].value(1), -face[1].value(0);
  else
    normal = Vec<3>(face[1].value).cross(Vec<3>(face[2].value));
  return nurbs::outward_sign(side) * normal;
}

/// ∫ R_A t dξ over a face; `force` gives the load t from the normal times the surface measure.
template <int D, class Force> VectorX integrate(const Body<D>& body, nurbs::Side side, const Force& force) {
  const nurbs::Patch face = body.space().face_patch(side);
  const std::vector<int> functions = body.space().face_functions(side);
  const QuadratureRule first = along(face.direction(0));
  const QuadratureRule second = D == 3 ? along(face.directions().back()) : QuadratureRule{{0}, {1}};
  VectorX load = VectorX::Zero(D * body.functions()), xi(D - 1);
  for (std::size_t j = 0; j < second.points.size(); ++j)
    for (std::size_t i = 0; i < first.points.size(); ++i) {
      xi(D - 2) = second.points[j];
      xi(0) = first.points[i];
      const std::vector<nurbs::Derivative> point = nurbs::derivatives(face, xi, 1);
      double weight = first.weights[i] * second.weights[j];
      if (body.kind() == Kind::axisymmetric) weight *= 2 * std::numbers::pi * point[0].value(0);
      const Vec<D> density = weight * force(outward<D>(point, side));
      for (const nurbs::BasisValue& basis : nurbs::rational_basis(face, xi)) {
        const int function = functions[static_cast<std::size_t>(basis.function)];
        load.template segment<D>(D * function) += basis.value * density;
      }
    }
  return load;
}

} // namespace

template <int D> VectorX traction_load(const Body<D>& body, nurbs::Side side, int component) {
  require(component >= 0 && component < D, "traction: component ", component, " is not one of 0 … ", D - 1);
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
