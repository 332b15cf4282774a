#include "model/steps/load_step.hpp"

#include "base/error.hpp"
#include "model/constants.hpp"
#include "model/steps/equilibrium.hpp"
#include "model/steps/first_guess.hpp"
#include "model/steps/pseudo_transient.hpp"
#include "os/timer.hpp"
#include "solve/constants.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace signorini::model {

namespace {

/// True if an unconstrained body or obstacle takes part in a contact.
template <int D> bool has_unconstrained(System<D>& system, const Contact<D>& contact) {
  const auto* obstacle = std::get_if<ObstacleReference>(&contact.master);
  const auto acts = [&](const UnconstrainedMotion& motion) { return acts_on(contact, motion.body); };
  const auto is_master = [&](const UnconstrainedObstacle& motion) { return motion.obstacle == obstacle->obstacle; };
  return std::ranges::any_of(system.unconstrained(), acts) ||
         (obstacle && std::ranges::any_of(system.unconstrained_obstacles(), is_master));
}

template <int D> std::optional<ClosingContacts> closing_contacts(Model<D>& model) {
  System<D>& system = model.system;
  ClosingContacts found;
  for (std::size_t k = 0; k < system.contacts.size(); ++k) {
    const contact::History<D>& history = model.present.contacts[k];
    found.contacts.push_back(system.contacts[k]->parameters().active(history.changes) &&
                             resultant(history).active == 0 && has_unconstrained(system, system.scene.contacts[k]));
  }
  if (std::ranges::none_of(found.contacts, [](char closing) { return closing; })) return std::nullopt;
  return found;
}

template <int D> Step begin_step(Model<D>& model, const StepOptions& options) {
  const Drives<D>& drives = model.system.drives;
  Step step{drives.displacement(model.targets) - drives.displacement(model.present.targets)};
  step.guess_evaluated = model.present.displacement != model.accepted.displacement;
  begin_contacts(model, options.active_set);
  if (options.damping) step.closing = closing_contacts(model);
  set_loads(model, model.targets);
  if (apply_predictor(model, options.predictor, step.increment)) {
    step.increment.setZero();
    model.present.targets = model.targets;
  }
  step.pending = (step.increment.array() != 0).any();
  return step;
}

/// The rules of the first guess of a step.
template <int D> InitialContact initial_rules(const Model<D>& model) {
  return model.step->report.iterations == 0 && model.targets != model.accepted.targets ? initial_contact(model)
                                                                                       : InitialContact{};
}

/// One iteration of a step to the targets; functions are in the order in which Newton's method calls them.
template <int D> class LoadStep final : public StepProblem<D> {
public:
  LoadStep(Model<D>& of, const StepOptions& with)
      : StepProblem<D>(of, with), step_(*of.step), waiting_(step_.pending && step_.report.iterations == 0) {}

  solve::Outcome evaluate(bool tangent, Message& why) override;
  solve::Outcome conclude(Message& why) override;
  std::optional<double> advance() override;
  /// advance() by the factors of a model with nearly the same tangent; false if these do not suffice.
  bool advance_like(Model<D>& other);
  solve::Trial retreat(double part, bool tangent) override;

private:
  using StepProblem<D>::model, StepProblem<D>::options;
  bool has_closed();
  bool is_decisive() const;
  void apply(const VectorX& move);

  Step& step_;
  const bool waiting_;    ///< for the first solution, which applies the prescribed displacements
  bool recorded_ = false; ///< by the active set
  VectorX move_;          ///< for line search: the last move
};

/// True if an unconstrained body has come into contact, near the state with all points sticking.
template <int D> bool LoadStep<D>::has_closed() {
  const auto touches = [](const auto& history) { return resultant(history).active > 0; };
  if (step_.report.energies.empty() || std::ranges::none_of(model.present.contacts, touches)) return false;
  const double energy = step_.report.energies.back();
  double& largest = step_.closing->largest_energy;
  largest = std::max(largest, energy);
  return energy < closed_energy * largest;
}

/// Reason for the end of an iteration whose states repeat.
template <int D> solve::Outcome cycle(const ActiveSet<D>& set) {
  return set.cycling_points(true).empty() ? solve::Outcome::cycling : solve::Outcome::lost_projection;
}

template <int D> solve::Outcome LoadStep<D>::evaluate(bool tangent, Message& why) {
  ActiveSet<D>& set = model.active_set;
  bool known = std::exchange(step_.evaluated, false) && !step_.moved_by_user;
  if (step_.closing && has_closed()) {
    step_.closing.reset();
    recorded_ = known = false;
  }
  if (set.update(step_.report.energies)) known = false;
  EvaluationOptions wanted{.tangent = tangent, .direction = waiting_ ? &step_.increment : nullptr, .corrects = true};
  wanted.initial = initial_rules(model);
  solve::Outcome outcome = known ? solve::Outcome::converged : model::evaluate(model, wanted, why);
  if (waiting_) model.unbalanced += model.system.unknowns.gather(model.system.assembly.product());
  if (outcome != solve::Outcome::converged || std::exchange(recorded_, true)) return outcome;
  if (set.record(model.present.contacts, model.unbalanced.norm(), waiting_)) {
    outcome = model::evaluate(model, {.tangent = tangent, .corrects = true}, why);
    if (outcome != solve::Outcome::converged) return outcome;
  }
  if (step_.pending && step_.report.iterations == 1)
    if (outcome = check_start(model, why); outcome != solve::Outcome::converged) return outcome;
  // With pseudo-time damping, which changes, repeated states do not imply a cycle.
  if (const int period = step_.pseudo_damping() == 0 ? set.period() : 0; period > 0) {
    why = Message("model.step.cycling", {{"period", period}});
    return cycle(set);
  }
  return outcome;
}

/// Ends the treatment of unconstrained bodies, or frees fixed states; converged if nothing remains and no point has
/// passed through a master.
template <int D> solve::Outcome LoadStep<D>::conclude(Message& why) {
  if (step_.closing) {
    step_.closing.reset();
    return solve::Outcome::iterating;
  }
  if (model.active_set.release_all()) {
    if (!model.active_set.exhausted()) return solve::Outcome::iterating;
    why = Message("model.step.frozen_points");
    return solve::Outcome::cycling;
  }
  return check_crossing(model, why);
}

/// True if an error of the next correction is not removed by those after it: friction starts where the guess of the
/// step touches; and while residuals hardly fall, corrections change states, and errors grow.
template <int D> bool LoadStep<D>::is_decisive() const {
  const std::vector<double>& residuals = step_.report.residuals;
  const std::size_t n = residuals.size();
  if (n > 2 && residuals[n - 1] > solve::least_fall * residuals[n - 2]) return true; // without prescribed displacements
  const bool only_obstacles = n == 2 && residuals[0] == 0; // have moved in the guess, which needed no solution
  if (step_.guess_evaluated && !only_obstacles) return false;
  const auto& contacts = model.system.contacts;
  for (std::size_t k = 0; k < contacts.size(); ++k)
    if (contacts[k]->parameters().slides(model.present.contacts[k].changes)) return true;
  return false;
}

template <int D> std::optional<double> LoadStep<D>::advance() {
  // The move that applies prescribed displacements must be a full Newton correction.
  if (options.pseudo_transient && !waiting_) return advance_in_pseudo_time(*this);
  ScopedTimer timer(model.timings.linear);
  VectorX move = -model.unbalanced;
  if (!this->factor() || !this->solve(move, is_decisive())) return std::nullopt;
  VectorX& displacement = model.present.displacement;
  const Unknowns<D>& unknowns = model.system.unknowns;
  const bool damped = options.damping && model.system.has_unconstrained();
  step_.definite = !damped && model.linear.statistics().definite &&
                   move.norm() <= small_correction * unknowns.gather(displacement).norm();
  if (options.newton.line_search != solve::LineSearchKind::none) move_ = unknowns.spread(move);
  apply(move);
  return model.unbalanced.dot(move);
}

template <int D> bool LoadStep<D>::advance_like(Model<D>& other) {
  VectorX move = -model.unbalanced;
  if (!other.linear.solve_near(tangent_of(model.system.assembly), move)) return false;
  apply(move);
  return true;
}

template <int D> void LoadStep<D>::apply(const VectorX& move) {
  model.present.displacement += model.system.unknowns.spread(move) + step_.increment;
  step_.increment.setZero();
  step_.moved_by_user = false;
  model.present.targets = model.targets;
}

template <int D> solve::Trial LoadStep<D>::retreat(double part, bool tangent) {
  model.present.displacement = step_.before + part * move_;
  Message why;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const bool valid = model::evaluate(model, {.tangent = tangent, .corrects = true}, why) == solve::Outcome::converged;
  step_.evaluated = valid && part == 1;
  if (!valid) return {infinity, infinity};
  return {model.unbalanced.norm(), model.residual.dot(move_)};
}

/// Changes the outcome if set cycling is the cause of the failure.
template <int D> void classify(const ActiveSet<D>& set, solve::NewtonReport& report) {
  const bool stalls =
      report.outcome == solve::Outcome::iteration_limit || report.outcome == solve::Outcome::line_search;
  if (!stalls || set.cycling_points().empty()) return;
  report.outcome = cycle(set);
  report.messages.emplace_back("model.step.changing");
}

} // namespace

