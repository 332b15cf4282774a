#pragma once
// Contacts whose penalty springs, rather than the bodies, take up the motion of their faces.

#include "model/steps/model.hpp"

namespace signorini::model {

/// Appends a warning for each contact whose penetration is a noticeable part of its approach, and for each one whose
/// elastic slip is. The approach of two linear bodies is δ = 2 (W + U)/F with their strain energy W, the energy of the
/// normal springs U = ½ ∫ p |g| da and the force F = ∫ p da; the mean penetration is 2 U/F. In mortar contact g is the
/// weighted gap, which vanishes with multipliers as unknowns; what |g| exceeds it by at the points, in the mean with
/// the weights p da, is a warning, too, where it is a noticeable part of δ. And so is an overlap of faces with
/// adhesion.
template <int D> void warn_of_soft_penalties(const Model<D>& model, std::vector<Message>& warnings);

} // namespace signorini::model
