#include "solid/quadrature_error.hpp"

#include "solid/face_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini::solid {

namespace {

/// Ratio of dA/dξ within an element up to which the points of loads are exact enough without a look.
constexpr double smooth = 4;

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

/// True if dA/dξ differs much within an element.
template <int D> bool varies(const Body<D>& body, nurbs::Side face) {
  const MatrixX points = body.space().points();
  for (const FacePoints<D>& part : face_points(body, face, 1)) {
    const MatrixX x = points(Eigen::all, part.functions);
    double least = std::numeric_limits<double>::infinity(), most = 0;
    for (int q = 0; q < part.weights.size(); ++q) {
      const double density = part.area_vector(x, q).norm();
      least = std::min(least, density);
      most = std::max(most, density);
    }
    if (most > smooth * least) return true;
  }
  return false;
}

template <int D> double area(const Body<D>& body, nurbs::Side face, int times) {
  const MatrixX points = body.space().points();
  double sum = 0;
  for (const FacePoints<D>& part : face_points(body, face, times)) {
    const MatrixX x = points(Eigen::all, part.functions);
    for (int q = 0; q < part.weights.size(); ++q) sum += part.weight(x, q) * part.area_vector(x, q).norm();
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

template <int D> double area_error(const Body<D>& body, const std::vector<nurbs::Side>& faces) {
  if (std::ranges::none_of(faces, [&](nurbs::Side face) { return varies(body, face); })) return 0;
  double usual = 0, fine = 0;
  for (const nurbs::Side face : faces) {
    usual += area(body, face, 2);
    fine += area(body, face, 4);
  }
  return std::abs(usual / fine - 1);
}

template double area_error(const Body<2>&, const std::vector<nurbs::Side>&);
template double area_error(const Body<3>&, const std::vector<nurbs::Side>&);

} // namespace signorini::solid
