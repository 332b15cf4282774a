#pragma once
// How many unknowns a body would have in another space, or in a part of its own: counted without building it.

#include "nurbs/discretisation.hpp"

#include <array>
#include <functional>

namespace signorini::model {

/// A row of control points in the changed space: along each of its directions, for every function there, the present
/// one whose place it takes.
struct ChangedRow {
  int source; ///< the present row whose place it takes
  std::vector<std::vector<int>> along;
};
using ChangedSpace = std::vector<ChangedRow>;

ChangedSpace unchanged(const nurbs::Discretisation& space);

/// Where a function stands: its number along each parametric direction of the body.
using Place = std::array<int, 3>;

/// Number along each direction of every function of a space.
std::vector<Place> places(const nurbs::Discretisation& space);

/// Tells whether a component of a changed function is prescribed: `function` is the present one whose place it takes,
/// `place` its own in the changed space.
using Prescribed = std::function<bool(int component, int function, const Place& place)>;

/// Components that are not prescribed; those of functions that are one point of the body (nurbs/coincident.hpp) count
/// once, and are prescribed where one of them is.
int count_free(const nurbs::Discretisation& space, const ChangedSpace& changed, int components,
               const Prescribed& prescribed);

} // namespace signorini::model
