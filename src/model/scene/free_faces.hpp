#pragma once
// Faces of bodies that may be in contact.

#include "model/scene/scene.hpp"

namespace signorini::model {

/// True for a face that collapses to a point, in 3D also to a line: the scatter of its control points has too few
/// directions.
template <int D> bool is_collapsed(const Scene<D>& scene, const FaceReference& face);

/// The faces of all bodies on their outside: those that do not collapse, are neither joined nor tied, as a whole or in
/// part, nor the seam of a closed body, nor on the axis of an axisymmetric scene.
template <int D> Faces free_faces(const Scene<D>& scene);

/// The contact of a set of faces with an obstacle, with the name of the support that moves it.
template <int D> Contact<D> with_obstacle(const Scene<D>& scene, Contact<D> set, int obstacle);

} // namespace signorini::model
