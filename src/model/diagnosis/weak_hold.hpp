#pragma once
// Bodies and obstacles that contacts alone hold: whether they do.

#include "model/steps/model.hpp"

namespace signorini::model {

/// A warning if the accepted state does not determine the position of an unconstrained body or obstacle. The motions M
/// that no support prevents (orthonormal columns) have compliances, the eigenvalues μ of the symmetric part of
/// Mᵀ K⁻¹ M: the smallest stiffness is 1/max |μ|, and zero up to rounding error where nothing holds the body. Friction
/// holds as long as it sticks: models with friction get no warning, nor do models with a pending step. Does not change
/// the model's state.
template <int D> std::optional<Message> weak_hold(Model<D>& model);

} // namespace signorini::model
