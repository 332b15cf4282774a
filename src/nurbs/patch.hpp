#pragma once
// A tensor-product NURBS: curve, surface or volume in 2D or 3D space. An immutable value.
// A patch is made of knot vectors, so that it can be refined and written for other programs; a row of a discretization
// and its faces are made of any 1D spaces.

#include "base/eigen.hpp"
#include "nurbs/space1d.hpp"

#include <string>
#include <vector>

namespace signorini::nurbs {

/// A NURBS of parametric dimension 1 to 3 in space of dimension 2 or 3; `Direction` is KnotVector or Space1D.
template <class Direction> class TensorProduct {
public:
  /// `homogeneous` is (dimension+1) × functions: weighted points (w x, w y[, w z], w), ξ¹ runs fastest.
  /// Throws Error when the number of points is not the product of the directions' functions, when a weight is not
  /// positive, a value not finite, or the dimensions do not fit.
  TensorProduct(std::vector<Direction> directions, MatrixX homogeneous);

  int parametric_dimension() const { return static_cast<int>(directions_.size()); }
  int dimension() const { return static_cast<int>(homogeneous_.rows()) - 1; }
  /// Number of control points.
  int functions() const { return static_cast<int>(homogeneous_.cols()); }

  const Direction& direction(int d) const { return directions_[at(d)]; }
  const std::vector<Direction>& directions() const { return directions_; }
  const MatrixX& homogeneous() const { return homogeneous_; }
  /// What one more along direction d adds to a function's number.
  int stride(int d) const;

  /// Control points, dimension × functions.
  MatrixX points() const;
  VectorX weights() const;

private:
  std::vector<Direction> directions_;
  MatrixX homogeneous_;
};

using Patch = TensorProduct<KnotVector>;
using Row = TensorProduct<Space1D>;

/// The same functions and control points, read from tables.
Row make_row(const Patch& patch);

/// Makes a patch of points (dimension × functions) and weights (all 1 when empty).
Patch make_patch(std::vector<KnotVector> directions, const MatrixX& points, const VectorX& weights = {});

/// The point at xi. Throws Error when xi has the wrong length or lies outside the knots.
template <class Direction> VectorX evaluate(const TensorProduct<Direction>& patch, const VectorX& xi);

/// One partial derivative of the map: how often each direction is differentiated, and the vector.
struct Derivative {
  std::vector<int> orders;
  VectorX value;
};

/// All partial derivatives of the rational map up to total order n at xi, by total order, then lexicographically
/// falling in ξ¹ ((0,0); (1,0), (0,1); (2,0), (1,1), (0,2); …). Piegl & Tiller eq. (4.20) generalized to any dimension.
std::vector<Derivative> derivatives(const Patch& patch, const VectorX& xi, int n);

/// One rational function that does not vanish at xi.
struct BasisValue {
  int function;
  double value;
};

/// The rational functions R_A(xi) that do not vanish on the element of xi, by rising index.
std::vector<BasisValue> rational_basis(const Patch& patch, const VectorX& xi);

/// A side of a patch: the parametric direction it is normal to, and which end.
struct Side {
  int direction; ///< 0-based parametric direction normal to the face
  bool at_end;   ///< false: first knot, true: last knot
  bool operator==(const Side&) const = default;
};

/// west/east (ξ¹), south/north (ξ²), front/back (ξ³). Throws Error that lists the names that fit.
Side side_of(const std::string& name, int parametric_dimension);
std::string name_of(Side side);
/// The name of the side that is probably meant by another one: "north" for "top" in the plane, "back" in space (as on a
/// block along the axes), the nearest for "nroth"; empty when none is near.
std::string meant_side(const std::string& name, int parametric_dimension);
/// +1 or −1: what turns a face's natural normal (2D: its tangent turned by −90°; 3D: τ₁×τ₂, both in parametric order)
/// to the outside of a right-handed body.
double outward_sign(Side side);

/// The face as a patch of one parametric dimension less (parametric dimension ≥ 2).
template <class Direction> TensorProduct<Direction> face(const TensorProduct<Direction>& patch, Side side);

/// The control row j normal to direction `through` as a patch of one parametric dimension less: control points with
/// index j in that direction. Row 0 and the last row are faces; inner rows are not part of the geometry.
template <class Direction>
TensorProduct<Direction> control_row(const TensorProduct<Direction>& patch, int through, int j);

} // namespace signorini::nurbs
