#pragma once
// Moves of a step by pseudo-transient continuation, see solve/pseudo_time.hpp.

#include "model/steps/equilibrium.hpp"

namespace signorini::model {

/// One move in pseudo-time. D is the diagonal |K_ii| of the tangent at the first move. Returns f·Δu; nothing if bodies
/// move too far (unconstrained bodies) or no damping gives an acceptable move.
template <int D> std::optional<double> advance_in_pseudo_time(StepProblem<D>& problem);

} // namespace signorini::model
