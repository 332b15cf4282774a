#pragma once
// Newton's method for a step to the targets: as a whole, one iteration at a time, or in user-defined loops.

#include "model/steps/model.hpp"

namespace signorini::model {

/// Solves for the current targets by Newton's method, starting from the present state, which is the accepted one unless
/// a step was abandoned without a roll-back. Calls `after` after each iteration, if given. Does not accept.
template <int D>
solve::NewtonReport solve_step(Model<D>& model, const StepOptions& options, const AfterIteration& after = {});
/// One iteration of solve_step(); the first one after accept(), rollback(), new targets or a new penalty factor begins
/// a step. Returns the report so far; once its outcome is not `iterating`, further calls do nothing.
template <int D>
const solve::NewtonReport& iterate(Model<D>& model, const StepOptions& options, const AfterIteration& after = {});

/// Begins a step of a model that follows another one, without solving it. `rubs`: evaluates the guess of the step,
/// whose touches are where friction begins; a step that is not extrapolated takes a solution for this, by the factors
/// of `like`, a model whose tangent was nearly the same, if given. Returns the outcome, and whether the model made
/// factors.
template <int D>
std::pair<solve::Outcome, bool> begin_following(Model<D>& model, const StepOptions& options, bool rubs, Model<D>* like,
                                                Message& why);

/// Adds a given change to the unknowns; the first move of a step also sets the prescribed displacements to their
/// targets. solve_step() and iterate() continue from there, and accept() checks equilibrium. Throws Error unless there
/// is one finite value per unknown.
template <int D> void move_by(Model<D>& model, const VectorX& change);

} // namespace signorini::model
