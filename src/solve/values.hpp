#pragma once
// Properties of a matrix and its factors: symmetry, regularity, accuracy of a solution.

#include "solve/constants.hpp"
#include "solve/pattern.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace signorini::solve {

/// Smallest and largest absolute pivot.
struct PivotRange {
  double least = std::numeric_limits<double>::infinity(), largest = 0;

  void add(double pivot) {
    least = std::isfinite(pivot) ? std::min(least, std::abs(pivot)) : 0;
    largest = std::max(largest, std::abs(pivot));
  }
  void add(const PivotRange& other) {
    least = std::min(least, other.least);
    largest = std::max(largest, other.largest);
  }
  bool regular(double least_ratio = least_pivot) const { return least > least_ratio * largest; }
};

/// K ← K + Kᵀ on a structurally symmetric pattern.
void add_transpose(const Pattern& pattern, double* values);
/// ½(K + Kᵀ)
std::vector<double> symmetrized(const Pattern& pattern, std::vector<double> values);

/// True if |a_ij − a_ji| ≤ symmetry_tolerance max|a| for all entries.
bool is_symmetric(const Pattern& pattern, const double* values);

/// ‖b − K x‖ / ‖b‖, zero if b is zero; infinite if x is not finite. `difference` is a work array.
double relative_residual(const Pattern& pattern, const double* values, const double* x, const double* b,
                         std::vector<double>& difference);

} // namespace signorini::solve
