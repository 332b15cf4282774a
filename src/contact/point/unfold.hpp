#pragma once
// Slip across kinks of a master: the way from a slip point to a foot on the other side of a kink, unfolded into the
// plane of the foot's side [theory 7.8].

#include "contact/point/faces.hpp"
#include "contact/point/history.hpp"

namespace signorini::contact {

/// A place of a kink, on the side of the foot and on that of the slip point.
template <int D> struct Kink { Entry<D> near, far; };

/// The kinks of a curve on the way from a foot to a slip point, the shorter one in elements, that next to the foot
/// first; empty if the way is smooth, or there is none. On surfaces none are looked for: the way is the chord.
template <int D>
std::vector<Kink<D>> kinks_between(const Surface<D>& surface, const FaceGeometry<D>& foot,
                                   const FaceCoordinates<D>& slip);

/// xᵐ(ξ_sl) with its functions, as seen from the foot: across kinks, on the linear extension of the foot's side beyond
/// the kink next to it,
///   x(ξ_k) + τ s,   |τ s| the length of the way from there to ξ_sl in the accepted state,
/// so that friction acts along the foot's side, and x̄ᵐ − x has the length of the way on either side.
template <int D>
void locate_slip(const Faces<D>& faces, const MasterPoint<D>& slip, const FaceGeometry<D>& foot, FacePoint<D>& point);

/// Of a foot at a corner of a curve, LocalGeometry::way; 0 in 3D, and where the slip point is at the corner.
template <int D> double way_to_corner(const Master<D>& master, const FaceGeometry<D>& foot, const Vec<D>& slip_point);

/// The length of the way from a foot to a slip point across kinks, a sum of chords.
template <int D> double way_length(const Master<D>& master, const FaceGeometry<D>& foot, const MasterPoint<D>& slip);

} // namespace signorini::contact
