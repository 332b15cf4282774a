#pragma once
// Multi-degree splines: piecewise polynomials with a degree per element and a continuity per breakpoint.

#include "nurbs/patch.hpp"

namespace signorini::nurbs {

/// The multi-degree splines that are C^k at interior breakpoint i for k = smoothness[i], and of degree degrees[e] on
/// element e: non-negative functions of least support with sum 1, by the integral recurrence [theory 4.4]
///   N_i(ξ) = F_i(ξ) − F_{i+1}(ξ),  F_i(ξ) = ∫_{−∞}^ξ M_i / ∫ M_i
/// from the functions M_i of the space with all degrees and continuities one less (C. V. Beccari, G. Casciola, S.
/// Morigi, CAGD 58, 2017). Sums of positive terms, differences of values of at most 1: errors do not grow with the
/// number of elements. There are degrees[0] + 1 + Σ_i (degrees[i] − smoothness[i]), over interior breakpoints. k may
/// equal the lower of two degrees: a breakpoint between elements of equal degree is then a cut of a smooth function.
/// The space has no knots. Throws Error if the lists do not fit, or a k is outside −1 … the lower degree.
Space1D multi_degree_space(std::vector<double> breaks, const std::vector<int>& degrees, std::vector<int> smoothness);

/// M with N^from_b = Σ_a M(a, b) N^to_a, from a space that is contained in `to`. Its breakpoints are among those of
/// `to`; errors are those of the best conditioned element in the support of each function, for any grading.
MatrixX representation(const Space1D& from, const Space1D& to);

/// Replaces direction d of a row by a space that contains the present one. The map does not change.
Row with_space(const Row& row, int d, const Space1D& space);

} // namespace signorini::nurbs
