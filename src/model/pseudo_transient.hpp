#pragma once
// How a step moves by pseudo-transient continuation, see solve/pseudo_time.hpp.

#include "model/model.hpp"

namespace signorini::model {

/// One move in pseudo-time, with |f·Δu| in `energy`. D is the diagonal of the tangent at the first of them, |K_ii|.
/// Returns false where bodies move on and on, since nothing holds them.
template <int D> bool advance_in_pseudo_time(Model<D>& model, const StepOptions& options, double& energy);

} // namespace signorini::model
