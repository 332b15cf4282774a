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

/// Whether an error of the next correction is not removed by those after it: friction starts where the guess of the
/// step touches; and while residuals hardly fall, corrections change states, and errors grow.
template <int D> bool is_decisive(const Model<D>& model) {
  const auto& contacts = model.system.contacts;
  const std::vector<double>& residuals = model.step->report.residuals;
  const std::size_t n = residuals.size();
  if (n > 2 && residuals[n - 1] > solve::least_fall * residuals[n - 2]) return true; // without prescribed displacements
  for (std::size_t k = 0; k < contacts.size(); ++k)
    if (!model.step->foreseen && contacts[k]->friction(model.present.contacts[k]) > 0) return true;
  return false;
}

template <int D> bool advance(Model<D>& model, const StepOptions& options, double& energy) {
  ScopedTimer timer(model.timings.linear);
  if (!factor(model, options)) return false;
  VectorX step = -model.unbalanced;
  if (!solve_for(model, step, is_decisive(model))) return false;
  if (!step.allFinite()) return false;
  const double slope = model.unbalanced.dot(step);
  energy = std::abs(slope);
  Step& own = *model.step;
  VectorX& displacement = model.present.displacement;
  const bool damped = options.damping && model.system.has_unconstrained();
  own.definite = !damped && model.linear.statistics().definite &&
                 step.norm() <= small_correction * model.system.unknowns.gather(displacement).norm();
  const Unknowns<D>& unknowns = model.system.unknowns;
  if (options.newton.line_search != solve::LineSearchKind::none) {
    own.before = displacement;
    own.move = unknowns.spread(step);
    own.slope = slope;
  }
  displacement += unknowns.spread(step) + own.increment;
  own.increment.setZero();
  own.moved = true;
  own.lead = false;
  model.present.targets = model.targets;
  return true;
}

/// Whether an unconstrained body has come into contact, near the state with all points sticking.
template <int D> bool has_landed(Model<D>& model) {
  const auto& contacts = model.present.contacts;
  if (std::none_of(contacts.begin(), contacts.end(), [](const auto& one) { return resultant(one).active > 0; }))
    return false;
  const double energy = model.step->report.energies.back();
  model.step->impact = std::max(model.step->impact, energy);
  return energy < landed * model.step->impact;
}

template <int D> void end_landing(Model<D>& model) {
  for (auto& control : model.controls) control.landing = false;
  model.step->landing = false;
  model.step->moved = true;
}

template <int D> Step begin_step(Model<D>& model, const StepOptions& options) {
  const Drives<D>& drives = model.system.drives;
  Step step{drives.displacement(model.targets) - drives.displacement(model.present.targets)};
  step.foreseen = model.present.displacement != model.accepted.displacement;
  step.landing = begin_contacts(model, options.active_set, options.damping);
  set_loads(model, model.targets);
  if (guess_first(model, options.predictor, step.increment)) {
    step.increment.setZero();
    model.present.targets = model.targets;
  }
  step.pending = (step.increment.array() != 0).any();
  return step;
}

/// The residual of the conditions of a multiplier that is an unknown, a force: its gap in the springs of the penalty
/// where it is closed, its pressure where it is open.
template <int D> double violation(const Model<D>& model, const PointIndex& index) {
  const contact::Formulation<D>& contact = *model.system.contacts[index.contact];
  const int each = contact.extra_unknowns() / contact.multipliers();
  const int first = model.system.unknowns.of_contact(index.contact).extra;
  return model.residual.segment(first + each * index.point, each).norm();
}

template <int D> solve::Outcome assemble_step(Model<D>& model, bool tangent, Message& why) {
  Step& step = *model.step;
  const solve::NewtonReport& report = step.report;
  ActiveSet<D>& set = model.active_set;
  const bool first = step.pending && report.iterations == 0;
  if (!report.energies.empty()) set.thaw(report.energies.back() / report.energies.front(), model.controls);
  if (step.landing && !report.energies.empty() && has_landed(model)) end_landing(model);
  set.let_go(model.controls);
  expect_guess(model, report.iterations == 0 && model.targets != model.accepted.targets);
  solve::Outcome outcome = evaluate(model, first ? &step.increment : nullptr, tangent, why);
  expect_guess(model, false);
  if (first) model.unbalanced += model.system.unknowns.gather(model.system.assembly.product());
  if (outcome != solve::Outcome::converged || !std::exchange(step.moved, false)) return outcome;
  set.note(model.present.contacts, model.unbalanced.norm(), model.controls);
  const auto violated = [&](const PointIndex& index) { return violation(model, index); };
  if (!first && set.hold_back(model.present.contacts, violated, model.controls)) {
    outcome = evaluate(model, nullptr, tangent, why);
    if (outcome != solve::Outcome::converged) return outcome;
  }
  // With pseudo-time damping, which changes, repeated states do not imply a cycle.
  const bool repeats = step.pseudo_time.damping() == 0;
  if (const int period = repeats ? set.period() : 0; period > 0) {
    why = Message("model.step.cycling", {{"period", period}});
    return set.cycling_past_end().empty() ? solve::Outcome::cycling : solve::Outcome::lost_projection;
  }
  return outcome;
}

