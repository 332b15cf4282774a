#pragma once
// Refuses scenes that begin with an obstacle inside a body: no contact algorithm finds out of that.

#include "model/scene.hpp"

namespace signorini::model {

/// Throws Error when a contact's slave face reaches into its obstacle by more than 1 % of the body's size, when a
/// closed obstacle lies inside the body of its slave face, or the body behind a plane. `pairs` are those of the scene's
/// contacts, evaluated in the reference configuration.
template <int D> void require_clearance(const Scene<D>& scene, const std::vector<contact::Pair<D>>& pairs);

} // namespace signorini::model
