#include "exchange/sampled.hpp"

#include <cmath>
#include <unsupported/Eigen/KroneckerProduct>

namespace signorini::exchange {

namespace {

/// The Bernstein polynomials of a degree at equidistant points, (degree+1) × (subdivisions+1).
MatrixX bernstein_values(int degree, int subdivisions) {
  MatrixX values(degree + 1, subdivisions + 1);
  for (int i = 0; i <= subdivisions; ++i) {
    const double t = static_cast<double>(i) / subdivisions;
    double choose = 1;
    for (int k = 0; k <= degree; ++k) {
      values(k, i) = choose * std::pow(t, k) * std::pow(1 - t, degree - k);
      choose *= static_cast<double>(degree - k) / (k + 1);
    }
  }
  return values;
}

} // namespace

BezierGrid sampled(const BezierGrid& grid, int subdivisions) {
  BezierGrid samples = grid;
  std::vector<MatrixX> tables; // per cell, normalized rational functions × points
  Eigen::Index count = 0, first = 0;
  for (std::vector<int>& degrees : samples.degrees) {
    MatrixX table = MatrixX::Ones(1, 1);
    for (int& degree : degrees) {
      // Functions (rows) at points (columns), those of the first direction fastest
      table = Eigen::kroneckerProduct(bernstein_values(degree, subdivisions), table).eval();
      degree = subdivisions;
    }
    table = grid.weights.segment(first, table.rows()).asDiagonal() * table;
    const VectorX sums = table.colwise().sum();
    first += table.rows();
    count += table.cols();
    tables.push_back(table * sums.cwiseInverse().asDiagonal());
  }
  const auto evaluate = [&](const MatrixX& coefficients) {
    MatrixX values(coefficients.rows(), count);
    Eigen::Index from = 0, to = 0;
    for (const MatrixX& table : tables) {
      values.middleCols(to, table.cols()) = coefficients.middleCols(from, table.rows()) * table;
      from += table.rows();
      to += table.cols();
    }
    return values;
  };
  samples.points = evaluate(grid.points);
  samples.weights = VectorX::Ones(count);
  for (PointArray& array : samples.point_arrays) array.values = evaluate(array.values);
  return samples;
}

} // namespace signorini::exchange
