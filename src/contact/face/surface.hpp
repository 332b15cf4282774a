#pragma once
// Moving contact face: the NURBS face of a body, evaluated at the current control points.

#include "contact/face/bezier_element.hpp"
#include "contact/face/face_grid.hpp"
#include "contact/face/sheet_links.hpp"
#include "nurbs/discretization.hpp"

#include <limits>

namespace signorini::contact {

/// A point with the rational functions and their first derivatives, which are evaluated on request.
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

/// Elements beyond the open ends of a face, over which tractions fade [theory 5.10].
template <int D> struct Extension {
  std::array<std::array<double, 2>, D - 1> ends;      ///< parameters at the ends of the face itself
  std::array<std::array<double, 2>, D - 1> lengths{}; ///< parametric, at each end; 0: none

  /// Factor on the traction at xi: 1 on the face itself, falling to 0 at the end of the extension, with continuous
  /// first derivatives `rate` with respect to xi.
  double fade(const FaceCoordinates<D>& xi, FaceCoordinates<D>& rate) const;
};

/// What a sheet has besides its mesh.
template <int D> struct Sheet {
  double orientation; ///< 1 or −1: the sign of outward normals, as normals from its directions in order
  Extension<D> extension = {};
};

/// A face of a body, several faces with common borders as one sheet, or a set of faces, a sheet each; face-local
/// indices number its control points.
template <int D> class Surface : public FaceMesh<D> {
public:
  /// `first`: number of the body's first function; `shared`: see shared(), empty: no control points share unknowns.
  /// Throws Error unless `side` is a tensor-product face of the body (see Discretization::face).
  Surface(const nurbs::Discretization& body, nurbs::Side side, int first = 0, std::vector<int> shared = {});
  /// Several faces as one, with the numbers of their nodes.
  explicit Surface(FaceGrid grid);
  /// A patch without a body, with the outside on the right of its direction (2D), or with outward normal τ₁×τ₂ (3D).
  explicit Surface(const nurbs::Patch& patch);
  /// A set of faces that are not extended, as sheets. Borders with control points that share unknowns are linked.
  explicit Surface(const std::vector<Surface>& faces);

  /// Where each of several faces lies in the whole; empty for a single face.
  const std::vector<FacePlace>& places() const { return places_; }
  /// Control points of the face.
  int functions() const { return std::ssize(functions_); }
  /// The body's function of face-local index i, in a scene numbered through all bodies.
  int body_function(int i) const { return functions_[i]; }
  /// A number that face-local indices have in common if their control points share unknowns: at a seam, at a pole.
  int shared(int i) const { return shared_.empty() ? body_function(i) : shared_[i]; }

  /// Extends the face along its tangents beyond its open ends, by a fraction of its last elements, at most by a length
  /// in the reference configuration; to be called once, before move(). A seam, a linked border and one that is
  /// collapsed to a point, such as a pole, are not open ends.
  void extend(double part, double longest = std::numeric_limits<double>::infinity());
  const Sheet<D>& sheet_data(int sheet = 0) const { return sheets_[sheet]; }
  /// Borders of sheets that share control points.
  const SheetLinks& links() const { return links_; }

  /// Sets the current control points: reference positions plus displacement (D values per function, in the numbering of
  /// body_function()). Returns the largest distance by which a Bézier point has moved, a bound on that of any point of
  /// the face and of its extension, whose points are convex combinations of their Bézier points.
  double move(const double* displacement);
  /// Current control points, D × functions.
  const Eigen::Matrix<double, D, Eigen::Dynamic>& points() const { return points_; }
  /// Control points without displacements.
  const Eigen::Matrix<double, D, Eigen::Dynamic>& reference() const { return reference_; }

  /// The current shape of an element; a view until the next move().
  BezierElement<D> bezier(int element) const;
  /// Evaluates the face's geometry at xi with the polynomial pieces of an element. `order` 0: position, 1: also
  /// tangents, 2: also second derivatives.
  void locate(int element, const FaceCoordinates<D>& xi, int order, FaceGeometry<D>& point) const {
    point.element = element;
    contact::locate(bezier(element), xi, order, point);
  }
  /// Evaluates the functions at point.element, point.xi, with first derivatives if `order` is 1.
  void functions(FacePoint<D>& point, int order) const;

private:
  Surface(const nurbs::Row& row, std::vector<int> functions, double orientation);
  void set_mesh(std::vector<std::vector<nurbs::Space1D>> sheets);
  template <int W> double update_bezier();

  std::vector<Sheet<D>> sheets_;
  SheetLinks links_;
  std::vector<int> functions_, shared_;
  std::vector<FacePlace> places_;
  VectorX weights_;
  bool polynomial_; ///< all weights are equal: not rational
  Eigen::Matrix<double, D, Eigen::Dynamic> reference_, points_;
  std::vector<double> bezier_; ///< of each element, see BezierElement
};

/// Outward normal times the surface measure.
template <int D> Vec<D> outward(const Surface<D>& surface, const FaceGeometry<D>& point) {
  return surface.sheet_data(surface.sheet(point.element)).orientation * normal_of<D>(point.tangent);
}

/// Where a way across a border arrives: on the border of another element, at xi. element −1: nowhere.
template <int D> struct Entry {
  int element = -1, alpha = 0;
  bool at_end = false;
  FaceCoordinates<D> xi = FaceCoordinates<D>::Zero();
};
/// The way from `xi` on the border of an element at the start or end of direction α, on its sheet or across a link.
template <int D>
Entry<D> across(const Surface<D>& surface, int element, int alpha, bool at_end, const FaceCoordinates<D>& xi);
/// The links of a surface's present elements.
template <int D> SheetLinks find_links(const Surface<D>& surface);
template <int D> bool is_linked(const Surface<D>& surface, int sheet, int alpha, bool at_end);

/// True for the ends of direction α of a sheet that are open: no seam, no link, no border collapsed to one point, such
/// as a pole.
template <int D> std::array<bool, 2> open_ends(const Surface<D>& face, int alpha, int sheet = 0);

/// An element of one of the faces of a surface, by direction of that face.
template <int D> struct OwnElement {
  int face;
  std::array<int, D - 1> index;
};
/// The element of a face at an element of the surface; of an extension beyond an open end the face's last element
/// there.
template <int D> OwnElement<D> own_element(const Surface<D>& surface, int element);

/// The largest distance between the Bézier points of two shapes of a face: a bound, as in Surface::move().
template <int D> double distance_moved(const Surface<D>& before, const Surface<D>& now);

} // namespace signorini::contact
