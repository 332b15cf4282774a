#pragma once
// The points of an element as a grid, its triangles, and its borders as lines.

#include "base/index.hpp"
#include "tessellation/tessellate.hpp"

namespace signorini::tessellation {

/// The grid of points of an element in the plane, of an element's side, or of a patch.
struct Grid {
  const std::vector<double>&along, &across; ///< fractions of its two directions
  Eigen::Index first;                       ///< index of its first point in the skin

  int columns() const { return static_cast<int>(along.size()); }
  int rows() const { return static_cast<int>(across.size()); }
  Eigen::Index size() const { return Eigen::Index(columns()) * rows(); }
  Eigen::Index triangles() const { return 2 * Eigen::Index(columns() - 1) * (rows() - 1); }
  Eigen::Index operator()(int i, int j) const { return first + i + Eigen::Index(columns()) * j; }
};

void add_triangles(Triangles& triangles, Eigen::Index& next, const Grid& grid);

/// The element's border along one of its directions, at the start or the end of the other one.
SkinLine border(const Skin& skin, const Grid& grid, int along, bool at_end);

/// Adds the borders of the element (i, j), which come in order, to the lines between elements, each once, and to the
/// rim: one line for each of the four sides. `counts`: of elements.
void add_borders(Skin& skin, const Grid& grid, std::array<int, 2> element, std::array<int, 2> counts);

} // namespace signorini::tessellation
