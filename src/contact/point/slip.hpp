#pragma once
// Update of the slip point at the end of an accepted step: it moves along the master until the trial traction is on the
// Coulomb cone, ε_T |x̄ᵐ − xᵐ(ξ_sl)| = μ t_N [theory 7.1] (thesis 3.70, 3.71, without the first-order error of its Euler
// step).

#include "contact/closest/projection.hpp"

namespace signorini::contact {

/// The ξ between `slip` and `foot` with |x(foot) − x(ξ)| = length; returns `slip` if it is not farther away. On a
/// closed curve it follows the shorter path between them, if necessary across the seam.
FaceCoordinates<2> advance_slip(const Surface<2>& surface, const FaceCoordinates<2>& slip, const FaceGeometry<2>& foot,
                                double length);
/// Across a link and on a surface the path is the projection of the chord from `foot` to `slip`, that is along n_T, the
/// direction of the trial traction.
FaceCoordinates<3> advance_slip(const Surface<3>& surface, const FaceCoordinates<3>& slip, const FaceGeometry<3>& foot,
                                double length);

} // namespace signorini::contact
