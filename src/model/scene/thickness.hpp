#pragma once
// Thickness of a body behind one of its faces.

#include "model/scene/scene.hpp"

#include <limits>

namespace signorini::model {

/// Mean distance between a face of a body and the opposite one, along the thickness direction.
double thickness(const nurbs::Discretization& space, nurbs::Side side);
template <int D> double thickness(const Scene<D>& scene, const FaceReference& face) {
  return thickness(scene.bodies[face.body].body->space(), face.side);
}

/// The least of several faces.
template <int D> double thickness(const Scene<D>& scene, const Faces& faces) {
  double least = std::numeric_limits<double>::infinity();
  for (const FaceReference& face : faces) least = std::min(least, thickness(scene, face));
  return least;
}

/// Thickness of the thinner body of a contact.
template <int D> double thinner_body(const Scene<D>& scene, const Contact<D>& contact) {
  const double slave = thickness(scene, contact.slave);
  const auto* master = std::get_if<Faces>(&contact.master);
  return master ? std::min(slave, thickness(scene, *master)) : slave;
}

/// E/h behind a face, h the thickness of the elements there.
template <int D> double element_stiffness(const Scene<D>& scene, const FaceReference& face) {
  const solid::Body<D>& body = *scene.bodies[face.body].body;
  return body.material().constants().youngs_modulus /
         (thickness(scene, face) / body.space().elements(face.side.direction));
}

} // namespace signorini::model
