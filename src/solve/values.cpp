#include "solve/values.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini::solve {

namespace {

/// Calls visit(k, m) for each position k and that of the transposed entry, m: traversing columns in order visits the
/// transposed entries of each other column in its order.
template <class Visit> void visit_transposed(const Pattern& pattern, const Visit& visit) {
  std::vector<int> next(pattern.starts.begin(), pattern.starts.end());
  for (std::size_t k = 0; k < pattern.rows.size(); ++k) visit(k, next[pattern.rows[k]]++);
}

} // namespace

void add_transpose(const Pattern& pattern, double* values) {
  visit_transposed(pattern, [&](std::size_t k, std::size_t m) {
    if (k <= m) values[k] = values[m] = values[k] + values[m];
  });
}

std::vector<double> symmetrized(const Pattern& pattern, std::vector<double> values) {
  add_transpose(pattern, values.data());
  for (double& value : values) value *= 0.5;
  return values;
}

bool is_symmetric(const Pattern& pattern, const double* values) {
  double largest = 0, difference = 0;
  visit_transposed(pattern, [&](std::size_t k, std::size_t m) {
    largest = std::max(largest, std::abs(values[k]));
    difference = std::max(difference, std::abs(values[k] - values[m]));
  });
  return difference <= symmetry_tolerance * largest;
}

double relative_residual(const Pattern& pattern, const double* values, const double* x, const double* b,
                         std::vector<double>& difference) {
  difference.assign(b, b + pattern.size);
  for (int j = 0; j < pattern.size; ++j)
    for (int k = pattern.starts[j]; k < pattern.starts[j + 1]; ++k) difference[pattern.rows[k]] -= values[k] * x[j];
  double square = 0, scale = 0;
  for (int i = 0; i < pattern.size; ++i) {
    square += difference[i] * difference[i];
    scale += b[i] * b[i];
  }
  if (!std::isfinite(square)) return std::numeric_limits<double>::infinity();
  return scale > 0 ? std::sqrt(square / scale) : 0;
}

} // namespace signorini::solve
