#pragma once
// Motions of a body as a whole.

#include "solid/body.hpp"

namespace signorini::model {

/// Translations along the axes, then rotations about them (in the plane about z) around the middle of the control
/// points (dimension × functions); of a body of revolution the translation along its axis. Each by degree of freedom,
/// one unit of length at most.
template <int D> std::vector<VectorX> rigid_motions(const MatrixX& points, solid::Kind kind);

} // namespace signorini::model
