#pragma once
// Prescribed displacements as functions of X: their projection onto the control points of faces.

#include "model/scene/scene.hpp"

namespace signorini::model {

struct Projection {
  std::vector<MatrixX> displacements; ///< of each face's control points
  double error;                       ///< root mean square of the difference, relative to that of the values
};

/// The displacements of control points whose field has the least mean square difference over the reference area of the
/// faces from given values at their Gauss points (solid::load_points, face after face), D × points. Fields of
/// the faces' space are reproduced. Control points at one position, as those of joined faces, move as one. Returns the
/// displacements of each face's control points in the order of Discretization::face_functions(), D × functions.
template <int D>
Projection project(const Scene<D>& scene, const std::vector<FaceReference>& faces, const MatrixX& values);

} // namespace signorini::model
