#pragma once
// Warnings about a state that was found: what happened in it that the scene does not declare, and what its mesh and
// constants do not resolve.

#include "model/steps/model.hpp"

namespace signorini::model {

/// Warnings about the accepted state, each about one subject. Examined at the ends of stages of a path, not within
/// steps; the checks together take at most 2 % of a run's time. Without `everything` only what results tell that exist,
/// in much less time. Does not change the model's state.
template <int D> std::vector<Message> state_warnings(Model<D>& model, bool everything);

} // namespace signorini::model
