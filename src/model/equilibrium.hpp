#pragma once
// What all steppers share: the residual and tangent of the present state, Newton's linear systems, and what counts as
// equilibrium.

#include "model/model.hpp"

namespace signorini::model {

/// Residual, and on request tangent, at the present state; the full tangent times `direction` (all degrees of freedom,
/// may be null) goes to Assembly::product(). Returns converged, or why there are none.
template <int D> solve::Outcome evaluate(Model<D>& model, const VectorX* direction, bool tangent, Message& why);
/// The residual that belongs to the present state's force.
template <int D> void take_residual(Model<D>& model);

/// Factors the tangent, damped where the options say so; false when it is singular.
template <int D> bool factor(Model<D>& model, const StepOptions& options);
/// Overwrites b by K⁻¹ b; call it after factor().
template <int D> bool solve_for(Model<D>& model, VectorX& b);

/// What Newton's loop needs, around a way to assemble and one to advance.
template <int D>
solve::NewtonSystem newton_system(Model<D>& model, std::function<solve::Outcome(bool, Message&)> assemble,
                                  std::function<bool(double&)> advance);

/// Size of the forces of the run so far: of supports and loads, in the accepted states and now.
template <int D> double force_norm(const Model<D>& model);
/// |X| + |u|: what rounding errors of positions are measured against.
template <int D> double largest_position(const Model<D>& model);
/// What rounding error leaves of the residual.
template <int D> double rounding_floor(const Model<D>& model);

/// Starts a step with the active set's rules. With damping, lets the points of contacts that hold a loose body, and do
/// not touch yet, stick where they land; returns whether there are any.
template <int D> bool begin_contacts(Model<D>& model, const ActiveSetOptions& options, bool damping);

/// Compares the residual after move_by() with the default tolerance: the step has converged, or throws Error.
template <int D> void judge_lead(Model<D>& model);

} // namespace signorini::model
