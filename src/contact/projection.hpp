#pragma once
// Closest-point projection of a slave point onto a master curve or surface: the global minimum of the distance.

#include "contact/constants.hpp"
#include "contact/search.hpp"

namespace signorini::contact {

/// What kind of point of the master is the closest.
enum class Foot {
  none,    ///< an open end of the master: no contact there (its normal would be arbitrary)
  regular, ///< the connecting line is normal to the master
  edge,    ///< of a surface: on a kink between two elements (C⁰ knot), free to move along it
  corner   ///< a kink of a curve, or where kinks of a surface cross: the normal is the connecting line itself
};

template <int D> struct Projection {
  Foot foot = Foot::none;
  int element = -1; ///< of the master; −1 before the first projection
  int along = 0;    ///< Foot::edge: the direction along the kink
  FaceCoordinates<D> xi = FaceCoordinates<D>::Zero();
  /// Normal gap (xˢ − x̄ᵐ)·n̄, negative when penetrating.
  double gap = 0;
};

/// The closest point of `surface` to x. Starts from the element and parameter of `seed` (when it has any), walks
/// downhill across element borders, then looks into every element whose box is nearer than what was found. `point`
/// holds the face's geometry at the closest point, order 2; its functions are left alone.
///
/// Rules where the connecting line is not normal to the face: an open border of the master is no contact (Foot::none);
/// at a kink the kink itself is the master point, with gap −distance when x lies on the inside (Foot::edge, corner).
/// A border of a surface that is collapsed to one point, such as a sphere's pole, is no open border: where it is the
/// closest, it is a corner.
///
/// point.settled says whether the search ended where its steps are below `foot_tolerance` of an element, and not
/// because it ran out of iterations or of moves from one element to the next.
Projection<2> project(const Surface<2>& surface, const ElementBoxes<2>& boxes, const Vec<2>& x,
                      const Projection<2>& seed, FacePoint<2>& point);
Projection<3> project(const Surface<3>& surface, const ElementBoxes<3>& boxes, const Vec<3>& x,
                      const Projection<3>& seed, FacePoint<3>& point);

/// The local minimum of the distance that the walk downhill from an element and parameter leads to; geometry in `point`
/// (order 2).
Foot walk(const Surface<3>& surface, const Vec<3>& x, int element, const FaceCoordinates<3>& start, FacePoint<3>& point,
          int& along);

} // namespace signorini::contact
