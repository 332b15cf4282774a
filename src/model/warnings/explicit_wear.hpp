#pragma once
// Stability of wear that acts on the pressure of the next step.

#include "model/steps/model.hpp"

namespace signorini::model {

/// The largest k K Δs of the accepted step of a contact with explicit wear, 0 of others: k the rate of wear, Δs the
/// slip of the step, K the stiffness of the contact for pressures that vary over the shortest length. Explicit steps
/// multiply these by 1 − k K Δs: above 2 they grow and change their sign [theory 7.7].
template <int D> double explicit_wear(const Model<D>& model, int contact);

} // namespace signorini::model
