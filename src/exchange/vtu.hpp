#pragma once
// VTK's XML files of unstructured grids whose cells are rational Bézier curves, quadrilaterals and hexahedra.

#include "base/eigen.hpp"

#include <string>
#include <vector>

namespace signorini::exchange {

/// Values at points, one column each; names of components may be none.
struct PointArray {
  std::string name;
  MatrixX values;
  std::vector<std::string> components = {};
};

/// A whole number per cell.
struct CellArray {
  std::string name;
  std::vector<int> values;
};

/// Names for whole numbers from 1.
struct NameList {
  std::string name;
  std::vector<std::string> entries;
};

/// Cells one behind the other with control points of their own, in each cell ξ¹ fastest.
struct BezierGrid {
  std::vector<std::vector<int>> degrees; ///< per cell: of 1 to 3 parametric directions
  MatrixX points;                        ///< 3 × points
  VectorX weights;
  std::vector<PointArray> point_arrays;
  std::vector<CellArray> cell_arrays;
  std::vector<NameList> names;
};

/// The order in which VTK (9.1 or newer) wants a cell's points: corners, edges, faces, inside.
std::vector<int> vtk_order(const std::vector<int>& degrees);

/// The bytes of a .vtu file; numbers keep all bits.
std::string vtu(const BezierGrid& grid);

} // namespace signorini::exchange
