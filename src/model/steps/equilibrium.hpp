#pragma once
// Common part of all steppers: residual and tangent of the present state, Newton's linear systems, and the measure of
// equilibrium.

#include "model/steps/model.hpp"

namespace signorini::model {

/// Initial contact tolerance [theory 10.3], where otherwise rounding error would decide the states of constraints; see
/// contact::Controls::guessed and onward.
struct InitialContact {
  double tolerance = 0;
  bool onward = false;
};

struct EvaluationOptions {
  bool tangent = true; ///< besides the residual
  /// Assembly::product() becomes the full tangent times it, by degree of freedom.
  const VectorX* direction = nullptr;
  InitialContact initial = {};
  /// The tangent is that for Newton's next correction: see solid::internal_force().
  bool corrects = false;
};

/// Evaluates the present state. Returns `converged`, or on failure the outcome and its reason `why`.
template <int D> solve::Outcome evaluate(Model<D>& model, const EvaluationOptions& wanted, Message& why);
/// Sets the targets at which the loads act.
template <int D> void set_loads(Model<D>& model, const VectorX& targets);
/// Computes the residual from the present state's force and displacement.
template <int D> void take_residual(Model<D>& model);

/// The assembled tangent, for a linear solver.
template <int D> Tangent tangent_of(const Assembly<D>& assembly);

/// Norm of the contact forces at the points of the present state.
template <int D> double contact_norm(const Model<D>& model);
/// Largest norm of the forces of supports and loads, over the accepted states and the present one; where they are small
/// against it, contact_norm().
template <int D> double force_norm(const Model<D>& model);
/// |X| + |u|, the scale of rounding errors of positions.
template <int D> double largest_position(const Model<D>& model);
/// Estimated rounding error of the residual.
template <int D> double rounding_floor(const Model<D>& model);
/// True if a contact presses or pulls: with forces above their rounding error, or with pressures that strain a body by
/// more than `noticeable_strain`. Faces that only touch have neither.
template <int D> bool contact_acts(const Model<D>& model, double rounding);
/// True if the bodies are deformed, beyond the rounding error of a rigid motion, in the accepted state.
template <int D> bool is_deformed(const Model<D>& model);

/// `crossed` if points of a contact have passed through the master since the accepted state, with the contact's name in
/// `why`, otherwise `converged`. Such an equilibrium is not on the path: contact was not detected where it acts.
template <int D> solve::Outcome check_crossing(Model<D>& model, Message& why);
/// The same of sets of faces, in the state into which prescribed displacements have moved the bodies. A wall that
/// points have passed does not push them back, so that the iterations to come would not find the path again
/// [theory 5.11].
template <int D> solve::Outcome check_start(Model<D>& model, Message& why);

/// Starts the active set of a step.
template <int D> void begin_contacts(Model<D>& model, const ActiveSetOptions& options);

/// A step as a problem for Newton's method, to which steppers add evaluation and moves.
template <int D> struct StepProblem : solve::NewtonProblem {
  StepProblem(Model<D>& of, const StepOptions& with) : model(of), options(with) {}

  double residual() const override { return model.unbalanced.norm(); }
  double scale() const override { return force_norm(model); }
  double floor() const override { return rounding_floor(model); }
  solve::Outcome conclude(Message& why) override { return check_crossing(model, why); }

  /// Factors the tangent, with damping if options.damping; returns false if it is singular. `viscous`: the damping of
  /// pseudo-transient continuation has been added to it.
  bool factor(bool viscous = false);
  /// Overwrites b by K⁻¹ b; requires factor(). Returns false if the tangent is singular or the result not finite.
  /// `fully`: see solve::LinearSolver.
  bool solve(VectorX& b, bool fully = false);

  Model<D>& model;
  const StepOptions& options;
};

} // namespace signorini::model
