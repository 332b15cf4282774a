#pragma once
// Directions of smallest stiffness of a tangent.

#include "base/eigen.hpp"
#include "solve/pattern.hpp"

#include <vector>

namespace signorini::model {

struct WeakDirection {
  VectorX direction; ///< by unknown, of length 1
  double stiffness;  ///< uᵀ K u
};

/// Approximate null vector of a singular or nearly singular K, by inverse iteration with K + σI. `values` in the order
/// of the pattern.
WeakDirection null_direction(const solve::Pattern& pattern, const std::vector<double>& values);

/// The eigenvector with the lowest eigenvalue among those of the symmetric part of K with smallest magnitude, by
/// inverse subspace iteration (K.-J. Bathe, Finite Element Procedures, 1996, 11.6).
WeakDirection softest_direction(const solve::Pattern& pattern, const std::vector<double>& values);

} // namespace signorini::model
