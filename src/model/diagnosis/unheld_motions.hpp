#pragma once
// Rigid-body motions of a body that neither supports nor contacts resist, for messages.

#include "model/steps/model.hpp"

namespace signorini::model {

/// The translations along the axes and the rotations about axes through the middle of a body, in its present position,
/// whose stiffness mᵀ K m in the present tangent is zero up to rounding error, as a message; empty if there are fewer
/// than two of them, which the critical direction alone describes.
template <int D> Message unheld_motions(const Model<D>& model, int body);

} // namespace signorini::model
