#pragma once
// Tessellation of the exact geometry of bodies into points, triangles and lines, for pictures.

#include "model/results/face_values.hpp"
#include "model/results/sample.hpp"
#include "tessellation/sampling.hpp"

namespace signorini::tessellation {

using model::Field;

using Points = Eigen::Matrix<double, 3, Eigen::Dynamic>;
using Triangles = Eigen::Matrix<int, 3, Eigen::Dynamic>;

/// A line on a surface.
struct SkinLine {
  Points points, normals; ///< normals: unit normal of its surface per point; none in 2D
  double spacing;         ///< distance to the next line of its kind, through the middle of an element
};

/// Triangles of a plane body, of the six sides of a solid, or of a patch.
struct Skin {
  Points points, normals; ///< outward unit normals, one per point; none for plane bodies, whose points have z = 0
  Triangles triangles;
  VectorX values;                   ///< of the field, per point; empty without a field
  std::vector<SkinLine> mesh_lines; ///< borders between elements
  std::vector<SkinLine> rim;        ///< four sides (2D); edges of a solid, once for each of the two sides
  Points control_points;
  std::vector<std::array<int, 2>> net_lines; ///< lines of the control net within each row
};

/// Divides every element into quadrilaterals of two triangles, points row by row. Points on element borders are
/// duplicated, so that fields may be discontinuous there. `field` may be null.
Skin tessellate(const Model<2>& model, int body, const Field<2>* field, const Sampling<2>& sampling, bool deformed);

/// Triangles of the sides of the elements at the surface.
Skin tessellate(const Model<3>& model, int body, const Field<3>* field, const Sampling<3>& sampling, bool deformed);

/// A curve or surface in 2D or 3D, finer where windows need it; a curve has only points and a rim of one line. `sign`:
/// of the normals ∂x/∂ξ¹ × ∂x/∂ξ², which are zero for curves and in 2D.
Skin tessellate(const nurbs::Patch& patch, double sign = 1, const std::vector<Window>& windows = {});

/// The point in 3D coordinates; z = 0 for 2D patches.
Vec<3> place(const nurbs::Patch& patch, const VectorX& xi);

/// Number of element sides on the surface.
int surface_elements(const nurbs::Discretization& space);

/// A field on the slave faces of the body at the points of its skin: linear between the contact points of a face
/// element, constant beyond the outer ones; elsewhere() on other faces. Empty if no face of the body has it.
VectorX face_values(const Model<3>& model, model::FaceField field, int body, const Sampling<3>& sampling);

/// An element sampled at (divisions + 1)³ points, uniform in its parameters, ξ¹ fastest.
struct Inside {
  int divisions;
  Points points;
  VectorX values; ///< empty without a field
};

/// A plane that cuts a solid open in a picture.
struct CutPlane {
  Vec<3> point, normal;
};

/// The elements of a solid that may intersect at least one of the planes, because it intersects or touches the convex
/// hull of their control points. `field` may be null.
std::vector<Inside> crossed_elements(const Model<3>& model, int body, const Field<3>* field, int divisions,
                                     bool deformed, const std::vector<CutPlane>& planes);

} // namespace signorini::tessellation
