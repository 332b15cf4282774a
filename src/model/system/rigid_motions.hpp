#pragma once
// Rigid-body modes.

#include "solid/body.hpp"

namespace signorini::model {

/// Linearized rigid-body modes of control points (dimension × functions): translations along the axes, then rotations
/// about axes (2D: z) through the middle of the points; of a body of revolution the translation along its axis. Each by
/// degree of freedom, with a largest component of at most 1.
template <int D> std::vector<VectorX> rigid_motions(const MatrixX& points, solid::Kind kind);

} // namespace signorini::model
