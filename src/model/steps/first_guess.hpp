#pragma once
// The first guess of a step at new targets, extrapolated from the last accepted steps.

#include "model/steps/equilibrium.hpp"

namespace signorini::model {

/// Moves the present state, which is the accepted one, to a predictor's guess with the prescribed displacements changed
/// by `prescribed`. Returns false without a change for the tangent predictor, and where an extrapolation must not be
/// used: the path turns, or the last step deviated too much from its own extrapolation.
template <int D> bool apply_predictor(Model<D>& model, Predictor predictor, const VectorX& prescribed);

/// Records an accepted step, `increment` from the accepted state to the present one, for the guesses of the next ones.
template <int D> void record_increment(Model<D>& model, const VectorX& increment);

/// Tolerance of initial contact in the first guess of a step to other targets.
template <int D> InitialContact initial_contact(const Model<D>& model);

} // namespace signorini::model
