#pragma once
// A model: a scene with its accepted and present state, and the data that steppers share.

#include "model/steps/active_set.hpp"
#include "model/steps/linear_solution.hpp"
#include "model/steps/step.hpp"
#include "model/system/system.hpp"
#include "solid/projected_volume.hpp"

namespace signorini::model {

/// The scene of a model before its layers followed the contacts, and its parts in files.
template <int D> struct Origin {
  Scene<D> scene;
  std::vector<ScenePart> parts;
};

/// Tag of a constructor that leaves the initial state to its caller.
struct NotStarted {};

/// Members are public for the steppers: load_step.hpp (to the targets, and user-defined loops) and arc.hpp (arc
/// length). Before a step and after a roll-back the present state equals the accepted one.
template <int D> struct Model {
  explicit Model(Scene<D> scene);
  /// Constructs without evaluating the initial state or issuing warnings.
  Model(Scene<D> scene, NotStarted);
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;

  System<D> system;
  State<D> accepted, present;
  VectorX targets; ///< of the next step, see Drives
  PathHistory path;
  VectorX acting;   ///< targets at which the loads act: those of the current step
  VectorX dead;     ///< force of the dead loads there
  VectorX external; ///< force of all loads, in the last evaluation
  VectorX residual; ///< f_int + f_c − f_ext of all degrees of freedom: of the last evaluation, or of the accepted state
  VectorX unbalanced;       ///< the residual by unknown, which Newton's method reduces to zero
  std::optional<Step> step; ///< the current step; none in the accepted state
  ActiveSet<D> active_set;
  /// The last inverted element since the last roll-back.
  std::optional<BodyInversion> inversion;
  LinearSolution linear;
  /// The last step's last tangent was that of its equilibrium, up to a small correction, and had positive pivots only:
  /// the accepted state is stable.
  bool definite = false;
  Timings timings;
  /// By body, for the stress at points; what they keep does not affect results.
  mutable std::vector<solid::ProjectedVolume<D>> projected_volumes;
  std::vector<Message> scene_warnings;     ///< possible mistakes in the scene
  std::shared_ptr<const Origin<D>> origin; ///< of a model with other rows than at first, see adaptation.hpp
};

/// Sets the target of a component of a drive (index into Drives::all()) for the next step.
template <int D> void set_target(Model<D>& model, int drive, int component, double value);
/// Its value in the accepted state.
template <int D> double accepted_target(const Model<D>& model, int drive, int component);
/// Sets the factor on the given penalty parameters of all contacts; a roll-back restores the accepted state's factor.
/// Throws Error unless it is a positive number.
template <int D> void set_penalty_factor(Model<D>& model, double factor);

/// Sets the time at the end of the next step, with the accepted state's by default a step without a duration; infinite:
/// the step lasts until nothing changes any more, and the clock stays. A roll-back restores it. Throws Error if it is
/// earlier.
template <int D> void set_time(Model<D>& model, double time);

/// Changes the constants of a contact (index into Scene::contacts), from the next step on; a roll-back restores those
/// of the accepted state. Throws Error if they do not suit the contact, see changed_contact.hpp.
template <int D> void set_contact(Model<D>& model, int contact, const contact::Changes& changes);

/// Makes the present state the accepted one. Throws Error if the current step has not converged, if targets or
/// penalties have changed since, or if the state after move_by() is not in equilibrium. Does nothing without a step.
template <int D> void accept(Model<D>& model);
/// The same without any test, for a state close to equilibrium.
template <int D> void take_present(Model<D>& model);
/// Restores the accepted state, including its targets.
template <int D> void rollback(Model<D>& model);
/// True if present state, targets, penalties and constants of contacts are the accepted ones and there is no current
/// step.
template <int D> bool settled(const Model<D>& model);

/// The accepted state of a model, with all data that its next step depends on.
template <int D> struct Snapshot {
  State<D> state;
  PathHistory path;
  solve::LinearKind linear; ///< see LinearSolution::beginning()
};
/// A copy of the accepted state; no step may be pending.
template <int D> Snapshot<D> snapshot(const Model<D>& model);
/// Restores a snapshot of this model.
template <int D> void restore(Model<D>& model, const Snapshot<D>& snapshot);
/// Drops everything from past steps that affects rounding later: sparse pattern, linear solver, start values of
/// projections. Afterwards the model gives bitwise the same results as any model of the same scene that is restored to
/// this state and settled. No step may be pending.
template <int D> void settle(Model<D>& model);

} // namespace signorini::model
