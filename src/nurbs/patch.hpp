#pragma once
// A tensor-product NURBS: curve, surface or volume in 2D or 3D space. An immutable value. A patch is made of knot
// vectors, so that it can be refined and exported; rows of a discretization and their faces are made of any 1D spaces.

#include "base/eigen.hpp"
#include "nurbs/space1d.hpp"

#include <string>
#include <vector>

namespace signorini::nurbs {

/// A NURBS of parametric dimension 1 to 3 in space of dimension 2 or 3; `Direction` is KnotVector or Space1D.
template <class Direction> class TensorProduct {
public:
  /// `homogeneous` is (dimension+1) × functions: weighted points (w x, w y[, w z], w), ξ¹ fastest. Throws Error if the
  /// number of points is not the product of the directions' functions, a weight is not positive, a value is not finite,
  /// or the dimensions are inconsistent.
  TensorProduct(std::vector<Direction> directions, MatrixX homogeneous);

  int parametric_dimension() const { return std::ssize(directions_); }
  int dimension() const { return static_cast<int>(homogeneous_.rows()) - 1; }
  /// Number of control points.
  int functions() const { return static_cast<int>(homogeneous_.cols()); }

  const Direction& direction(int d) const { return directions_[d]; }
  const std::vector<Direction>& directions() const { return directions_; }
  const MatrixX& homogeneous() const { return homogeneous_; }
  /// Difference of the indices of two functions that are neighbors along direction d.
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

/// Tabulates the spaces; functions and control points do not change.
Row make_row(const Patch& patch);

/// Makes a patch from points (dimension × functions) and weights (all 1 if empty).
Patch make_patch(std::vector<KnotVector> directions, const MatrixX& points, const VectorX& weights = {});

/// The point at xi. Throws Error if xi has the wrong length or lies outside the knots.
template <class Direction> VectorX evaluate(const TensorProduct<Direction>& patch, const VectorX& xi);

/// One partial derivative of the map: the order of differentiation per direction, and the vector.
struct Derivative {
  std::vector<int> orders;
  VectorX value;
};

/// All partial derivatives of the rational map up to total order n at xi, by total order, then lexicographically
/// decreasing in ξ¹ ((0,0); (1,0), (0,1); (2,0), (1,1), (0,2); …). Piegl & Tiller eq. (4.20) generalized to any
/// dimension.
std::vector<Derivative> derivatives(const Patch& patch, const VectorX& xi, int n);

/// One rational function that does not vanish at xi.
struct BasisValue {
  int function;
  double value;
};

/// The rational functions R_A(xi) that do not vanish on the element of xi, by increasing index.
std::vector<BasisValue> rational_basis(const Patch& patch, const VectorX& xi);

/// A side of a patch: the parametric direction normal to it, and which end.
struct Side {
  int direction; ///< 0-based parametric direction normal to the face
  bool at_end;   ///< false: first knot, true: last knot
  bool operator==(const Side&) const = default;
};

/// All sides, by direction.
std::vector<Side> sides(int parametric_dimension);
/// west/east (ξ¹), south/north (ξ²), front/back (ξ³). Throws Error that lists the valid names.
Side side_of(const std::string& name, int parametric_dimension);
std::string name_of(Side side);
/// The side that is probably meant by another name: "north" for "top" in the plane, "back" in space (as on a block
/// along the axes), the most similar name for "nroth"; empty if none is similar.
std::string meant_side(const std::string& name, int parametric_dimension);
/// +1 or −1: the factor that turns a face's natural normal (2D: its tangent rotated by −90°; 3D: τ₁×τ₂, both in
/// parametric order) to the outside of a right-handed body.
double outward_sign(Side side);

/// The face as a patch with one parametric dimension less (parametric dimension ≥ 2).
template <class Direction> TensorProduct<Direction> face(const TensorProduct<Direction>& patch, Side side);

/// Row j of control points normal to direction `through` as a patch with one parametric dimension less: the control
/// points with index j in that direction. The first and the last row are faces; inner rows are not part of the
/// geometry.
template <class Direction>
TensorProduct<Direction> control_row(const TensorProduct<Direction>& patch, int through, int j);

} // namespace signorini::nurbs
