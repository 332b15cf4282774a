#pragma once
// A scene in motion: the displacement state, one Newton step at a time, accepted or rolled back by the caller.

#include "model/active_set.hpp"
#include "model/assembly.hpp"
#include "model/damping.hpp"
#include "model/drives.hpp"
#include "model/linear_solution.hpp"
#include "model/step_options.hpp"
#include "solve/pseudo_time.hpp"

namespace signorini::model {

/// Energies of a state and what led to it. While friction slips at μ t_N and steps are small,
///   work = stored + contact + friction + what acted at the start,
/// but for ∫∫ ε_N g²/2 ȧ, since tractions act per current area.
struct Energies {
  double stored;   ///< in the bodies
  double contact;  ///< in the springs of penalty laws, in adhesion (none far away)
  double friction; ///< dissipated in all accepted steps
  double work;     ///< of supports and loads in all accepted steps, by the trapezoidal rule
};

/// The accepted state of a model, with all that its next step depends on.
template <int D> struct Snapshot {
  VectorX displacement, last_increment, targets, previous_targets;
  std::vector<typename contact::Pair<D>::History> contacts;
  double force_scale, work;
  VectorX force; ///< see Model::accepted_force_
  double penalty_factor, bend;
  solve::LinearKind automatic; ///< see LinearSolution::beginning()
};

/// The model keeps two states: the accepted one, and the present one, which equals it before a step and after a
/// roll-back.
template <int D> class Model {
public:
  /// Throws Error for a scene without bodies, a contact of a face with itself, faces that carry no tensor product, or
  /// supports that contradict each other.
  explicit Model(Scene<D> scene);
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;

  const Scene<D>& scene() const { return scene_; }
  const Unknowns<D>& unknowns() const { return unknowns_; }
  const Drives<D>& drives() const { return drives_; }
  const std::vector<contact::Pair<D>>& pairs() const { return pairs_; }
  /// What may be wrong with the scene and, of linear elastic bodies that are turned inside out, with the present state,
  /// in sentences; those about the scene come first.
  std::vector<std::string> warnings() const;

  /// What a component of a drive (index into Drives::all()) shall be at the end of the next step.
  void set_target(int drive, int component, double value);
  /// What it is in the accepted state.
  double accepted_target(int drive, int component) const;

  /// Solves for the present targets by Newton's method from the present state: the accepted one, unless a step has
  /// been left without a roll-back. Does not accept.
  solve::NewtonReport solve_step(const StepOptions& options);
  /// One iteration of solve_step(); the first after an accepted state, a roll-back, new targets or penalties begins a
  /// step.
  /// Returns the report so far; nothing happens any more once it is not `iterating`.
  const solve::NewtonReport& iterate(const StepOptions& options);
  /// Adds a change of one's own to the unknowns; the first move of a step brings the prescribed displacements to their
  /// targets with it. solve_step() and iterate() go on from there, and accept() looks whether it is in equilibrium.
  /// Throws Error for another number of values than there are unknowns.
  void move(const VectorX& change);
  /// Of the last solve_step(), iterate() or solve_arc() since the accepted state was left; null: there was none.
  const solve::NewtonReport* report() const { return step_ ? &step_->report : nullptr; }
  /// Evaluates residual, tangent and contacts at the present state, whose displacements are those of the last move.
  /// Returns converged, or why there are none.
  solve::Outcome evaluate(std::string& why);
  /// f_int + f_c − f_ext by unknown: of the last evaluation, or of the accepted state after a roll-back.
  const VectorX& unbalanced() const { return unbalanced_; }
  /// The same by degree of freedom, with the reactions.
  const VectorX& residual() const { return residual_; }
  /// Holds the tangent of the last evaluation that wanted one.
  const Assembly<D>& assembly() const { return assembly_; }
  /// Where an element was inverted in the last evaluation that found one since the last roll-back.
  const std::optional<BodyInversion>& inversion() const { return inverted_; }
  const ActiveSet<D>& active_set() const { return active_set_; }
  /// Rigid motions that no support stops.
  const std::vector<LooseMotion>& loose();

  /// Multiplies the penalty parameters of all contacts, as they were given, from now on; a roll-back returns to the
  /// accepted state's.
  void set_penalty_factor(double factor);
  double penalty_factor() const { return penalty_factor_; }

  /// Solves for a state at a given distance from the accepted one along the path that leads to the present targets, the
  /// fraction λ of the way being an unknown of its own: it may turn back, so limit points in λ can be passed. The
  /// constraint is t·(u − u₀) = length in the inner product of path_norm.hpp, t the unit tangent of the solution curve
  /// at the accepted state, in the sense of the last accepted step (pseudo-arclength: E. Riks, J. Appl. Mech. 39, 1972;
  /// H. B. Keller, 1977). Afterwards the targets are those reached. Does not accept.
  solve::NewtonReport solve_arc(const StepOptions& options, double length);
  /// λ of the last solve_arc(): 0 at the accepted state before it, 1 at its targets.
  double arc_fraction() const { return arc_fraction_; }
  /// Length of the last accepted step in the norm of path_norm.hpp, the scale for arc lengths.
  double last_length();
  /// Makes the present state the accepted one. Throws Error where the step under way has not converged, or targets or
  /// penalties have changed since, or where move() has led to no equilibrium; without a step nothing happens.
  void accept();
  /// Returns to the accepted state, targets included.
  void rollback();

  /// Whether the present state, its targets and penalties are the accepted ones, and no step is under way.
  bool settled() const;

  /// A copy of the accepted state; call it when no step is pending.
  Snapshot<D> snapshot() const;
  /// Returns to a state of this model that was kept before.
  void restore(const Snapshot<D>& snapshot);
  /// Drops all that the way to the accepted state has left behind and that rounding may depend on later: sparse
  /// pattern, linear solver, what projections start from. Afterwards the model goes on, bit by bit, as any model of the
  /// same scene does that is restored to this state and settled. Call it when no step is pending.
  void settle();

  /// Present displacement of all degrees of freedom (see Unknowns).
  const VectorX& displacement() const { return displacement_; }
  /// Displacement of all degrees of freedom in the accepted state.
  const VectorX& accepted() const { return accepted_; }
  /// Present displacement of a body's control points, D × functions.
  Eigen::Map<const Eigen::Matrix<double, D, Eigen::Dynamic>> body_displacement(int body) const;
  /// Force that a support exerts on its bodies and obstacles.
  Vec<D> reaction(int support) const;
  /// Moment that a support that rotates exerts, about its centre and conjugate to its angle in radians.
  double moment(int support) const { return drives_.moment(support, present_, residual_); }
  /// Force of a load.
  Vec<D> load_resultant(int load) const { return drives_.resultant(load, present_); }
  contact::Resultant<D> contact_resultant(int contact) const;
  /// Of the present state, with friction and work up to the accepted one.
  Energies energies() const;

  const Timings& timings() const { return timings_; }
  /// Whether to take the time of the contacts' search from now on, see contact::Pair.
  void time_search(bool wanted);
  /// Seconds that it has taken, summed over threads; part of timings().contact where there is one.
  double search_seconds() const;
  /// Patterns analysed, full assemblies.
  int patterns() const { return assembly_.pattern_version(); }
  const LinearSolution& linear() const { return linear_; }
  /// Bytes of the bodies' tables and of the tangent with its patterns; the factors are in linear().statistics().
  double memory() const;

private:
  /// A step under way.
  struct Step {
    VectorX increment; ///< prescribed displacements that wait for the first solve
    bool pending;      ///< whether there are any
    solve::NewtonReport report = {};
    bool moved = true;    ///< the state has moved since active_set_ took note of it
    bool lead = false;    ///< the last to move the state was move()
    bool landing = false; ///< bodies that only contact will hold have not settled on it yet, see Pair::land()
    double impact = 0;    ///< largest |f·Δu| since they touch
    int augmentations = 0;
    VectorX before = {}, move = {}; ///< for line search: the state before the last move, and the move
    double slope = 0;               ///< f·Δu in that state
    solve::PseudoTime pseudo_time = {};
    VectorX viscosity = {}; ///< D of pseudo-transient continuation, by unknown
    VectorX origin = {};    ///< where that began
  };

  solve::Outcome assemble(const VectorX* direction, bool tangent, std::string& why);
  bool factor(const StepOptions& options);
  bool solve_for(VectorX& b);
  void damp();
  Step begin_step(const StepOptions& options);
  std::optional<double> straight_ratio(const VectorX& step) const;
  bool begin_landing(bool damping);
  bool has_landed();
  void end_landing();
  bool predict(const VectorX& increment);
  solve::Outcome assemble_step(bool tangent, std::string& why);
  bool advance(const StepOptions& options, double& energy);
  bool advance_in_pseudo_time(const StepOptions& options, double& energy);
  solve::Trial retreat(double part);
  solve::Outcome conclude(const StepOptions& options, std::string& why);
  void classify(solve::NewtonReport& report) const;
  void judge_lead();
  bool advance_arc(const StepOptions& options, const VectorX& direction, double length, VectorX& tangent,
                   double& energy);
  solve::NewtonSystem system(std::function<solve::Outcome(bool, std::string&)> assemble,
                             std::function<bool(double&)> advance) const;
  const VectorX& path_weights();
  double force_norm() const;
  void move_targets(const VectorX& targets);
  double largest_position() const;
  double rounding_floor() const;

  Scene<D> scene_;
  Unknowns<D> unknowns_;
  Drives<D> drives_;
  Assembly<D> assembly_;
  std::vector<contact::Pair<D>> pairs_;
  std::vector<std::string> scene_warnings_;
  VectorX displacement_, accepted_, last_increment_;
  VectorX targets_, accepted_targets_; ///< see Drives
  VectorX previous_targets_;           ///< before the last accepted step
  VectorX present_;                    ///< the targets that displacement_ and external_ realise
  VectorX external_;                   ///< force of the loads
  VectorX force_;                      ///< f_int + f_c of all degrees of freedom
  VectorX residual_;                   ///< f_int + f_c − f_ext of all degrees of freedom
  VectorX unbalanced_;                 ///< what Newton's loop brings to zero: the residual by unknown
  VectorX accepted_force_;             ///< f_int + f_c in the accepted state: what supports and loads balance
  double work_ = 0;                    ///< of supports and loads up to the accepted state
  double arc_fraction_ = 0, penalty_factor_ = 1, accepted_penalty_factor_ = 1;
  double bend_ = 1; ///< relative difference of the last two steps' rates; 1 where there are none to compare
  std::optional<Step> step_;
  ActiveSet<D> active_set_;
  std::optional<BodyInversion> inverted_;
  std::optional<std::vector<LooseMotion>> loose_; ///< found when damping is first asked for
  std::optional<VectorX> path_weights_;           ///< see path_norm.hpp; found when a length is first asked for
  LinearSolution linear_;
  double force_scale_ = 0; ///< largest force norm of the accepted states
  double size_ = 0;        ///< largest coordinate of a control point or an obstacle
  double extent_ = 0;      ///< largest diameter of a body about its middle: what penetrations are measured against
  Timings timings_;
};

} // namespace signorini::model
