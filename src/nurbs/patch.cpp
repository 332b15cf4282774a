#include "nurbs/patch.hpp"

#include "base/error.hpp"

#include <cmath>

namespace signorini::nurbs {

template <class Direction>
TensorProduct<Direction>::TensorProduct(std::vector<Direction> directions, MatrixX homogeneous)
    : directions_(std::move(directions)), homogeneous_(std::move(homogeneous)) {
  require(parametric_dimension() >= 1 && parametric_dimension() <= 3,
          "patch: it has 1 to 3 parametric directions, got ", parametric_dimension());
  require(dimension() == 2 || dimension() == 3, "points: a point has 2 or 3 coordinates, got ", dimension());
  require(parametric_dimension() <= dimension(), "patch: ", parametric_dimension(),
          " parametric directions do not fit into space of dimension ", dimension(), "; give the points ",
          parametric_dimension(), " coordinates");
  long expected = 1;
  std::string product;
  for (const Direction& space : directions_) {
    require(space.degree() >= 1, "degree: a patch is of degree 1 or higher in every direction");
    product += (product.empty() ? "" : "·") + std::to_string(space.functions());
    expected *= space.functions();
  }
  require(homogeneous_.cols() == expected, "points: the degrees and knots ask for ", product,
          directions_.size() > 1 ? text(" = ", expected) : "", " control points, got ", homogeneous_.cols());
  for (int a = 0; a < functions(); ++a) {
    const double weight = homogeneous_(dimension(), a);
    require(weight > 0 && std::isfinite(weight), "weights: weight ", a + 1, " is ", weight,
            ", expected a positive number");
    require(homogeneous_.col(a).allFinite(), "points: control point ", a + 1, " has a coordinate that is not finite");
  }
}

template <class Direction> int TensorProduct<Direction>::stride(int d) const {
  int product = 1;
  for (int k = 0; k < d; ++k) product *= direction(k).functions();
  return product;
}

template <class Direction> MatrixX TensorProduct<Direction>::points() const {
  return homogeneous_.topRows(dimension()).array().rowwise() / homogeneous_.row(dimension()).array();
}

template <class Direction> VectorX TensorProduct<Direction>::weights() const {
  return homogeneous_.row(dimension()).transpose();
}

template class TensorProduct<KnotVector>;
template class TensorProduct<Space1D>;

Row make_row(const Patch& patch) {
  std::vector<Space1D> directions;
  for (const KnotVector& knots : patch.directions()) directions.push_back(spline_space(knots));
  return {std::move(directions), patch.homogeneous()};
}

Patch make_patch(std::vector<KnotVector> directions, const MatrixX& points, const VectorX& weights) {
  require(weights.size() == 0 || weights.size() == points.cols(), "weights: ", points.cols(),
          " control points need as many weights, got ", weights.size());
  MatrixX homogeneous(points.rows() + 1, points.cols());
  homogeneous.topRows(points.rows()) = points;
  homogeneous.bottomRows(1).setOnes();
  if (weights.size() > 0) homogeneous *= weights.asDiagonal();
  return {std::move(directions), std::move(homogeneous)};
}

} // namespace signorini::nurbs
