#include "nurbs/patch.hpp"

#include "base/error.hpp"

#include <cmath>

namespace signorini::nurbs {

template <class Direction>
TensorProduct<Direction>::TensorProduct(std::vector<Direction> directions, MatrixX homogeneous)
    : directions_(std::move(directions)), homogeneous_(std::move(homogeneous)) {
  require(parametric_dimension() >= 1 && parametric_dimension() <= 3, "nurbs.patch.directions",
          {{"count", parametric_dimension()}});
  require(dimension() == 2 || dimension() == 3, "nurbs.patch.coordinates", {{"count", dimension()}});
  require(parametric_dimension() <= dimension(), "nurbs.patch.dimension",
          {{"directions", parametric_dimension()}, {"dimension", dimension()}});
  long expected = 1;
  for (const Direction& space : directions_) {
    require(space.degree() >= 1, "nurbs.patch.degree");
    expected *= space.functions();
  }
  if (homogeneous_.cols() != expected) {
    std::vector<std::string> factors;
    for (const Direction& space : directions_) factors.push_back(std::to_string(space.functions()));
    fail("nurbs.patch.points", {{"expected", expected}, {"factors", factors}, {"count", homogeneous_.cols()}});
  }
  for (int a = 0; a < functions(); ++a) {
    const double weight = homogeneous_(dimension(), a);
    require(weight > 0 && std::isfinite(weight), "nurbs.patch.weight", {{"number", a}, {"weight", weight}});
    require(homogeneous_.col(a).allFinite(), "nurbs.patch.point", {{"number", a}});
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
  require(weights.size() == 0 || weights.size() == points.cols(), "nurbs.patch.weights",
          {{"points", points.cols()}, {"count", weights.size()}});
  MatrixX homogeneous(points.rows() + 1, points.cols());
  homogeneous.topRows(points.rows()) = points;
  homogeneous.bottomRows(1).setOnes();
  if (weights.size() > 0) homogeneous *= weights.asDiagonal();
  return {std::move(directions), std::move(homogeneous)};
}

} // namespace signorini::nurbs
