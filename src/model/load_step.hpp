#pragma once
// A step to the targets by Newton's method, whole or one iteration at a time, and user-defined loops.

#include "model/model.hpp"

namespace signorini::model {

/// Solves for the present targets by Newton's method from the present state: the accepted one, unless a step has been
/// left without a roll-back. Does not accept.
template <int D> solve::NewtonReport solve_step(Model<D>& model, const StepOptions& options);
/// One iteration of solve_step(); the first after an accepted state, a roll-back, new targets or penalties begins a
/// step. Returns the report so far; nothing happens any more once it is not `iterating`.
template <int D> const solve::NewtonReport& iterate(Model<D>& model, const StepOptions& options);

/// Adds a given change to the unknowns; the first move of a step brings the prescribed displacements to their
/// targets with it. solve_step() and iterate() go on from there, and accept() looks whether it is in equilibrium.
/// Throws Error for another number of values than there are unknowns.
template <int D> void move_by(Model<D>& model, const VectorX& change);
/// Evaluates residual, tangent and contacts at the present state, whose displacements are those of the last move.
/// Returns converged, or why there are none.
template <int D> solve::Outcome evaluate(Model<D>& model, Message& why);

} // namespace signorini::model
