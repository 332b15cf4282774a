#include "model/gradients/neighbors.hpp"

#include "model/gradients/constants.hpp"
#include "model/gradients/kinks.hpp"
#include "model/steps/equilibrium.hpp"
#include "model/steps/load_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace signorini::model {

namespace {

/// True if points or multipliers with friction touch that did not do so in the accepted state: they slip from where the
/// guess of the step touches.
template <int D> bool begins_to_rub(const Model<D>& run) {
  for (std::size_t k = 0; k < run.system.contacts.size(); ++k) {
    const contact::History<D>&now = run.present.contacts[k], &before = run.accepted.contacts[k];
    for (std::size_t i = 0; i < now.points.size(); ++i)
      if (now.points[i].slips && !before.points[i].slips) return true;
    for (const contact::MultiplierHistory<D>& multiplier : now.multipliers)
      if ((multiplier.touch.array() != 0).any()) return true;
  }
  return false;
}

/// Displacements of a neighbor without the derivative of the state: those of the run, with its own prescribed ones.
template <int D> VectorX base(const Model<D>& run, const Model<D>& neighbor) {
  return run.present.displacement + neighbor.system.drives.displacement(neighbor.targets) -
         run.system.drives.displacement(run.targets);
}

/// Displacements of both neighbors, w ± ε w′ + ε v: the derivative w′, and an even part v, which only kinks have.
struct Rates {
  VectorX odd, even;
};

/// The residuals of the neighbors against that of the run, per ε, by unknown: their odd and even parts.
struct Defect {
  VectorX odd, even;
};

/// Corrects rates with the factors of the run while these gain digits; then with those of a neighbor's own tangent,
/// unless that is singular, as where nothing but damping holds a body; at kinks with those of both.
template <int D> class Corrector {
public:
  Corrector(Model<D>& run, const Neighbors<D>& neighbors, const StepOptions& options)
      : factored_(&run), neighbors_(neighbors), options_(options) {
    if (neighbors.factored)
      factored_ = neighbors.factored;
    else if (!run.linear.is_ready())
      renew(false);
  }

  /// True if there are better factors than those used so far. The neighbors are in the state of their last evaluation.
  bool renew(bool kinked) {
    if (std::exchange(tried_, true) && !kinked) return false;
    if (!factor(neighbors_.plus)) return false;
    factored_ = &neighbors_.plus;
    separate_ = kinked && factor(neighbors_.minus);
    return true;
  }
  /// Whether the factors in use are those of the neighbor above.
  bool is_renewed() const { return factored_ == &neighbors_.plus; }
  bool is_separate() const { return separate_; }
  /// False without factors.
  bool correct(const Defect& defect, bool kinked, Rates& rates) {
    if (separate_) {
      VectorX plus = defect.even + defect.odd, minus = defect.even - defect.odd;
      if (!solve(neighbors_.plus, plus) || !solve(neighbors_.minus, minus)) return false;
      rates.odd -= 0.5 * (plus - minus);
      rates.even -= 0.5 * (plus + minus);
      return true;
    }
    VectorX odd = defect.odd, even = defect.even;
    if (!solve(*factored_, odd) || (kinked && !solve(*factored_, even))) return false;
    rates.odd -= odd;
    if (kinked) rates.even -= even;
    return true;
  }

private:
  bool factor(Model<D>& model) {
    Message why;
    return evaluate(model, {.tangent = true}, why) == solve::Outcome::converged &&
           model.linear.factor(tangent_of(model.system.assembly), {options_.linear, false, options_.mumps});
  }
  static bool solve(Model<D>& model, VectorX& b) {
    return model.linear.is_ready() && model.linear.solve_aside(b, solution_tolerance) && b.allFinite();
  }

  Model<D>* factored_; ///< whose factors are in use
  const Neighbors<D>& neighbors_;
  const StepOptions& options_;
  bool tried_ = false, separate_ = false;
};

/// How many passes are left from a residual to `target` at the rate of the last one.
double passes_left(double before, double now, double target) {
  return now < before ? std::log(target / now) / std::log(now / before) : std::numeric_limits<double>::infinity();
}

/// Evaluates both neighbors; none, with the reason in `why`, if an element is inverted.
template <int D>
std::optional<Defect> evaluate_at(const Neighbors<D>& neighbors, const std::array<VectorX, 2>& bases,
                                  const Unknowns<D>& unknowns, const Rates& rates, const VectorX& residual,
                                  Message& why) {
  const VectorX odd = neighbors.step * unknowns.spread(rates.odd), even = neighbors.step * unknowns.spread(rates.even);
  const auto place = [&](Model<D>& model, VectorX displacement) {
    model.present.displacement = std::move(displacement);
    model.present.targets = model.targets;
    return evaluate(model, {.tangent = false}, why) == solve::Outcome::converged;
  };
  if (!place(neighbors.plus, bases[0] + even + odd) || !place(neighbors.minus, bases[1] + even - odd))
    return std::nullopt;
  const VectorX &plus = neighbors.plus.unbalanced, &minus = neighbors.minus.unbalanced;
  return Defect{(plus - minus) / (2 * neighbors.step), (0.5 * (plus + minus) - residual) / neighbors.step};
}

} // namespace

