#pragma once
// Common part of all steppers: residual and tangent of the present state, Newton's linear systems, and the measure of
// equilibrium.

#include "model/steps/model.hpp"

namespace signorini::model {

/// Evaluates the residual, and on request the tangent, of the present state; Assembly::product() becomes the full
/// tangent times `direction` (all degrees of freedom, may be null). Returns `converged`, or on failure the outcome and
/// its reason `why`.
template <int D> solve::Outcome evaluate(Model<D>& model, const VectorX* direction, bool tangent, Message& why);
/// Sets the targets at which the loads act.
template <int D> void set_loads(Model<D>& model, const VectorX& targets);
/// Computes the residual from the present state's force and displacement.
template <int D> void take_residual(Model<D>& model);

/// The assembled tangent, for a linear solver.
template <int D> Tangent tangent_of(const Assembly<D>& assembly);
/// Factors the tangent, with damping if options.damping; returns false if it is singular.
template <int D> bool factor(Model<D>& model, const StepOptions& options);
/// Overwrites b by K⁻¹ b; requires factor(). Returns false if the tangent is singular. `fully`: see LinearSolution.
template <int D> bool solve_for(Model<D>& model, VectorX& b, bool fully = false);

/// `crossed` if points of a contact have passed through the master since the accepted state, with the contact's name in
/// `why`, otherwise `converged`. Such an equilibrium is not on the path: contact was not detected where it acts.
template <int D> solve::Outcome check_crossing(Model<D>& model, Message& why);

/// The interface that Newton's loop needs, with given functions `assemble` and `advance`.
template <int D>
solve::NewtonSystem newton_system(Model<D>& model, std::function<solve::Outcome(bool, Message&)> assemble,
                                  std::function<bool(double&)> advance);

/// Norm of the contact forces at the points of the present state.
template <int D> double contact_norm(const Model<D>& model);
/// Largest norm of the forces of supports and loads, over the accepted states and the present one; where they are small
/// against it, contact_norm().
template <int D> double force_norm(const Model<D>& model);
/// |X| + |u|, the scale of rounding errors of positions.
template <int D> double largest_position(const Model<D>& model);
/// Estimated rounding error of the residual.
template <int D> double rounding_floor(const Model<D>& model);
/// Whether a contact presses or pulls: with forces above their rounding error, or with pressures that strain a body by
/// more than 1e-9. Faces that only touch have neither.
template <int D> bool contact_acts(const Model<D>& model, double rounding);
/// Whether the bodies are deformed, beyond the rounding error of a rigid motion, in the accepted state.
template <int D> bool is_deformed(const Model<D>& model);

/// Starts the active set of a step. With damping, sets Controls::landing of open contacts of unconstrained bodies;
/// returns whether there are any.
template <int D> bool begin_contacts(Model<D>& model, const ActiveSetOptions& options, bool damping);

/// Marks a step of move_by() as converged if the residual is below the default tolerance, otherwise throws Error.
template <int D> void judge_lead(Model<D>& model);

} // namespace signorini::model
