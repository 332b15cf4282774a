#pragma once
// Rigid motions among modes.

#include "model/stability/modes.hpp"
#include "model/stability/subspace_iteration.hpp"

namespace signorini::model {

/// Replaces modes without stiffness, `neutral` of them and given by the columns of Φ with Φᵀ M Φ = 1, by the rigid
/// motions of bodies that they contain: translations along the axes, rotations about axes through the middle of the
/// bodies that joins or ties connect, in the present position. Returns their names, by column; without a code where a
/// motion deforms bodies.
template <int D> std::vector<Message> name_rigid_modes(Model<D>& model, const Eigenproblem& problem, MatrixX& neutral);

} // namespace signorini::model
