#pragma once
// Penalty parameters from material and mesh, for contacts whose results do not depend on them.

#include "model/scene.hpp"

namespace signorini::model {

/// The method of a contact with values in place of penalty parameters that are 0; unchanged if enforced by penalty.
template <int D> contact::Method<D> with_default_penalties(const Scene<D>& scene, const Contact<D>& contact);

} // namespace signorini::model
