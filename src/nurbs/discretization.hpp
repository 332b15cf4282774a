#pragma once
// The element-wise function space of a body, built from a patch and order labels: a stack of rows of control points.

#include "nurbs/label.hpp"
#include "nurbs/refine.hpp"
#include "nurbs/tensor.hpp"

#include <array>
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
/// unity and the exact shape hold for any choice of rows (thesis 5.1, 5.2 generalized from one row to any number). All
/// rows share the same elements.
class Discretization {
public:
  Discretization(const Patch& patch, const Plan& plan);
  /// From its parts, as returned by through(), stack(), rows() and contact(), bit by bit. Throws Error if they are
  /// inconsistent, or if a space is not interpolatory at an end.
  Discretization(int through, Space1D stack, std::vector<Row> rows, std::vector<Side> contact);

  /// Null for a discretization without a layer, or from its parts.
  const std::shared_ptr<const Recipe>& recipe() const { return recipe_; }

  int parametric_dimension() const { return rows_.front().parametric_dimension() + 1; }
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

  int elements(int d) const { return direction(d).elements(); }
  int elements() const;
  /// Index of element e (counted with ξ¹ fastest) in direction d.
  int element_index(int e, int d) const;
  /// Whether element e has a face on a side.
  bool touches(int e, Side side) const {
    return element_index(e, side.direction) == (side.at_end ? elements(side.direction) - 1 : 0);
  }
  /// Number of elements at a side, and the f-th of them, the side's lower direction counting fastest.
  int elements_on(Side side) const { return elements() / elements(side.direction); }
  int element_behind(Side side, int f) const;
  /// Parameter interval of element e in direction d.
  std::array<double, 2> interval(int e, int d) const { return direction(d).interval(element_index(e, d)); }
  /// Parameters of the point of element e at these fractions (0 … 1 per direction).
  VectorX parameter(int e, const VectorX& fractions) const;
  /// Highest degree in direction d of the functions on element e; determines the quadrature.
  int degree(int e, int d) const;
  /// The element that contains xi. Throws Error if xi is outside the patch.
  int find_element(const VectorX& xi) const;
  ElementBasis basis(int e, const VectorX& xi) const;
  /// The same into a value whose memory is reused.
  void basis(int e, const VectorX& xi, ElementBasis& result) const;
  /// The functions of row j on element e; one in the thickness direction.
  ElementFunctions row_functions(int e, int j) const;

  const std::vector<Side>& contact() const { return contact_; }
  /// Functions of row j at one end of its direction a, in parametric order: one in the plane, a line of them in a
  /// solid.
  std::vector<int> row_end(int j, int a, bool at_end) const;
  /// Functions that do not vanish on a side, in the order of the control points of face().
  std::vector<int> face_functions(Side side) const;
  /// Whether the rows of a layer have different functions on a side of a solid, so that it is not a single NURBS.
  bool crosses_layer(Side side) const;
  /// The side as a NURBS; its control points are those of face_functions(). Throws Error for a side of a layered volume
  /// on which the rows' spaces differ: it is not a tensor product.
  Row face(Side side) const;

private:
  /// A space with the elements of direction d.
  const Space1D& direction(int d) const { return d == through_ ? stack_ : rows_.front().direction(in_row(d)); }

  int through_;
  Space1D stack_;
  std::vector<Row> rows_;
  std::vector<int> first_;
  std::vector<Side> contact_;
  MatrixX homogeneous_;
  std::shared_ptr<const Recipe> recipe_;
};

/// The discretization with its layer in other elements. Throws Error if it has no recipe.
Discretization with_layer(const Discretization& space, RaisedElements raised);

} // namespace signorini::nurbs
