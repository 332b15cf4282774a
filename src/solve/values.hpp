#pragma once
// What can be said about values on a pattern: whether they are symmetric, how well a solution fits.

#include "solve/pattern.hpp"

#include <vector>

namespace signorini::solve {

/// Compares every entry with its mirror image on a structurally symmetric pattern.
class Symmetry {
public:
  explicit Symmetry(const Pattern& pattern);
  /// Whether |a_ij − a_ji| ≤ 1e-9 max|a| for all entries.
  bool holds(const double* values) const;

private:
  std::vector<int> mirror_; ///< position of (j, i) for each (i, j)
};

/// ‖b − K x‖ / ‖b‖, zero when b is; infinite when x is not finite. `difference` is scratch.
double relative_residual(const Pattern& pattern, const double* values, const double* x, const double* b,
                         std::vector<double>& difference);

} // namespace signorini::solve
