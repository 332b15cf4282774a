#pragma once
// What a scene must satisfy, in the order of the checks.

#include "model/scene/scene.hpp"

namespace signorini::model {

/// Completes a scene by pairs of control points of joins whose faces match, ties in place of other joins, and default
/// penalties, and returns it. Throws Error if its parts contradict each other. After that only geometry can be wrong:
/// joined faces that do not face each other (resolve_joins()), tied ones that are apart (make_ties()), and initial
/// penetration (check_clearance()).
template <int D> const Scene<D>& complete(Scene<D>& scene);

} // namespace signorini::model
