#pragma once
// Penalty parameters from material and mesh, for contacts whose results do not depend on them.

#include "model/scene.hpp"

namespace signorini::model {

/// Sets the penalty parameters that are 0, of contacts that are not enforced by penalty, and the scales of multipliers.
template <int D> void set_default_penalties(Scene<D>& scene);

} // namespace signorini::model
