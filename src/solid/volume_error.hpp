#pragma once
// Check of a body's Gauss points against its geometry.

#include "nurbs/discretization.hpp"

namespace signorini::solid {

/// The largest ratio of the weights of two control points.
double weight_ratio(const nurbs::Discretization& space);

/// Difference between the volumes (in the plane, areas) that the Gauss points of a body and twice as many per direction
/// find in the reference configuration, relative to the latter. Functions with very different weights are far from
/// polynomials, for which the points are exact.
double volume_error(const nurbs::Discretization& space);

} // namespace signorini::solid
