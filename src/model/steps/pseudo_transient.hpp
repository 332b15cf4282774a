#pragma once
// Moves of a step by pseudo-transient continuation, see solve/pseudo_time.hpp.

#include "model/steps/model.hpp"

namespace signorini::model {

/// One move in pseudo-time; `energy` becomes |f·Δu|. D is the diagonal |K_ii| of the tangent at the first move. Returns
/// false if bodies move too far (unconstrained bodies) or no damping gives an acceptable move.
template <int D> bool advance_in_pseudo_time(Model<D>& model, const StepOptions& options, double& energy);

} // namespace signorini::model
