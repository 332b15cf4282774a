#pragma once
// Checks that the map of a patch is one-to-one: its Jacobian must not change its sign, between Gauss points either.

#include "nurbs/patch.hpp"

namespace signorini::nurbs {

/// Throws Error if the Jacobian of a patch whose parametric dimension is that of space is negative somewhere, with the
/// place. It may be zero, as at poles and at collapsed sides and corners.
///
/// In homogeneous coordinates H = (w x, w) it is det(H,₁ … H,_D, H) / w^(D+1). The numerator is a polynomial on each
/// span; it lies between the least and the largest of its Bernstein coefficients, which converge to it quadratically
/// when the span is halved, and at corners are its values. Spans whose coefficients leave the sign open are halved.
/// Patches with more than `examined_coefficients` of them are not examined [theory 4.7].
void check_folds(const Patch& patch);

} // namespace signorini::nurbs
