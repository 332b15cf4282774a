#pragma once
// Coloured areas cut to a box.

#include "view/drawing.hpp"
#include "view/strokes.hpp"

namespace signorini::view {

/// The part of a field inside the box; values at the cuts are interpolated as the renderer does.
Field clip_field(const Field& field, const Box& box);

} // namespace signorini::view