template <int D>
const solve::NewtonReport& iterate(Model<D>& model, const StepOptions& options, const AfterIteration& after) {
  if (!model.step) model.step = begin_step(model, options);
  solve::NewtonReport& report = model.step->report;
  if (report.outcome != solve::Outcome::iterating) return report;
  solve::NewtonOptions limits = options.newton;
  if (options.pseudo_transient)
    limits.iterations *= most_moves_per_iteration;
  else if (model.active_set.shrinks())
    limits.iterations *= most_extension;
  LoadStep<D> problem(model, options);
  if (!solve::iterate(problem, limits, model.step->pending, report)) classify(model.active_set, report);
  if (after) after();
  return report;
}

template <int D>
solve::NewtonReport solve_step(Model<D>& model, const StepOptions& options, const AfterIteration& after) {
  model.step.reset();
  while (iterate(model, options, after).outcome == solve::Outcome::iterating) {
  }
  return model.step->report;
}

template <int D>
std::pair<solve::Outcome, bool> begin_following(Model<D>& model, const StepOptions& options, bool rubs, Model<D>* like,
                                                Message& why) {
  model.step = begin_step(model, options);
  Step& step = *model.step;
  solve::Outcome outcome = solve::Outcome::converged;
  bool factors = false;
  if (rubs) {
    LoadStep<D> problem(model, options);
    if (step.pending) {
      outcome = problem.evaluate(true, why);
      if (outcome == solve::Outcome::converged && !(like && problem.advance_like(*like))) {
        factors = problem.advance().has_value();
        if (!factors) outcome = solve::Outcome::singular_tangent;
      }
      ++step.report.iterations;
    }
    if (outcome == solve::Outcome::converged)
      outcome = model::evaluate(model, {.tangent = false, .initial = initial_rules(model)}, why);
  }
  step.increment.setZero();
  step.closing.reset();
  step.guess_evaluated = true;
  model.active_set.release_all();
  return {outcome, factors};
}

template <int D> void move_by(Model<D>& model, const VectorX& change) {
  const Unknowns<D>& unknowns = model.system.unknowns;
  require(change.size() == unknowns.size(), "model.move.size",
          {{"expected", unknowns.size()}, {"count", change.size()}});
  require(change.allFinite(), "model.move.finite");
  if (!model.step || model.step->report.outcome != solve::Outcome::iterating) model.step = begin_step(model, {});
  Step& step = *model.step;
  model.present.displacement += unknowns.spread(change) + step.increment;
  step.increment.setZero();
  step.pending = false;
  step.moved_by_user = true;
  step.guess_evaluated = true; // a user's move, which may be of any kind, is not a guess
  model.present.targets = model.targets;
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template solve::NewtonReport solve_step(Model<D>&, const StepOptions&, const AfterIteration&);                       \
  template const solve::NewtonReport& iterate(Model<D>&, const StepOptions&, const AfterIteration&);                   \
  template std::pair<solve::Outcome, bool> begin_following(Model<D>&, const StepOptions&, bool, Model<D>*, Message&);  \
  template void move_by(Model<D>&, const VectorX&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::model
