#pragma once
// Elements of a face as Bézier patches: evaluation at points, boxes, and bounds on derivatives.

#include "contact/face/face_mesh.hpp"
#include "nurbs/bezier.hpp"

namespace signorini::contact {

/// Largest number of functions on one element of a face of a body in D dimensions.
template <int D>
inline constexpr int most_face_functions = D == 2 ? nurbs::max_degree + 1
                                                  : (nurbs::max_degree + 1) * (nurbs::max_degree + 1);

/// What identifies a point of a master in all its positions: parametric coordinates; on a level set, which has none,
/// the Cartesian ones in its own frame, of which `last` is the D-th.
template <int D> struct MasterPoint {
  MasterPoint(const FaceCoordinates<D>& coordinates = FaceCoordinates<D>::Zero(), double last_one = 0)
      : xi(coordinates), last(last_one) {}
  FaceCoordinates<D> xi;
  double last;
};

/// The face at one parametric point: position, tangents τ_α, second derivatives x_,αβ (2D: x_,11; 3D: x_,11 x_,12
/// x_,22).
template <int D> struct FaceGeometry {
  static constexpr int tangents = D - 1;
  static constexpr int seconds = (D - 1) * D / 2;
  int element;
  FaceCoordinates<D> xi;
  double last = 0; ///< with xi on a level set, see MasterPoint
  Vec<D> position;
  std::array<Vec<D>, tangents> tangent;
  std::array<Vec<D>, seconds> second;
  bool settled = true; ///< the search for this point converged, see projection.hpp
};

/// Bounds on the derivatives over a part of a face: a box around τ_α, and the largest |x_,αβ|, numbered as in
/// FaceGeometry.
template <int D> struct DerivativeBounds {
  std::array<Vec<D>, FaceGeometry<D>::tangents> lower, upper;
  std::array<double, FaceGeometry<D>::seconds> second;
  /// Extends the part by another one.
  void include(const DerivativeBounds& other);
};

/// Bézier points of an element, ξ¹ fastest: x if polynomial, otherwise (w x, w), filled up to width() values.
template <int D> struct BezierElement {
  const double* points;
  bool polynomial;
  std::array<int, D - 1> degree;
  std::array<std::array<double, 2>, D - 1> interval; ///< parametric

  int count() const { return D == 2 ? degree[0] + 1 : (degree[0] + 1) * (degree[D - 2] + 1); }
  int width() const { return D == 2 && polynomial ? 2 : 4; }
};

/// Calls run<W>(), W the number of values per Bézier point.
template <int D, class Run> void with_width(bool polynomial, const Run& run) {
  if (D == 2 && polynomial)
    run.template operator()<2>();
  else
    run.template operator()<4>();
}

/// Calls run<P>(), P the degree in every direction if the code is specialized for it, otherwise 0.
template <int D, class Run> void with_degree(const BezierElement<D>& element, const Run& run) {
  if (const int p = element.degree[0]; p == element.degree[D - 2]) switch (p) {
    case 1:
      return run.template operator()<1>();
    case 2:
      return run.template operator()<2>();
    case 3:
      return run.template operator()<3>();
    case 4:
      return run.template operator()<4>();
    case 5:
      return run.template operator()<5>();
    case 6:
      return run.template operator()<6>();
    }
  run.template operator()<0>();
}

/// Bernstein polynomials of each direction, ∂^k in row k.
template <int D> using Bernsteins = std::array<std::array<double, 3 * (nurbs::max_degree + 1)>, D - 1>;
/// P is the degree in every direction if it is known at compile time, otherwise 0.
template <int P, int Order, int D>
void bernsteins(const BezierElement<D>& element, const FaceCoordinates<D>& xi, Bernsteins<D>& out) {
  for (int d = 0; d < D - 1; ++d) {
    const auto [a, b] = element.interval[d];
    if constexpr (P > 0)
      nurbs::bernstein<P, Order>((xi(d) - a) / (b - a), 1 / (b - a), out[d].data());
    else
      nurbs::bernstein(element.degree[d], (xi(d) - a) / (b - a), b - a, Order, out[d].data());
  }
}

/// Bounding box of the Bézier points, which contains the element (convex hull property).
template <int D> void bounds(const BezierElement<D>& element, Vec<D>& lower, Vec<D>& upper);
/// The same of the displacements from one shape of an element to another.
template <int D>
void bounds_of_motion(const BezierElement<D>& before, const BezierElement<D>& now, Vec<D>& lower, Vec<D>& upper);
/// Least n·x of the Bézier points, a lower bound for all points of the element.
template <int D> double least_along(const BezierElement<D>& element, const Vec<D>& direction);
/// Bounds on the derivatives from the Bézier points, those of a polynomial from their differences.
template <int D> DerivativeBounds<D> derivative_bounds(const BezierElement<D>& element);

/// Evaluates the geometry at xi. `order` 0: position, 1: also tangents, 2: also second derivatives.
template <int D>
void locate(const BezierElement<D>& element, const FaceCoordinates<D>& xi, int order, FaceGeometry<D>& point);
/// Positions on a grid, 3(p + 1) points per direction, evenly spaced from border to border: coordinate i of all points
/// from positions[i · number of points] on, ξ¹ fastest. At most grid_points per direction.
template <int D> void sample(const BezierElement<D>& element, double* positions);
inline constexpr int grid_points = 3 * (nurbs::max_degree + 1);

} // namespace signorini::contact
