#pragma once
// A scene in motion: the accepted state, the present one, and what steps share that lead from one to the other.

#include "model/active_set.hpp"
#include "model/linear_solution.hpp"
#include "model/step.hpp"
#include "model/system.hpp"

namespace signorini::model {

/// The parts are open to what takes steps: load_step.hpp (to the targets, and user-defined loops) and arc.hpp (along
/// the path). Before a step and after a roll-back the present state is the accepted one.
template <int D> struct Model {
  explicit Model(Scene<D> scene);
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;

  System<D> system;
  State<D> accepted, present;
  VectorX targets; ///< what the next step leads to, see Drives
  Way way;
  VectorX external; ///< force of the loads at the targets under way
  VectorX residual; ///< f_int + f_c − f_ext of all degrees of freedom: of the last evaluation, or of the accepted state
  VectorX unbalanced;       ///< what Newton's loop brings to zero: the same by unknown
  std::optional<Step> step; ///< since the accepted state was left
  ActiveSet<D> active_set;
  std::vector<contact::Controls> controls; ///< what the step under way asks of the contacts
  /// Where an element was inverted in the last evaluation that found one since the last roll-back.
  std::optional<BodyInversion> inversion;
  LinearSolution linear;
  Timings timings;
  std::vector<Message> scene_warnings; ///< what may be wrong with the scene
};

/// Sets what a component of a drive (index into Drives::all()) will be at the end of the next step.
template <int D> void set_target(Model<D>& model, int drive, int component, double value);
/// What it is in the accepted state.
template <int D> double accepted_target(const Model<D>& model, int drive, int component);
/// Multiplies the penalty parameters of all contacts, as they were given, from now on; a roll-back returns to the
/// accepted state's.
template <int D> void set_penalty_factor(Model<D>& model, double factor);

/// Makes the present state the accepted one. Throws Error where the step under way has not converged, or targets or
/// penalties have changed since, or where move_by() has led to no equilibrium; without a step nothing happens.
template <int D> void accept(Model<D>& model);
/// Returns to the accepted state, targets included.
template <int D> void rollback(Model<D>& model);
/// Whether the present state, its targets and penalties are the accepted ones, and no step is under way.
template <int D> bool settled(const Model<D>& model);

/// The accepted state of a model, with all that its next step depends on.
template <int D> struct Snapshot {
  State<D> state;
  Way way;
  solve::LinearKind linear; ///< see LinearSolution::beginning()
};
/// A copy of the accepted state; call it when no step is pending.
template <int D> Snapshot<D> snapshot(const Model<D>& model);
/// Returns to a state of this model that was kept before.
template <int D> void restore(Model<D>& model, const Snapshot<D>& snapshot);
/// Drops all that the way to the accepted state has left behind and that rounding may depend on later: sparse pattern,
/// linear solver, what projections start from. Afterwards the model goes on, bit by bit, as any model of the same scene
/// does that is restored to this state and settled. Call it when no step is pending.
template <int D> void settle(Model<D>& model);

/// The step from the accepted targets to others as a multiple of the last accepted one; nothing where the path bends.
template <int D> std::optional<double> straight_ratio(const Model<D>& model, const VectorX& targets);

} // namespace signorini::model
