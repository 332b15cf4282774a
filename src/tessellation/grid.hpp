#pragma once
// Grid of points of an element, its triangles, and its borders as lines.

#include "tessellation/tessellate.hpp"

namespace signorini::tessellation {

/// Grid of points of a plane element, of a side of a solid element, or of a patch.
struct Grid {
  const std::vector<double>&along, &across; ///< fractions in its two directions
  Eigen::Index first;                       ///< index of its first point in the skin

  int columns() const { return std::ssize(along); }
  int rows() const { return std::ssize(across); }
  Eigen::Index size() const { return Eigen::Index(columns()) * rows(); }
  Eigen::Index triangles() const { return 2 * Eigen::Index(columns() - 1) * (rows() - 1); }
  Eigen::Index operator()(int i, int j) const { return first + i + Eigen::Index(columns()) * j; }
};

void add_triangles(Triangles& triangles, Eigen::Index& next, const Grid& grid);

/// The element's border in one of its directions, at the start or end of the other one.
SkinLine border(const Skin& skin, const Grid& grid, int along, bool at_end);

/// Adds the borders of element (i, j) to the lines between elements, each once, and to the rim, one line for each of
/// the four sides. Elements must be added in order; `counts`: numbers of elements.
void add_borders(Skin& skin, const Grid& grid, std::array<int, 2> element, std::array<int, 2> counts);

} // namespace signorini::tessellation
