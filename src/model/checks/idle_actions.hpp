#pragma once
// Loads and springs without effect, because supports prescribe all displacements on which they act, and free angles of
// obstacles that nothing turns.

#include "model/system/system.hpp"

namespace signorini::model {

/// Appends a warning for each of them. Body forces are exempt: they are often given for all bodies, held ones included.
template <int D> void warn_of_idle_actions(const System<D>& system, std::vector<Message>& warnings);

} // namespace signorini::model
