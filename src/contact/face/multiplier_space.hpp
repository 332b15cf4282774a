#pragma once
// Function spaces of the multipliers of mortar contact and ties on the slave face.

#include "contact/face/surface.hpp"

namespace signorini::contact {

/// `equal`: the B-splines of the face. `reduced`: degree p − 2 on the same breakpoints, continuity two less, the
/// splines of the face's knots without the first two and the last two, which form an inf-sup stable pair with the face
/// (E. Brivadis, A. Buffa, B. Wohlmuth, L. Wunderlich, arXiv:1407.8313). Degree p − 1 is unstable.
/// `linear`: degree 1, a function per element, or per so many joined elements, for slaves that are stiffer than the
/// master: more conditions than the master has functions per length cannot be met, and states cycle. `automatic`: of
/// contacts whose multipliers are unknowns, `equal` or `linear` (model/scene/default_penalty.hpp).
enum class MultiplierSpace { equal, reduced, linear, automatic };

/// The multipliers' space for a face's `trace`: non-negative functions that sum to 1. Elements of `reduced` have their
/// own degree less two and are discontinuous where the trace is at most C¹. Throws Error for `reduced` if an element
/// has a degree below 2. `joined`: elements per function of `linear`.
nurbs::Space1D multiplier_space(const nurbs::Space1D& trace, MultiplierSpace kind, int joined = 1);

/// The multipliers' functions on a face: the products of those along its directions. Where the face closes on itself or
/// shrinks to a pole, control points share unknowns and the trace is a space of sums of products; `equal` and `linear`
/// have the same sums. Separate functions there would be more conditions than the displacements can satisfy. `reduced`
/// has no function that needs a neighbor across a seam, where the trace is C⁰: its products are its functions.
template <int D> struct FaceMultipliers {
  FaceMultipliers(const Surface<D>& slave, MultiplierSpace kind, int joined = 1);

  std::vector<nurbs::Space1D> along; ///< by direction
  std::vector<int> number;           ///< of the function that contains each product, ξ¹ fastest
  int count;                         ///< of functions
};

} // namespace signorini::contact
