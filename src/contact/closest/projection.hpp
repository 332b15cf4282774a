#pragma once
// Closest-point projection of a slave point onto a master curve or surface: the global minimum of the distance.

#include "contact/closest/admissible.hpp"
#include "contact/constants.hpp"

namespace signorini::contact {

/// Kind of the closest point.
enum class Foot {
  none,    ///< an open end of the master: no contact, because the normal would be arbitrary
  regular, ///< the line to the closest point is normal to the master
  edge,    ///< of a surface: on a kink between two elements (C⁰ knot), free to move along it
  corner   ///< a kink of a curve, or a crossing of kinks of a surface: the normal is the line to the closest point
};

template <int D> struct Projection {
  Foot foot = Foot::none;
  int element = -1; ///< of the master; −1 before the first projection
  int along = 0;    ///< Foot::edge: the direction along the kink
  FaceCoordinates<D> xi = FaceCoordinates<D>::Zero();
  /// Normal gap (xˢ − x̄ᵐ)·n̄, negative when penetrating.
  double gap = 0;
  double last = 0; ///< with xi on a level set, see MasterPoint
  MasterPoint<D> point() const { return {xi, last}; }
};

/// What a point of a set of faces finds from which no foot counts.
template <int D> Projection<D> nothing_near() {
  return {.gap = std::numeric_limits<double>::max()};
}

/// The closest point of `surface` to x. Starts at the element and parameter of `seed` (if any), descends across element
/// borders, then searches every element whose box is nearer than the point found. `point` receives the face's geometry
/// at the closest point (order 2).
///
/// Rules if the line to the closest point is not normal to the face: at an open border there is no contact
/// (Foot::none); at a kink the foot point is on the kink, with gap −distance if x lies inside (Foot::edge, corner). A
/// border of a surface that is collapsed to one point, such as a sphere's pole, is not open: as closest point it is a
/// corner.
///
/// From a point of a set of faces, `from`, the closest of the admissible minima that are not too far counts; without
/// one there is none, see nothing_near(), and `point` receives nothing.
///
/// point.settled is true if the last step was below `foot_tolerance`, false if the search reached its limit of
/// iterations or of moves between elements.
Projection<2> project(const Surface<2>& surface, const ElementBoxes<2>& boxes, const Vec<2>& x,
                      const Projection<2>& seed, FaceGeometry<2>& point, const Lookout<2>& from = {});
Projection<3> project(const Surface<3>& surface, const ElementBoxes<3>& boxes, const Vec<3>& x,
                      const Projection<3>& seed, FaceGeometry<3>& point, const Lookout<3>& from = {});

/// The local minimum of the distance reached by descent from an element and parameter; geometry in `point` (order 2).
void walk(const Surface<2>& surface, const Vec<2>& x, int element, const FaceCoordinates<2>& start,
          FaceGeometry<2>& point);
void walk(const Surface<3>& surface, const Vec<3>& x, int element, const FaceCoordinates<3>& start,
          FaceGeometry<3>& point);

} // namespace signorini::contact
