#pragma once
// Relative orientations of two faces: how the directions of one run along those of the other.

#include <array>
#include <cstddef>
#include <vector>

namespace signorini::nurbs {

/// Coordinate k of the first face is coordinate `to[k]` of the second one, reversed if flip[k]. Curves have one
/// coordinate; the second one is then 0 for both.
struct Orientation {
  std::array<std::size_t, 2> to;
  std::array<bool, 2> flip;

  /// A list of one entry per coordinate of the first face, in the second one's order; reverse(k, entry) reverses one.
  template <class T, class Reverse> std::array<T, 2> turn(const std::array<T, 2>& list, const Reverse& reverse) const {
    std::array<T, 2> result = list;
    for (std::size_t k = 0; k < 2; ++k) result[to[k]] = flip[k] ? reverse(k, list[k]) : list[k];
    return result;
  }
  /// True if normals of the two faces, from their directions in order, are opposite.
  bool mirrors() const { return (to[0] == 1) != (flip[0] != flip[1]); }
};

/// All orientations of curves (2) or surfaces (8), the identity first.
inline std::vector<Orientation> orientations(int dimensions) {
  std::vector<Orientation> all;
  for (const bool swap : {false, true})
    for (const bool second : {false, true})
      for (const bool first : {false, true})
        if (dimensions > 1 || (!swap && !second)) all.push_back({{swap ? 1U : 0U, swap ? 0U : 1U}, {first, second}});
  return all;
}

} // namespace signorini::nurbs
