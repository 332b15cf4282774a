#pragma once
// Bodies as points, triangles and lines over their true curved geometry, for pictures.

#include "model/sample.hpp"
#include "tessellation/sampling.hpp"

namespace signorini::tessellation {

using model::Field;

using Points = Eigen::Matrix<double, 3, Eigen::Dynamic>;
using Triangles = Eigen::Matrix<int, 3, Eigen::Dynamic>;

/// A line on a surface.
struct SkinLine {
  Points points, normals; ///< one unit normal of the surface that it belongs to per point; none in the plane
  double spacing;         ///< distance to the next line of its kind, through the middle of an element
};

/// A plane body, the six sides of a solid, or a patch as triangles.
struct Skin {
  Points points, normals; ///< outward unit normals, one per point; none of plane bodies, whose points have z = 0
  Triangles triangles;
  VectorX values;                   ///< of the field, per point; empty without a field
  std::vector<SkinLine> mesh_lines; ///< borders between elements
  std::vector<SkinLine> rim;        ///< in the plane four sides; of a solid's sides, once for each of two that meet
  Points control_points;
  std::vector<std::array<int, 2>> net_lines; ///< control points joined within every row
};

/// Cuts every element into quadrilaterals of two triangles, points row by row. Points on element borders are doubled,
/// so that fields may jump there. `field` may be null.
Skin tessellate(const Model<2>& model, int body, const Field<2>* field, const Sampling<2>& sampling, bool deformed);

/// Cuts the sides of the elements at the surface as the plane tessellation does.
Skin tessellate(const Model<3>& model, int body, const Field<3>* field, const Sampling<3>& sampling, bool deformed);

/// A curve or a surface in 2D or 3D, finer where windows need it; a curve has points and a rim of one line alone.
/// `sign`: of the normals ∂x/∂ξ¹ × ∂x/∂ξ², which are zero for curves and in the plane.
Skin tessellate(const nurbs::Patch& patch, double sign = 1, const std::vector<Window>& windows = {});

/// The point in space, z = 0 for those of the plane.
Vec<3> place(const nurbs::Patch& patch, const VectorX& xi);

/// Elements that have a side on the surface, once per side.
int surface_elements(const nurbs::Discretization& space);

/// The pressure of the contacts in which faces of the body are slaves, at the points of its skin: between a face
/// element's contact points linear, beyond the outer ones constant; 0 elsewhere. Empty when no face of the body is
/// slave.
VectorX contact_pressure(const Model<3>& model, int body, const Sampling<3>& sampling);

/// An element sampled at (divisions + 1)³ points evenly spread over its parameters, ξ¹ running fastest.
struct Inside {
  int divisions;
  Points points;
  VectorX values; ///< empty without a field
};

/// A plane in space.
struct CutPlane {
  Vec<3> point, normal;
};

/// The elements of a solid that one of the planes at least may meet: it crosses or touches the hull of their control
/// points. `field` may be null.
std::vector<Inside> crossed_elements(const Model<3>& model, int body, const Field<3>* field, int divisions,
                                     bool deformed, const std::vector<CutPlane>& planes);

} // namespace signorini::tessellation
