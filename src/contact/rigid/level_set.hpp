#pragma once
// Level sets as rigid obstacles: the surface f = 0 of a formula f of the coordinates, which is positive outside.

#include "contact/face/surface.hpp"
#include "symbolic/archive.hpp"
#include "symbolic/tape.hpp"

#include <memory>
#include <string>

namespace signorini::contact {

/// f and its first and second derivatives at a point.
template <int D> struct LevelValue {
  double value;
  Vec<D> gradient;
  Mat<D> second;
};

/// The part of a level set in its box: points on it, and segments (2D) or triangles (3D) of them that have f < 0 on
/// their left (2D) or whose normals point to f > 0 (3D).
template <int D> struct LevelMesh {
  Eigen::Matrix<double, D, Eigen::Dynamic> points;
  std::vector<std::array<int, D>> simplices;
  double spacing; ///< of the lattice on which the points were found
};

template <int D> struct CompiledLevelSet {
  symbolic::Formula formula; ///< of x, y[, z]
  Vec<D> low, high;          ///< corners of the box
  symbolic::Tape tape;       ///< f, its gradient, and its second derivatives for i ≤ j row by row
  LevelMesh<D> mesh;
  std::vector<int> sorted; ///< points of the mesh by their first coordinate

  LevelValue<D> operator()(const Vec<D>& x) const;
};

/// Copies share what does not change.
template <int D> struct LevelSet { std::shared_ptr<const CompiledLevelSet<D>> compiled; };

/// "x", "y"[, "z"].
template <int D> std::vector<std::string> level_set_variables();

/// Throws Error unless f is finite in the box, zero somewhere in it, and continuous with a gradient there.
template <int D> LevelSet<D> make_level_set(symbolic::Formula formula, const Vec<D>& low, const Vec<D>& high);

/// Points and pieces of the level set on a lattice of cells of equal size, divided into simplices (marching tetrahedra;
/// A. Doi, A. Koide, IEICE Trans. E74, 1991); errors as above.
template <int D> LevelMesh<D> march(const CompiledLevelSet<D>& f);

/// Coordinates of the closest point to x, without the obstacle's translation, in point.xi, point.last; point.settled
/// is true if the search converged. It starts at the nearest point of the mesh.
template <int D> void find_closest(const LevelSet<D>& level_set, const Vec<D>& x, FaceGeometry<D>& point);
/// Position, tangents of unit length and second derivatives at these coordinates, those of the surface over its tangent
/// plane, see obstacle.hpp.
template <int D> void locate(const LevelSet<D>& level_set, FaceGeometry<D>& point);
/// See obstacle.hpp: on the projection of the chord.
template <int D>
MasterPoint<D> advance_slip(const LevelSet<D>& level_set, const MasterPoint<D>& slip, const FaceGeometry<D>& foot,
                            double length);

} // namespace signorini::contact
