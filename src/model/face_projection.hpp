#pragma once
// Prescribed displacements as functions of X: their projection onto the control points of faces.

#include "model/scene.hpp"

namespace signorini::model {

/// The displacements of control points whose field has the least mean square difference over the reference area of the
/// faces from given values at their Gauss points (solid::face_point_positions, face after face), D × points. Fields of
/// the faces' space are reproduced. Control points at one position, as those of joined faces, move as one. Returns the
/// displacements of each face's control points in the order of Discretization::face_functions(), D × functions.
template <int D>
std::vector<MatrixX> project(const Scene<D>& scene, const std::vector<FaceReference>& faces, const MatrixX& values);

} // namespace signorini::model