template <int D> solve::Trial retreat(Model<D>& model, double part) {
  model.present.displacement = model.step->before + part * model.step->move;
  model.step->moved = true;
  Message why;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (evaluate(model, nullptr, false, why) != solve::Outcome::converged) return {infinity, infinity};
  return {model.unbalanced.norm(), model.residual.dot(model.step->move)};
}

/// After convergence of the residual: ends landing, frees fixed points, or augments; converged if nothing remains
/// and no point has passed through a master.
template <int D> solve::Outcome conclude(Model<D>& model, const AugmentationOptions& limits, Message& why) {
  if (model.step->landing) {
    end_landing(model);
    return solve::Outcome::iterating;
  }
  if (model.active_set.let_go(model.controls)) {
    model.step->moved = true;
    return solve::Outcome::iterating;
  }
  if (model.active_set.release(model.controls)) {
    model.step->moved = true;
    if (!model.active_set.exhausted()) return solve::Outcome::iterating;
    why = Message("model.step.frozen_points");
    return solve::Outcome::cycling;
  }
  const auto& contacts = model.system.contacts;
  double farthest = 0;
  for (std::size_t k = 0; k < contacts.size(); ++k)
    if (contacts[k]->augmented()) farthest = std::max(farthest, contacts[k]->violation(model.present.contacts[k]));
  const double tolerance = limits.penetration * model.system.extent;
  if (farthest <= tolerance) return check_crossing(model, why);
  if (model.step->augmentations == limits.loops) {
    why =
        Message("model.step.penetration", {{"distance", farthest}, {"loops", limits.loops}, {"tolerance", tolerance}});
    return solve::Outcome::penetration;
  }
  for (std::size_t k = 0; k < contacts.size(); ++k)
    if (contacts[k]->augmented()) contacts[k]->augment(model.present.contacts[k]);
  ++model.step->augmentations;
  model.step->moved = true;
  return solve::Outcome::iterating;
}

/// Changes the outcome if set cycling is the cause of the failure.
template <int D> void classify(const ActiveSet<D>& set, solve::NewtonReport& report) {
  const bool stalls =
      report.outcome == solve::Outcome::iteration_limit || report.outcome == solve::Outcome::line_search;
  if (!stalls || set.cycling_points().empty()) return;
  report.outcome = set.cycling_past_end().empty() ? solve::Outcome::cycling : solve::Outcome::lost_projection;
  report.messages.emplace_back("model.step.changing");
}

} // namespace

template <int D> const solve::NewtonReport& iterate(Model<D>& model, const StepOptions& options) {
  if (!model.step) model.step = begin_step(model, options);
  Step& step = *model.step;
  solve::NewtonReport& report = step.report;
  if (report.outcome != solve::Outcome::iterating) return report;
  // The move that applies prescribed displacements must be a full Newton correction.
  const bool pseudo = options.pseudo_transient && !(step.pending && report.iterations == 0);
  solve::NewtonSystem newton = newton_system<D>(
      model, [&](bool tangent, Message& why) { return assemble_step(model, tangent, why); },
      [&](double& energy) {
        return pseudo ? advance_in_pseudo_time(model, options, energy) : advance(model, options, energy);
      });
  newton.retreat = [&](double part) { return retreat(model, part); };
  newton.slope = [&] { return step.slope; };
  newton.conclude = [&](Message& why) { return conclude(model, options.augmentation, why); };
  solve::NewtonOptions limits = options.newton;
  if (options.pseudo_transient) limits.iterations *= most_moves_per_iteration;
  if (!solve::iterate(newton, limits, step.pending, report)) classify(model.active_set, report);
  if (options.after_iteration) options.after_iteration();
  return report;
}

template <int D> solve::NewtonReport solve_step(Model<D>& model, const StepOptions& options) {
  model.step.reset();
  while (iterate(model, options).outcome == solve::Outcome::iterating) {
  }
  return model.step->report;
}

template <int D> solve::Outcome evaluate(Model<D>& model, Message& why) {
  if (!model.step) set_loads(model, model.targets);
  return evaluate(model, nullptr, true, why);
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
  step.moved = step.lead = true;
  step.foreseen = true; // a user's move, which may be of any kind, is not a guess
  model.present.targets = model.targets;
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template solve::NewtonReport solve_step(Model<D>&, const StepOptions&);                                              \
  template const solve::NewtonReport& iterate(Model<D>&, const StepOptions&);                                          \
  template void move_by(Model<D>&, const VectorX&);                                                                    \
  template solve::Outcome evaluate(Model<D>&, Message&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::model
