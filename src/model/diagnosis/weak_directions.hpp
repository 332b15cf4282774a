#pragma once
// Directions of smallest stiffness of a tangent.

#include "model/stability/subspace_iteration.hpp"

#include <optional>
#include <vector>

namespace signorini::model {

/// The values of K + σ I.
std::vector<double> shifted(const solve::Pattern& pattern, std::vector<double> values, double shift);

struct WeakDirection {
  VectorX direction; ///< by unknown, of length 1
  double stiffness;  ///< κ of K u = κ u
  /// Number of negative eigenvalues of the symmetric part, if the solver counts them and there are no multipliers.
  std::optional<int> negative = {};
};

/// Approximate null vector of a singular or nearly singular K, by inverse iteration with K + σI. `values` in the order
/// of the pattern, `solver` one that factors every matrix. The unknowns from number `displacements` on are multipliers,
/// and zero in the direction.
WeakDirection null_direction(const solve::Pattern& pattern, const std::vector<double>& values, int displacements,
                             solve::LinearKind solver = solve::LinearKind::umfpack);

/// The eigenvector with the lowest eigenvalue among those of the symmetric part of K with smallest magnitude, by
/// inverse subspace iteration (K.-J. Bathe, Finite Element Procedures, 1996, 11.6); with multipliers of the
/// displacements that they admit. Of a matrix without negative eigenvalues, if the solver counts them, the direction is
/// zero and not computed.
WeakDirection softest_direction(const solve::Pattern& pattern, const std::vector<double>& values, int displacements,
                                solve::LinearKind solver = solve::LinearKind::umfpack);

} // namespace signorini::model
