#pragma once
// Check of the constants of a contact that a load path changes.

#include "model/scene/scene.hpp"

namespace signorini::model {

/// Throws Error if a value is invalid, if the contact has no penalty law (adhesion has only `active`), or if friction
/// or overlap change although the scene gives the contact none.
template <int D> void check_changes(const Contact<D>& contact, const contact::Changes& changes);

} // namespace signorini::model
