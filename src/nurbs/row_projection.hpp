#pragma once
// Carries values at the control points of a row to a row of the same geometry and elements with other functions.

#include "nurbs/patch.hpp"

namespace signorini::nurbs {

/// The matrix P, functions of `to` × functions of `from`, of the best approximation [theory 4.5]
///   ∫ (Σ_b N_b (P c)_b − Σ_a N_a c_a)² dξ → min,
/// with the values of c at both ends, which supports prescribe. Exact, up to rounding, where `to` contains `from`;
/// polynomials that are in both are reproduced. Throws Error unless the elements are the same.
MatrixX projection(const Space1D& from, const Space1D& to);

/// Values at the control points of `to`, one column each, for those at the control points of `from`. Rows share their
/// weight function, so weighted values Σ_a N_a w_a v_a are projected, direction by direction: constants, rigid motions
/// and whatever else is in both rows are reproduced. Values of equal rows are copied.
MatrixX project_row(const Row& from, const Row& to, const MatrixX& values);

} // namespace signorini::nurbs
