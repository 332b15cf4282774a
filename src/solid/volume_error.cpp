#include "solid/volume_error.hpp"

#include "solid/body.hpp"

#include <cmath>

namespace signorini::solid {

namespace {

/// ∫ det ∂X/∂ξ dξ over element e.
double volume(const nurbs::Discretization& space, const MatrixX& points, int e, const ElementQuadrature& rule) {
  double sum = 0;
  for (Eigen::Index q = 0; q < rule.points.cols(); ++q) {
    const nurbs::ElementBasis basis = space.basis(e, rule.points.col(q));
    MatrixX jacobian = MatrixX::Zero(points.rows(), points.rows());
    for (std::size_t a = 0; a < basis.functions.size(); ++a)
      jacobian += points.col(basis.functions[a]) * basis.gradients.col(static_cast<Eigen::Index>(a)).transpose();
    sum += rule.weights(q) * jacobian.determinant();
  }
  return sum;
}

} // namespace

double weight_ratio(const nurbs::Discretization& space) {
  const auto weights = space.homogeneous().bottomRows(1);
  return weights.maxCoeff() / weights.minCoeff();
}

double volume_error(const nurbs::Discretization& space) {
  const MatrixX points = space.points();
  double usual = 0, fine = 0;
  for (int e = 0; e < space.elements(); ++e) {
    usual += volume(space, points, e, element_quadrature(space, e));
    fine += volume(space, points, e, element_quadrature(space, e, 2));
  }
  return std::abs(usual / fine - 1);
}

} // namespace signorini::solid