/// With unknowns w, the residual R of the run and those of the neighbors, R±, at w ± ε w′ + ε v, each pass solves
///     K x = −a,   a = (R⁺ − R⁻)/2ε,   w′ ← w′ + x,
/// K the tangent of the run's last iterate, until a no longer falls; where the neighbors are on two sides of a kink
/// also
///     K y = −b,   b = (R⁺ + R⁻ − 2 R)/2ε,   v ← v + y
/// [theory (12.2), (12.3)].
template <int D> FollowReport<D> follow_run(Model<D>& run, const Neighbors<D>& neighbors, const StepOptions& options) {
  const std::array<Model<D>*, 2> both{&neighbors.plus, &neighbors.minus};
  FollowReport<D> report;
  const bool rubs = begins_to_rub(run);
  std::array<VectorX, 2> bases;
  // The lower neighbor comes first: the upper one may need its solver for other factors later in the step.
  for (const std::size_t k : {1, 0}) {
    Model<D>* like = k == 0 && report.begun ? &neighbors.minus : neighbors.begun;
    const auto [outcome, factors] = begin_following(*both[k], options, rubs, like, report.failure);
    if (outcome != solve::Outcome::converged) {
      if (report.failure.code.empty()) report.failure = Message("model.gradients.singular");
      return report;
    }
    report.begun |= k == 1 && factors;
    bases[k] = base(run, *both[k]);
  }
  const auto at = [&](const Rates& rates) {
    return evaluate_at<D>(neighbors, bases, run.system.unknowns, rates, run.unbalanced, report.failure);
  };
  const VectorX zero = VectorX::Zero(run.system.unknowns.size());
  Rates rates{zero, zero}, best = rates;
  std::optional<Defect> defect = at(rates);
  if (!defect) return report;
  Corrector<D> corrector(run, neighbors, options);
  const double first = defect->odd.norm(), most = std::max(first, force_norm(run) / neighbors.size);
  const double good = good_derivative * most, rounded = std::max(good, rounding_floor(run) / neighbors.step);
  double least = std::numeric_limits<double>::infinity(), last = least;
  for (int slow = 0;; ++report.passes) {
    const bool kinked = defect->even.norm() > kinked_part * most;
    const double norm = std::max(defect->odd.norm(), kinked ? defect->even.norm() : 0);
    if (norm > slow_pass * least) ++slow;
    if (norm < least) {
      least = norm;
      best = rates;
    }
    if (norm <= exact_derivative * first || report.passes == most_passes) break;
    if (slow > 0 && least <= (norm < last ? good : rounded)) break;
    const bool is_long = report.passes > 0 && passes_left(last, norm, exact_derivative * first) > few_passes;
    if ((slow > 0 || is_long) && least > rounded && corrector.renew(kinked)) slow = 0;
    last = norm;
    if (slow == most_slow_passes) break;
    if (!corrector.correct(*defect, kinked, rates)) {
      report.failure = Message("model.gradients.singular");
      return report;
    }
    if (defect = at(rates); !defect) return report;
  }
  if (best.odd != rates.odd && !at(best)) return report;
  report.defect = least * neighbors.size;
  report.forces = std::max(most * neighbors.size, rounding_floor(run) / exact_derivative);
  report.renewed = corrector.is_renewed();
  report.begun = report.begun && !corrector.is_separate();
  report.kinks = find_kinks(run, neighbors);
  for (Model<D>* model : both) take_present(*model);
  return report;
}

template <int D> Message difference(const Model<D>& run, const Model<D>& neighbor) {
  const System<D>&own = run.system, &other = neighbor.system;
  if (own.unknowns.size() != other.unknowns.size() || own.unknowns.dofs() != other.unknowns.dofs())
    return Message("model.gradients.unknowns", {{"own", own.unknowns.size()}, {"other", other.unknowns.size()}});
  if (run.targets.size() != neighbor.targets.size()) return Message("model.gradients.targets");
  if (own.contacts.size() != other.contacts.size()) return Message("model.gradients.contacts");
  for (std::size_t k = 0; k < own.contacts.size(); ++k)
    if (own.contacts[k]->points().size() != other.contacts[k]->points().size())
      return Message("model.gradients.points", {{"contact", own.scene.contacts[k].name}});
  return {};
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template FollowReport<D> follow_run(Model<D>&, const Neighbors<D>&, const StepOptions&);                             \
  template Message difference(const Model<D>&, const Model<D>&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::model
