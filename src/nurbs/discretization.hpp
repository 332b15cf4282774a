#pragma once
// The element-wise function space of a body, built from a patch and order labels: a stack of rows of control points.

#include "nurbs/element_grid.hpp"
#include "nurbs/label.hpp"
#include "nurbs/refine.hpp"
#include "nurbs/tensor.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace signorini::nurbs {

/// Per contact face, then per direction along it: which elements have the layer's degree (an empty list: all). In a
/// solid a row is the product of its two spaces, so that its degree is raised in the strips of both directions. Empty:
/// everywhere.
using RaisedElements = std::vector<std::vector<std::vector<bool>>>;

/// How a patch is discretized. Lists have one entry per parametric direction unless stated otherwise.
struct Plan {
  std::vector<int> elements;
  std::vector<std::optional<Grading>> grading; ///< may be empty: uniform in every direction
  std::vector<Label> labels; ///< per direction along the contact face; without one, per direction of the patch
  std::vector<Side> contact; ///< none, one, or two opposite faces
  std::optional<int> thickness_degree; ///< degree in the thickness direction; by default that of the bulk
  RaisedElements raised{};             ///< of `elements`: where the layer is local
  /// Further knots of the layer's rows, per direction along the contact face; may be empty. The other rows are cut
  /// there into elements without loss of continuity.
  std::vector<std::vector<double>> layer_knots{};
};

/// What a discretization with a layer was made from.
struct Recipe {
  Patch patch;
  Plan plan;
};

/// Breakpoints of direction d before `layer_knots` are added: the borders of plan.elements.
std::vector<double> element_breaks(const Patch& patch, const Plan& plan, int d);

/// The functions that do not vanish on one element, evaluated at a point.
struct ElementBasis {
  std::vector<int> functions;
  VectorX values;    ///< R_A(ξ)
  MatrixX gradients; ///< ∂R_A/∂ξ^d, parametric dimension × functions

  /// Σ_A R_A(ξ) v_A of values v_A at all control points, one column each.
  VectorX combine(const MatrixX& at_points) const;
};

/// A patch as a stack of rows of control points along the thickness direction,
///   x(ξ) = Σ_j N_j(ξᵗ) C_j(ξ along the face) in homogeneous coordinates,
/// where every row C_j is a NURBS with one parametric dimension less and its own spaces (also of several degrees),
/// refined exactly from the patch or given. The geometry and the common weight function do not change, so partition of
/// unity and the exact shape hold for any choice of rows [theory 4.3]. All
/// rows share the same elements.
class Discretization : public ElementGrid {
public:
  Discretization(const Patch& patch, const Plan& plan);
  /// From its parts, as returned by through(), stack(), rows() and contact(), bit by bit. Throws Error if they are
  /// inconsistent, or if a space is not interpolatory at an end.
  Discretization(int through, Space1D stack, std::vector<Row> rows, std::vector<Side> contact);

  /// Null for a discretization without a layer, or from its parts.
  const std::shared_ptr<const Recipe>& recipe() const { return recipe_; }

  int dimension() const { return static_cast<int>(homogeneous_.rows()) - 1; }
  int functions() const { return static_cast<int>(homogeneous_.cols()); }
  /// Weighted control points of all rows, row by row, (dimension+1) × functions.
  const MatrixX& homogeneous() const { return homogeneous_; }
  MatrixX points() const;

  /// Thickness direction (from 0).
  int through() const { return through_; }
  /// The space in that direction; its functions are numbered like the rows.
  const Space1D& stack() const { return stack_; }
  const std::vector<Row>& rows() const { return rows_; }
  /// The direction of a row that corresponds to direction d ≠ through() of the body.
  int in_row(int d) const { return d < through_ ? d : d - 1; }
  /// Index of row j's first function.
  int first_function(int row) const { return first_[row]; }

  /// Highest degree in direction d of the functions on element e; determines the quadrature.
  int degree(int e, int d) const;
  ElementBasis basis(int e, const VectorX& xi) const;
  /// The functions of row j on element e; one in the thickness direction.
  ElementFunctions row_functions(int e, int j) const;

  const std::vector<Side>& contact() const { return contact_; }
  /// Functions that do not vanish on a side, in the order of the control points of face().
  std::vector<int> face_functions(Side side) const;
  /// The side as a NURBS; its control points are those of face_functions(). Throws Error if crosses_layer(): it is not
  /// a tensor product.
  Row face(Side side) const;

private:
  int through_;
  Space1D stack_;
  std::vector<Row> rows_;
  std::vector<int> first_;
  std::vector<Side> contact_;
  MatrixX homogeneous_;
  std::shared_ptr<const Recipe> recipe_;
};

/// Functions of row j at one end of its direction a, in parametric order: one in the plane, a line of them in a solid.
std::vector<int> row_end(const Discretization& space, int j, int a, bool at_end);

/// True if the rows of a layer have different functions on a side of a solid, so that it is not a single NURBS.
bool crosses_layer(const Discretization& space, Side side);

/// The discretization with its layer in other elements. Throws Error if it has no recipe.
Discretization with_layer(const Discretization& space, RaisedElements raised);

} // namespace signorini::nurbs
