#pragma once
// Checks of Gauss points against the geometry: functions with very different weights are far from the polynomials for
// which the points are exact, and so are areas of faces that bend sharply within an element.

#include "solid/body.hpp"

namespace signorini::solid {

/// The largest ratio of the weights of two control points.
double weight_ratio(const nurbs::Discretization& space);

/// Difference between the volumes (in the plane, areas) that the Gauss points of a body and twice as many per direction
/// find in the reference configuration, relative to the latter.
double volume_error(const nurbs::Discretization& space);

/// Error of the area of several faces of a body by the points of loads, see face_points(); 0 where dA/dξ differs by
/// less than a factor of 4 within each element, so that faces of many smooth elements cost little.
template <int D> double area_error(const Body<D>& body, const std::vector<nurbs::Side>& faces);

} // namespace signorini::solid
