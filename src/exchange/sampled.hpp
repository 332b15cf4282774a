#pragma once
// Rational Bézier cells evaluated at points.

#include "exchange/vtu.hpp"

namespace signorini::exchange {

/// The values of points and arrays at equidistant points of each cell, subdivisions + 1 in each direction, in place of
/// control points: in each cell ξ¹ fastest.
BezierGrid sampled(const BezierGrid& grid, int subdivisions);

} // namespace signorini::exchange
