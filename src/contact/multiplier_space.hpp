#pragma once
// Function spaces of the multipliers of mortar contact along one direction of the slave face.

#include "nurbs/space1d.hpp"

namespace signorini::contact {

/// `equal`: the B-splines of the face. `reduced`: degree p − 2 on the same breakpoints, continuity two less, the
/// splines of the face's knots without the first two and the last two, which form an inf-sup stable pair with the face
/// (E. Brivadis, A. Buffa, B. Wohlmuth, L. Wunderlich, arXiv:1407.8313). Degree p − 1 is unstable.
enum class MultiplierSpace { equal, reduced };

/// The multipliers' space for a face's `trace`: non-negative functions that sum to 1. Elements of `reduced` have their
/// own degree less two and are discontinuous where the trace is at most C¹. Throws Error for `reduced` if an element
/// has a degree below 2.
nurbs::Space1D multiplier_space(const nurbs::Space1D& trace, MultiplierSpace kind);

} // namespace signorini::contact
