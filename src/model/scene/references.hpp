#pragma once
// Check of scenes that were not made by a script.

#include "model/scene/scene.hpp"

namespace signorini::model {

/// Throws Error if a part of the scene of a file refers to a body, a face, a control point or an obstacle that it does
/// not have, or has lists of a wrong length: the checksum of a file protects against damage alone.
template <int D> void check_references(const Scene<D>& scene);

} // namespace signorini::model
