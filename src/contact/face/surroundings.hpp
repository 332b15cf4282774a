#pragma once
// The elements of a set of faces that an element never touches: those across a convex edge.

#include "contact/face/surface.hpp"

#include <span>
#include <vector>

namespace signorini::contact {

/// By element of a set of faces before it is extended; the numbers are those of the extended set.
struct Surroundings {
  std::vector<int> numbers;           ///< of the elements themselves
  std::vector<std::vector<int>> list; ///< of elements across an edge that share control points with it

  std::span<const int> operator[](int element) const { return list[element]; }
};

/// `set`: in the reference configuration, as it is and extended.
template <int D> Surroundings find_surroundings(const Surface<D>& set, const Surface<D>& extended);

} // namespace signorini::contact
