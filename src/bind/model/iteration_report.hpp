#pragma once
// Reports of Newton iterations as they come, for verbose = true (lua/signorini/run/verbose.lua prints them).

#include "bind/model/model.hpp"

#include <functional>

namespace signorini::bind {

/// A function for StepOptions::after_iteration that prints the last iteration of a model: its residual, the correction,
/// contact states and what changed since this call or since the iteration before. `goal`: tolerance of the residual.
template <int D> std::function<void()> report_iterations(lua_State* L, const model::Model<D>& model, double goal);

} // namespace signorini::bind
