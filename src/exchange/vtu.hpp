#pragma once
// VTK's XML files of unstructured grids whose cells are rational Bézier curves, quadrilaterals and hexahedra, or linear
// ones for programs without these.

#include "base/eigen.hpp"

#include <string>
#include <vector>

namespace signorini::exchange {

/// Values at points, one column each; names of components may be empty.
struct PointArray {
  std::string name;
  MatrixX values;
  std::vector<std::string> components = {};
};

/// An integer per cell.
struct CellArray {
  std::string name;
  std::vector<int> values;
};

/// Names of the integers from 1.
struct NameList {
  std::string name;
  std::vector<std::string> entries;
};

/// Cells in sequence, each with its own control points, ξ¹ fastest.
struct BezierGrid {
  std::vector<std::vector<int>> degrees; ///< per cell: one for each of its 1 to 3 parametric directions
  MatrixX points;                        ///< 3 × points
  VectorX weights;
  std::vector<PointArray> point_arrays;
  std::vector<CellArray> cell_arrays;
  std::vector<NameList> names;
};

/// The order of a cell's points in VTK (9.1 or newer): corners, edges, faces, interior.
std::vector<int> vtk_order(const std::vector<int>& degrees);

/// The contents of a .vtu file; numbers keep all bits.
std::string vtu(const BezierGrid& grid);

/// Divides each cell into linear ones, as many as `subdivisions` in each direction, with values at their
/// corners, which lie on the exact geometry.
std::string linear_vtu(const BezierGrid& grid, int subdivisions);

} // namespace signorini::exchange
