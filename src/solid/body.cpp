#include "solid/body.hpp"

#include "base/error.hpp"
#include "solid/quadrature.hpp"

#include <algorithm>

namespace signorini::solid {

ElementQuadrature element_quadrature(const nurbs::Discretisation& space, int e) {
  const int dimensions = space.parametric_dimension();
  std::vector<QuadratureRule> rules;
  int size = 1;
  for (int d = 0; d < dimensions; ++d) {
    const auto [a, b] = space.interval(e, d);
    rules.push_back(gauss_legendre(space.degree(e, d) + 1, a, b));
    size *= static_cast<int>(rules.back().points.size());
  }
  ElementQuadrature result{MatrixX(dimensions, size), VectorX::Ones(size)};
  for (int q = 0; q < size; ++q)
    for (int d = 0, rest = q; d < dimensions; ++d) {
      const QuadratureRule& rule = rules[static_cast<std::size_t>(d)];
      const std::size_t count = rule.points.size(), i = static_cast<std::size_t>(rest) % count;
      result.points(d, q) = rule.points[i];
      result.weights(q) *= rule.weights[i];
      rest /= static_cast<int>(count);
    }
  return result;
}

template <int D>
Body<D>::Body(nurbs::Discretisation space, NeoHookean material) : space_(std::move(space)), material_(material) {
  require(space_.dimension() == D, "a body of dimension ", D, " was given a patch of dimension ", space_.dimension());
  const MatrixX points = space_.points();
  for (int e = 0; e < space_.elements(); ++e) {
    const ElementQuadrature rule = element_quadrature(space_, e);
    ElementTable table{0,
                       static_cast<int>(rule.weights.size()),
                       functions_.size(),
                       weights_.size(),
                       gradients_.size(),
                       constants_.size(),
                       nullptr};
    MatrixX constant;
    for (int q = 0; q < table.points; ++q) {
      const nurbs::ElementBasis basis = space_.basis(e, rule.points.col(q));
      if (q == 0) {
        table.functions = static_cast<int>(basis.functions.size());
        functions_.insert(functions_.end(), basis.functions.begin(), basis.functions.end());
        table.kernel = element_kernel<D>(table.functions);
        constant = MatrixX::Zero(table.functions, table.functions);
      }
      // ∂X/∂ξ = Σ_A X_A ⊗ ∂R_A/∂ξ,  ∂R/∂X = ∂R/∂ξ (∂X/∂ξ)⁻¹
      Mat<D> jacobian = Mat<D>::Zero();
      VectorX place = VectorX::Zero(D);
      for (int a = 0; a < table.functions; ++a) {
        const int function = basis.functions[static_cast<std::size_t>(a)];
        jacobian += points.col(function) * basis.gradients.col(a).transpose();
        place += points.col(function) * basis.values(a);
      }
      const double determinant = jacobian.determinant();
      require(determinant > 0, "patch: the map is not right-handed (Jacobian ", determinant, ") near (",
              place.transpose(), "); reverse one parametric direction, or untangle the control points");
      const double weight = rule.weights(q) * determinant;
      const MatrixX gradients = jacobian.inverse().transpose() * basis.gradients;
      weights_.push_back(weight);
      for (int k = 0; k < D; ++k)
        for (int a = 0; a < table.functions; ++a) gradients_.push_back(gradients(k, a));
      constant += weight * material_.mu * gradients.transpose() * gradients;
    }
    constants_.insert(constants_.end(), constant.data(), constant.data() + constant.size());
    most_functions_ = std::max(most_functions_, table.functions);
    most_points_ = std::max(most_points_, table.points);
    elements_.push_back(table);
  }
}

template <int D> VectorX Body<D>::reference_point(int e, int q) const {
  const nurbs::ElementBasis basis = space_.basis(e, element_quadrature(space_, e).points.col(q));
  const MatrixX points = space_.points();
  VectorX place = VectorX::Zero(D);
  for (std::size_t a = 0; a < basis.functions.size(); ++a)
    place += points.col(basis.functions[a]) * basis.values(static_cast<int>(a));
  return place;
}

template class Body<2>;
template class Body<3>;

} // namespace signorini::solid
