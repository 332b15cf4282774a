#pragma once
// Reports of Newton iterations as they come, for verbose = true (lua/signorini/run/verbose.lua prints them).

#include "bind/model/model.hpp"
#include "model/steps/step_options.hpp"

namespace signorini::bind {

/// A function that prints the last iteration of the model: its residual, the correction, contact states, and what
/// changed since its last call, or since it was made. `goal`: tolerance of the residual.
template <int D> model::AfterIteration iteration_printer(lua_State* L, const model::Model<D>& model, double goal);

} // namespace signorini::bind
