#pragma once
// Forces between the bodies of a set of faces in contact with each other.

#include "model/steps/model.hpp"

namespace signorini::model {

/// The force of the second body on the first one; numbers of bodies.
template <int D> struct PairForce {
  int first, second;
  Vec<D> force = Vec<D>::Zero();
};

/// Of all pairs of bodies that a set has. Half passes, whose two forces differ, give half of their difference.
template <int D> std::vector<PairForce<D>> set_forces(const Model<D>& model, int contact);

/// Of half passes over a set: the sum of all forces, which vanishes with the elements, relative to half the sum of
/// their magnitudes. 0 without forces.
template <int D> double set_imbalance(const Model<D>& model, int contact);

} // namespace signorini::model
