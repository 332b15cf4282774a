#pragma once
// Moving contact face: the NURBS face of a body, evaluated at the current control points.

#include "base/eigen.hpp"
#include "contact/face/face_grid.hpp"
#include "nurbs/discretization.hpp"

#include <array>
#include <limits>
#include <vector>

namespace signorini::contact {

/// Largest number of functions on one element of a face of a body in D dimensions.
template <int D>
inline constexpr int most_face_functions = D == 2 ? nurbs::max_degree + 1
                                                  : (nurbs::max_degree + 1) * (nurbs::max_degree + 1);

/// Parametric coordinates on a face.
template <int D> using FaceCoordinates = Eigen::Matrix<double, D - 1, 1>;

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
  bool settled = true; ///< whether the search for this point converged, see projection.hpp
};

/// With the rational functions and their first derivatives, which are evaluated on request.
template <int D> struct FacePoint : FaceGeometry<D> {
  std::array<double, most_face_functions<D>> value;
  std::array<std::array<double, most_face_functions<D>>, D - 1> derivative;
};

/// Normal times the surface measure: the tangent rotated by −90° (2D), τ₁×τ₂ (3D).
template <int D> Vec<D> normal_of(const std::array<Vec<D>, D - 1>& tangent) {
  if constexpr (D == 2)
    return {tangent[0](1), -tangent[0](0)};
  else
    return tangent[0].cross(tangent[1]);
}

/// Bounds on the derivatives over a part of a face: a box around τ_α, and the largest |x_,αβ|, numbered as in
/// FaceGeometry.
template <int D> struct DerivativeBounds {
  std::array<Vec<D>, FaceGeometry<D>::tangents> lower, upper;
  std::array<double, FaceGeometry<D>::seconds> second;
  /// Extends the part by another one.
  void include(const DerivativeBounds& other);
};

