#pragma once
// Bodies and obstacles that contacts alone hold: whether they do.

#include "model/model.hpp"

namespace signorini::model {

/// A warning if the accepted state does not determine the position of an unconstrained body or obstacle, or is an
/// unstable equilibrium of one. The motions M that no support prevents (orthonormal columns) have compliances, the
/// eigenvalues μ of the symmetric part of Mᵀ K⁻¹ M. If all are positive, the smallest stiffness is 1/max μ, and zero up
/// to rounding error where nothing holds the body. A negative one has a motion K⁻¹ M c of negative second-order work
/// (R. Hill, J. Mech. Phys. Solids 6, 1958). Friction holds as long as it sticks, and its tangent has no potential:
/// models with friction get no warning, nor do models with a pending step. Does not change the model's state.
template <int D> std::optional<Message> weak_hold(Model<D>& model);

} // namespace signorini::model
