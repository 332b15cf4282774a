#pragma once
// Which linear solver suits a scene, where the user leaves the choice open.

#include "model/scene.hpp"
#include "solve/linear.hpp"

namespace signorini::model {

/// Whether only the contacts' part of the tangent changes, so that the rest is factored once: bodies that are all
/// linear elastic, a contact, and no damping of loose bodies.
template <int D> bool can_condense(const Scene<D>& scene, bool damps);

/// What a path begins with; `automatic` stands for solve::make_automatic.
template <int D> solve::LinearKind first_choice(const Scene<D>& scene, const solve::Pattern& pattern, bool damps);

} // namespace signorini::model
