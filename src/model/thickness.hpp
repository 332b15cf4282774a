#pragma once
// Thickness of a body behind one of its faces.

#include "base/index.hpp"
#include "model/scene.hpp"

namespace signorini::model {

/// Mean distance between a face of a body and the opposite one, along the thickness direction.
double thickness(const nurbs::Discretization& space, nurbs::Side side);
template <int D> double thickness(const Scene<D>& scene, const FaceReference& face) {
  return thickness(scene.bodies[at(face.body)].body->space(), face.side);
}

} // namespace signorini::model
