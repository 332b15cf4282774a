#pragma once
// Interfaces of patches: faces with the same knots and control points, in any relative orientation.

#include "exchange/exchange.hpp"
#include "nurbs/orientation.hpp"

namespace signorini::exchange {

/// An interface and how the directions of its first face run along those of the second one.
struct OrientedInterface {
  Interface faces;
  nurbs::Orientation way;
};

/// The interfaces of a geometry; if it does not list them, those that its patches have. Throws Error if a listed one
/// has faces that do not match.
std::vector<OrientedInterface> interfaces_of(const Geometry& geometry);

/// Faces of no interface, patch by patch.
std::vector<PatchFace> outer_faces(const Geometry& geometry, const std::vector<OrientedInterface>& interfaces);

/// Number of a side in G+Smo and GeoPDEs: west 1, east 2, south 3, north 4, front 5, back 6.
int number_of(nurbs::Side side);
nurbs::Side side_of_number(int number);

} // namespace signorini::exchange
