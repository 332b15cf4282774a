#pragma once
// Norm of the distance between two states of a path, independent of the mesh.

#include "model/scene/scene.hpp"
#include "model/system/unknowns.hpp"

namespace signorini::model {

/// Weights w by degree of freedom with which √(Σ w_i u_i²) is the root mean square of the displacement over the volume
/// of all bodies, ∫ |u|² dV / V, with lumped weights w = ∫ R_A dV / V for each component of control point A. The norm
/// is a length in the units of the scene, independent of the mesh. A rigid obstacle has the same weight as all bodies
/// together, an unknown that is not a displacement has no weight.
template <int D> VectorX path_weights(const Scene<D>& scene, const Unknowns<D>& unknowns);

} // namespace signorini::model
