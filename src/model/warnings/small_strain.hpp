#pragma once
// Linear elastic bodies beyond small rotations and strains.

#include "model/steps/model.hpp"

namespace signorini::model {

/// Appends a warning for each linear elastic body of which an element is turned or strained, in the mean over its
/// volume, by more than constants.hpp allows: Hooke's law takes a rotation by an angle θ for a strain cos θ − 1.
/// Rotation and principal stretches are those of the polar decomposition F = R U of the mean deformation gradient.
template <int D> void warn_of_large_strains(const Model<D>& model, std::vector<Message>& warnings);

} // namespace signorini::model
