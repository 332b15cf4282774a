#pragma once
// The present state of a model as rational Bézier cells with exact geometry and displacement, and fields in the same
// bases.

#include "model/results/field.hpp"
#include "model/steps/model.hpp"

namespace signorini::tessellation {

using model::Model;

/// Field coefficients at the control points of cells: value(t) = Σ_k w_k B_k(t) c_k / Σ_k w_k B_k(t), as the geometry.
struct CellField {
  std::string name;
  MatrixX values; ///< components × points
};

/// List of cells without common control points, so that fields may be discontinuous between them.
struct BezierCells {
  std::vector<std::vector<int>> degrees; ///< per cell, one per parametric direction
  MatrixX points;                        ///< 3 × points, in each cell ξ¹ fastest
  VectorX weights;
  std::vector<CellField> fields;
};

/// The elements of a body. Fields: displacement (3 components, exact); stress (Cauchy: xx, yy, zz, xy, yz, xz),
/// von_mises, pressure (−tr σ/3) and F (9 components, row by row), which interpolate the exact values at the (p+1)
/// Gauss points per direction of each element, p the cell's degrees.
template <int D> BezierCells bezier_cells(const Model<D>& model, int body, bool deformed);

/// The sides of a body's cells on the slave face of a contact, with all fields, and those of model::FaceField that
/// the contact has, the least-squares fit of the cell's degrees to the values at the contact points of an element.
/// `cells` are those of the slave's body.
template <int D>
BezierCells contact_cells(const Model<D>& model, int contact, std::size_t face, const BezierCells& cells);

} // namespace signorini::tessellation
