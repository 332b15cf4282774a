#pragma once
// The slip point's advance at the end of an accepted step.

#include "contact/projection.hpp"

namespace signorini::contact {

/// The parameter ξ between `slip` and `foot` on the master with |x(foot) − x(ξ)| = length: the slip point follows along
/// the surface until the trial traction is back on the Coulomb cone, ε_T |x̄ᵐ − xᵐ(ξ_sl)| = μ t_N (thesis 3.70, 3.71
/// without the first-order error of its Euler step). On a closed curve the shorter way between them, over its seam if
/// need be. `length` must not exceed the present distance.
FaceCoordinates<2> advance_slip(const Surface<2>& surface, const FaceCoordinates<2>& slip, const FacePoint<2>& foot,
                                double length);
/// The point ξ of a master surface that lies below the chord from `foot` to `slip`, with |x(foot) − x(ξ)| = length: the
/// slip point moves along n_T, the direction of the trial traction, until ε_T |x̄ᵐ − xᵐ(ξ_sl)| = μ t_N
/// (thesis 3.70, 3.71 without the first-order error of its Euler step). `length` must not exceed the present distance.
FaceCoordinates<3> advance_slip(const Surface<3>& surface, const FaceCoordinates<3>& slip, const FacePoint<3>& foot,
                                double length);

} // namespace signorini::contact
