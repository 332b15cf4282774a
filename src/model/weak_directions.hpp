#pragma once
// Directions in which a tangent is weakest.

#include "base/eigen.hpp"
#include "solve/pattern.hpp"

#include <vector>

namespace signorini::model {

struct WeakDirection {
  VectorX direction; ///< by unknown, of length 1
  double stiffness;  ///< uᵀ K u
};

/// The direction that a singular K, or one nearly so, maps closest to nothing: inverse iteration with K + σI. `values`
/// in the order of the pattern.
WeakDirection null_direction(const solve::Pattern& pattern, const std::vector<double>& values);

/// The direction of lowest stiffness among those nearest to none of the symmetric part of K: subspace iteration with
/// its inverse (K.-J. Bathe, Finite Element Procedures, 1996, 11.6).
WeakDirection softest_direction(const solve::Pattern& pattern, const std::vector<double>& values);

} // namespace signorini::model
