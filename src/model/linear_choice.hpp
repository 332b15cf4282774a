#pragma once
// Which linear solver suits a scene, where the user leaves the choice open.

#include "model/scene.hpp"
#include "solve/linear.hpp"

namespace signorini::model {

/// Whether the tangent is symmetric: all but the penalty law, whose traction acts on the current area, have a
/// potential.
template <int D> bool has_potential(const Scene<D>& scene);

/// What a path without damping of loose bodies begins with; `automatic` stands for solve::make_automatic.
template <int D> solve::LinearKind first_choice(const Scene<D>& scene, const solve::Pattern& pattern);

} // namespace signorini::model
