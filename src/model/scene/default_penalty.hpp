#pragma once
// Penalty parameters from material and mesh.

#include "model/scene/scene.hpp"

namespace signorini::model {

/// E/h at a contact: Young's modulus of the softer body over the size of the slave's elements.
template <int D> double contact_stiffness(const Scene<D>& scene, const Contact<D>& contact);

/// The penalty by default of a contact that is enforced by it alone [theory 5.6]. In bodies thinner than the slave's
/// elements are long E/h falls below the stiffness E/H of the thickness H, which it must exceed as well. Half passes
/// have that of the coarser face: the forces of both are equal only if their penalties are.
template <int D> double default_penalty(const Scene<D>& scene, const Contact<D>& contact);

/// Sets the penalty parameters that are 0, the stiffness of bonds that is 0, and the scales
/// of multipliers; chooses their functions where these are automatic.
template <int D> void set_default_penalties(Scene<D>& scene);

} // namespace signorini::model
