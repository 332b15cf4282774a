#pragma once
// How far apart two states of a model are along its path, whatever the mesh.

#include "model/scene.hpp"
#include "model/unknowns.hpp"

namespace signorini::model {

/// Weights w by degree of freedom with which √(Σ w_i u_i²) is the root mean square of the displacement over the volume
/// of all bodies, ∫ |u|² dV / V, with lumped shares: w = ∫ R_A dV / V for each component of control point A. It is a
/// length, in the units of the scene, and the same for any mesh. A rigid obstacle counts like all bodies together.
template <int D> VectorX path_weights(const Scene<D>& scene, const Unknowns<D>& unknowns);

} // namespace signorini::model