/// A face of a body, or several faces with common borders; face-local indices number its control points.
template <int D> class Surface {
public:
  /// `first`: number of the body's first function; `shared`: see shared(), empty: no control points share unknowns.
  /// Throws Error unless `side` is a tensor-product face of the body (see Discretization::face).
  Surface(const nurbs::Discretization& body, nurbs::Side side, int first = 0, std::vector<int> shared = {});
  /// Several faces as one, with the numbers of their nodes.
  explicit Surface(FaceGrid grid);
  /// A patch without a body, with the outside on the right of its direction (2D), or with outward normal τ₁×τ₂ (3D).
  explicit Surface(const nurbs::Patch& patch);

  /// Of several faces, where each lies in the whole.
  const std::vector<FacePlace>& places() const { return places_; }
  /// The element of a face (0 unless there are several), by direction of that face, at an element of the surface; of an
  /// extension beyond an open end the face's last element there.
  struct OwnElement {
    int face;
    std::array<int, D - 1> index;
  };
  OwnElement own_element(int element) const;
  int elements() const { return std::ssize(elements_); }
  /// Number of functions on an element.
  int functions_on(int element) const { return elements_[element].functions; }
  /// Largest number of functions on an element.
  int most_functions() const { return most_functions_; }
  /// Control points of the face.
  int functions() const { return std::ssize(functions_); }
  /// Face-local indices of the functions of an element.
  const int* nodes(int element) const { return nodes_.data() + elements_[element].nodes; }
  /// The body's function of face-local index i, in a scene numbered through all bodies.
  int body_function(int i) const { return functions_[i]; }
  /// A number that face-local indices have in common if their control points share unknowns: at a seam, at a pole.
  int shared(int i) const { return shared_.empty() ? body_function(i) : shared_[i]; }
  /// Degree of an element along the face's direction α.
  int degree(int element, int alpha) const { return direction(alpha).degree(index(element, alpha)); }
  const nurbs::Space1D& direction(int alpha) const { return spaces_[alpha]; }
  /// Parametric interval of an element in direction α.
  std::array<double, 2> interval(int element, int alpha) const {
    return direction(alpha).interval(index(element, alpha));
  }
  /// The element that contains xi.
  int find_element(const FaceCoordinates<D>& xi) const;
  /// The element that shares the border of `element` at the start or end of direction α; −1 at the face's end.
  int neighbor(int element, int alpha, bool at_end) const;

  /// Extends the face along its tangents beyond its open ends, by a fraction of its last elements, at most by a length
  /// in the reference configuration; to be called once, before move(). A seam and a border collapsed to one point, such
  /// as a pole, are not open ends.
  void extend(double part, double longest = std::numeric_limits<double>::infinity());
  /// Factor on the traction at xi: 1 on the face itself, falling to 0 at the end of the extension, with continuous
  /// first derivatives `rate` with respect to xi.
  double fade(const FaceCoordinates<D>& xi, FaceCoordinates<D>& rate) const;

  /// Sets the current control points: reference positions plus displacement (D values per function, in the numbering of
  /// body_function()). Returns the largest distance by which a Bézier point has moved, a bound on that of any point of
  /// the face and of its extension, whose points are convex combinations of their Bézier points.
  double move(const double* displacement);
  /// The largest distance between its Bézier points and those of another shape of the same face, a bound as of move().
  double moved_since(const Surface& before) const;
  /// Current control points, D × functions.
  const Eigen::Matrix<double, D, Eigen::Dynamic>& points() const { return points_; }
  /// The same without displacements.
  const Eigen::Matrix<double, D, Eigen::Dynamic>& reference() const { return reference_; }

  /// Bounding box of an element's Bézier points, which contains the element (convex hull property).
  void bounds(int element, Vec<D>& lower, Vec<D>& upper) const;

  /// Least n·x of an element's Bézier points, a lower bound for all points of the element.
  double least_along(int element, const Vec<D>& direction) const;

  /// Bounds on the derivatives over an element from its Bézier points, those of a polynomial from their differences.
  DerivativeBounds<D> derivative_bounds(int element) const;

  /// Evaluates the face's geometry at xi with the polynomial pieces of an element. `order` 0: position, 1: also
  /// tangents, 2: also second derivatives.
  void locate(int element, const FaceCoordinates<D>& xi, int order, FaceGeometry<D>& point) const;
  /// Positions on a grid of an element, 3(p + 1) points per direction, evenly spaced from border to border: coordinate
  /// i of all points from positions[i · number of points] on, ξ¹ fastest. At most grid_points per direction.
  void sample(int element, double* positions) const;
  static constexpr int grid_points = 3 * (nurbs::max_degree + 1);
  /// Evaluates the functions at point.element, point.xi, with first derivatives if `order` is 1.
  void functions(FacePoint<D>& point, int order) const;

  /// Outward normal times the surface measure.
  Vec<D> outward(const std::array<Vec<D>, D - 1>& tangent) const { return orientation_ * normal_of<D>(tangent); }

private:
  /// Indices per direction, numbers of functions and Bézier points, and offsets into the tables.
  struct Element {
    std::array<int, D - 1> index;
    int functions, points;
    std::size_t nodes, bezier;
  };
  /// Bernstein polynomials of each direction, ∂^k in row k.
  using Bernsteins = std::array<std::array<double, 3 * (nurbs::max_degree + 1)>, D - 1>;

  Surface(const nurbs::Row& row, std::vector<int> functions, double orientation);
  int index(int element, int alpha) const { return elements_[element].index[alpha]; }
  void tabulate();
  std::array<bool, 2> open_ends(int alpha) const;
  double last_length(int alpha, bool at_end) const;
  template <int P, int Order> void bernsteins(int element, const FaceCoordinates<D>& xi, Bernsteins& out) const;
  /// Values per Bézier point.
  int width() const { return D == 2 && polynomial_ ? 2 : 4; }
  template <int W> double update_bezier();
  /// Squared distance of a Bézier point from its earlier place, both as in bezier_.
  template <int W> double moved2(const double* before, const double* now) const;
  template <int W> void bounds_with(int element, Vec<D>& lower, Vec<D>& upper) const;
  template <int P, int Order, int W>
  void locate_with(int element, const FaceCoordinates<D>& xi, FaceGeometry<D>& point) const;
  template <int P> void sample_with(int element, double* positions) const;
  template <class Run> void with_degree(int element, const Run& run) const;
  template <class Run> void with_width(const Run& run) const;
  template <int P> void weighted_functions(FacePoint<D>& point, int order) const;

  std::vector<nurbs::Space1D> spaces_;                ///< one per direction
  std::array<std::array<double, 2>, D - 1> ends_;     ///< of the face itself
  std::array<std::array<double, 2>, D - 1> beyond_{}; ///< parametric length of the extension at each end
  std::vector<int> functions_, shared_, nodes_;
  std::vector<FacePlace> places_;
  VectorX weights_;
  bool polynomial_; ///< all weights are equal: not rational
  double orientation_;
  Eigen::Matrix<double, D, Eigen::Dynamic> reference_, points_;
  std::vector<Element> elements_;
  int most_functions_ = 0;
  /// Bézier points of each element, ξ¹ fastest: x if polynomial_, otherwise (w x, w), filled up to width() values.
  std::vector<double> bezier_;
};

} // namespace signorini::contact
