#pragma once
// The stiffness of the displacements that constraints admit, without multipliers.

#include "solve/pattern.hpp"

#include <vector>

namespace signorini::model {

/// A matrix of the free displacements, without structural zeros off the diagonal.
struct Stiffness {
  solve::Pattern pattern;
  std::vector<double> values;
};

/// The tangent of the unknowns, of which those from number `displacements` on are multipliers χ, as
///     K_uu − K_uχ (K_χχ − E)⁻¹ K_χu:
/// closed conditions become springs, `constraint_stiffness` times as stiff as the displacements that they constrain;
/// open ones (K_χu = 0) have no part. In the limit E → 0, K_χχ = 0 the matrix has as many negative eigenvalues as the
/// saddle point less its m closed conditions (N. I. M. Gould, Math. Program. 32, 1985). `sizes`: by χ, the number of
/// unknowns of its multiplier if K_χχ is to be lumped to one block per multiplier, because it couples overlapping ones,
/// which softens the springs of functions that are closed in part; 0 or empty: χ are eliminated with those they couple.
Stiffness displacement_stiffness(const solve::Pattern& pattern, const std::vector<double>& values, int displacements,
                                 const std::vector<int>& sizes = {});

} // namespace signorini::model
