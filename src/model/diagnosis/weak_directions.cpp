#include "model/diagnosis/weak_directions.hpp"

#include "base/orthonormal.hpp"
#include "solve/least_eigenpair.hpp"
#include "solve/values.hpp"

#include <algorithm>
#include <utility>

namespace signorini::model {

namespace {

double largest_entry(const solve::Pattern& pattern, const std::vector<double>& values) {
  double largest = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(pattern.entries()); ++i)
    largest = std::max(largest, std::abs(values[i]));
  return largest;
}

/// Deterministic start vectors without preferred direction.
MatrixX start_vectors(int size, int count) {
  MatrixX x(size, count);
  for (int j = 0; j < count; ++j)
    for (int i = 0; i < size; ++i) x(i, j) = std::sin(1.0 + 0.7 * (i + 1) * (j + 1) + 0.01 * i * i);
  return x;
}

/// Ritz pair with the lowest value in the space obtained by inverse iteration of `matrix`. `only_negative`: not
/// computed if the solver finds no negative eigenvalue.
WeakDirection iterate(solve::LinearKind kind, const solve::Pattern& pattern, const std::vector<double>& matrix,
                      int displacements, int count, int rounds, bool only_negative) {
  constexpr double relative_shift = 1e-12; // makes a singular matrix regular
  const std::vector<double> regular = shifted(pattern, matrix, relative_shift * largest_entry(pattern, matrix));
  const auto solver = solve::make_solver(kind, pattern);
  count = std::min(count, displacements);
  // Multipliers have no inertia: where they follow the displacements, inverse iteration of diag(K, 0) converges to the
  // eigenvectors of the constrained displacements.
  const auto without_multipliers = [&](MatrixX y) {
    y.bottomRows(pattern.size - displacements).setZero();
    return orthonormal(std::move(y));
  };
  MatrixX x = without_multipliers(start_vectors(pattern.size, count));
  if (!solver->factor(regular.data())) return {VectorX::Zero(pattern.size), 0};
  const int counted = solver->statistics().negative;
  std::optional<int> negative;
  if (counted >= 0 && displacements == pattern.size) negative = counted;
  if (only_negative && negative == 0) return {VectorX::Zero(pattern.size), 0, negative};
  for (int round = 0; round < rounds; ++round) {
    for (int j = 0; j < count; ++j)
      if (!solver->solve(x.col(j).data())) return {VectorX::Zero(pattern.size), 0};
    x = without_multipliers(std::move(x));
  }
  const MatrixX small = x.transpose().lazyProduct(times(pattern, matrix, x));
  const auto [value, vector] = solve::least_eigenpair(0.5 * (small + small.transpose()));
  return {x.lazyProduct(vector), value, negative};
}

} // namespace

MatrixX times(const solve::Pattern& pattern, const std::vector<double>& values, const MatrixX& x) {
  MatrixX product = MatrixX::Zero(x.rows(), x.cols());
  for (int j = 0; j < pattern.size; ++j)
    for (int k = pattern.starts[j]; k < pattern.starts[j + 1]; ++k)
      product.row(pattern.rows[k]) += values[k] * x.row(j);
  return product;
}

std::vector<double> shifted(const solve::Pattern& pattern, std::vector<double> values, double shift) {
  for (int i = 0; i < pattern.size; ++i) values[pattern.find(i, i)] += shift;
  return values;
}

WeakDirection null_direction(const solve::Pattern& pattern, const std::vector<double>& values, int displacements,
                             solve::LinearKind solver) {
  return iterate(solver, pattern, values, displacements, 1, 6, false);
}

WeakDirection softest_direction(const solve::Pattern& pattern, const std::vector<double>& values, int displacements,
                                solve::LinearKind solver) {
  return iterate(solver, pattern, solve::symmetrized(pattern, values), displacements, 8, 12, true);
}

} // namespace signorini::model
