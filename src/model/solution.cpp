// How a model's steps are solved by iteration at prescribed targets.
#include "model/model.hpp"

#include "base/error.hpp"
#include "base/timer.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace signorini::model {

namespace {

constexpr double rounding = 1e-12; ///< parts of the largest position: gaps nearer to 0 are what rounding makes of 0

} // namespace

template <int D> bool Model<D>::factor(const StepOptions& options) {
  ScopedTimer timer(timings_.factorisation);
  if (options.damping) damp();
  const Tangent tangent{assembly_.values(),          assembly_.pattern(),          assembly_.pattern_version(),
                        assembly_.constant_values(), assembly_.contact_unknowns(), assembly_.contact_version()};
  return linear_.factor(tangent, {options.linear, options.damping && !loose().empty()});
}

/// Overwrites b by K⁻¹ b; call it after factor().
template <int D> bool Model<D>::solve_for(VectorX& b) {
  ScopedTimer timer(timings_.solution);
  return linear_.solve(b);
}

template <int D> const std::vector<LooseMotion>& Model<D>::loose() {
  if (!loose_) loose_ = loose_motions(scene_, unknowns_);
  return *loose_;
}

/// Adds to the tangent what keeps loose bodies from flying off.
template <int D> void Model<D>::damp() {
  if (loose().empty()) return;
  constexpr double small = 1e-3;
  assembly_.add_diagonal(
      damping(scene_, unknowns_, loose(), assembly_.diagonal(), residual_, strides(scene_, pairs_, small * extent_)));
}

template <int D> bool Model<D>::advance(const StepOptions& options, double& energy) {
  ScopedTimer timer(timings_.linear);
  if (!factor(options)) return false;
  VectorX step = -unbalanced_;
  if (!solve_for(step)) return false;
  if (!step.allFinite()) return false;
  const double slope = unbalanced_.dot(step);
  energy = std::abs(slope);
  if (options.newton.line_search != solve::LineSearchKind::none) {
    step_->before = displacement_;
    step_->move = unknowns_.spread(step);
    step_->slope = slope;
  }
  displacement_ += unknowns_.spread(step) + step_->increment;
  step_->increment.setZero();
  step_->moved = true;
  step_->lead = false;
  present_ = targets_;
  return true;
}

/// What Newton's loop needs, around a way to assemble and one to advance.
template <int D>
solve::NewtonSystem Model<D>::system(std::function<solve::Outcome(bool, std::string&)> assemble,
                                     std::function<bool(double&)> advance) const {
  solve::NewtonSystem system;
  system.assemble = std::move(assemble);
  system.advance = std::move(advance);
  system.residual = [this] { return unbalanced_.norm(); };
  system.scale = [this] { return force_norm(); };
  system.floor = [this] { return rounding_floor(); };
  return system;
}

/// Size of the forces of the run so far: of supports and loads, in the accepted states and now.
template <int D> double Model<D>::force_norm() const {
  return std::max({force_scale_, unknowns_.held_norm(residual_), external_.norm()});
}

/// |X| + |u|: what rounding errors of positions are measured against.
template <int D> double Model<D>::largest_position() const {
  return size_ + displacement_.template lpNorm<Eigen::Infinity>();
}

/// What rounding error leaves of the residual: ε |K| (|X| + |u|), in space four times as much, where a row adds up some
/// ten times as many products. Rows err independently of each other: |K| is the 2-norm of the diagonal. Gaps are
/// differences of positions, wrong by ε (|X| + |u|) each, and contact multiplies them by its own stiffness.
template <int D> double Model<D>::rounding_floor() const {
  double stiffness = assembly_.diagonal_norm();
  for (const auto& pair : pairs_) stiffness = std::max(stiffness, pair.stiffness());
  return (D == 2 ? 1 : 4) * std::numeric_limits<double>::epsilon() * stiffness * largest_position();
}

/// Whether the state could be moved on to the targets as the last step went: where the path goes straight on, and the
/// last two steps went alike.
template <int D> bool Model<D>::predict(const VectorX& increment) {
  // Measured on ironing and Hertz: 0.1 to 0.5 make no difference; with 1 steps fail where bodies have just touched
  // first.
  constexpr double most_bent = 0.3;
  if (bend_ > most_bent || present_ != accepted_targets_) return false;
  const std::optional<double> ratio = straight_ratio(targets_ - accepted_targets_);
  if (!ratio) return false;
  // Free ones by as much as in the last step, prescribed ones exactly
  const VectorX prescribed = drives_.displacement(accepted_targets_) - drives_.displacement(previous_targets_);
  displacement_ += *ratio * (last_increment_ - prescribed) + increment;
  return true;
}

/// With damping, lets the points of contacts that hold a loose body, and do not touch yet, stick where they land.
/// Returns whether there are any.
template <int D> bool Model<D>::begin_landing(bool damping) {
  bool any = false;
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    const auto* face = std::get_if<FaceReference>(&scene_.contacts[k].master);
    const bool falls = damping && pairs_[k].resultant().active == 0 &&
                       std::any_of(loose().begin(), loose().end(), [&](const LooseMotion& motion) {
                         return motion.body == scene_.contacts[k].slave.body || (face && motion.body == face->body);
                       });
    pairs_[k].land(falls);
    any = any || falls;
  }
  return any;
}

/// Whether contact has brought the fall to an end, near the state where all points stick.
template <int D> bool Model<D>::has_landed() {
  if (std::none_of(pairs_.begin(), pairs_.end(), [](const auto& pair) { return pair.resultant().active > 0; }))
    return false;
  constexpr double near = 1e-2; // part of the largest |f·Δu|
  const double energy = step_->report.energies.back();
  step_->impact = std::max(step_->impact, energy);
  return energy < near * step_->impact;
}

template <int D> void Model<D>::end_landing() {
  for (auto& pair : pairs_) pair.land(false);
  step_->landing = false;
  step_->moved = true;
}

template <int D> typename Model<D>::Step Model<D>::begin_step(const StepOptions& options) {
  Step step{drives_.displacement(targets_) - drives_.displacement(present_), false};
  active_set_.begin(pairs_, options.active_set);
  step.landing = begin_landing(options.damping);
  external_ = drives_.force(targets_);
  const bool constant = options.predictor == Predictor::constant;
  if (constant) displacement_ += step.increment;
  if (constant || (options.predictor == Predictor::linear && predict(step.increment))) {
    step.increment.setZero();
    present_ = targets_;
  }
  step.pending = (step.increment.array() != 0).any();
  return step;
}

template <int D> solve::Outcome Model<D>::assemble_step(bool tangent, std::string& why) {
  const solve::NewtonReport& report = step_->report;
  const bool first = step_->pending && report.iterations == 0;
  if (!report.energies.empty()) active_set_.thaw(pairs_, report.energies.back() / report.energies.front());
  if (step_->landing && !report.energies.empty() && has_landed()) end_landing();
  if (report.iterations == 0 && targets_ != accepted_targets_) {
    const bool onward = straight_ratio(targets_ - accepted_targets_).value_or(-1) > 0;
    for (auto& pair : pairs_) pair.guess(rounding * largest_position(), onward);
  }
  const solve::Outcome outcome = assemble(first ? &step_->increment : nullptr, tangent, why);
  for (auto& pair : pairs_) pair.guess(0);
  if (first) unbalanced_ += unknowns_.gather(assembly_.product());
  if (outcome != solve::Outcome::converged || !std::exchange(step_->moved, false)) return outcome;
  active_set_.note(pairs_, unbalanced_.norm());
  // What repeats under one damping need not under the next.
  const bool repeats = step_->pseudo_time.damping() == 0;
  if (const int period = repeats ? active_set_.period() : 0; period > 0) {
    why = text("the states of contact points repeat every ", period, " iterations");
    return active_set_.strays().empty() ? solve::Outcome::cycling : solve::Outcome::lost_projection;
  }
  return outcome;
}

template <int D> solve::Trial Model<D>::retreat(double part) {
  displacement_ = step_->before + part * step_->move;
  step_->moved = true;
  std::string why;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (assemble(nullptr, false, why) != solve::Outcome::converged) return {infinity, infinity};
  return {unbalanced_.norm(), residual_.dot(step_->move)};
}

template <int D> solve::Outcome Model<D>::conclude(const StepOptions& options, std::string& why) {
  if (step_->landing) {
    end_landing();
    return solve::Outcome::iterating;
  }
  if (active_set_.release(pairs_)) {
    step_->moved = true;
    if (!active_set_.exhausted()) return solve::Outcome::iterating;
    why = "points that were held do not keep their states when they are freed";
    return solve::Outcome::cycling;
  }
  if (options.augmented.penetration == 0) return solve::Outcome::converged;
  // A point that is drawn off presses on at a gap as long as its multiplier is not taken back.
  double farthest = 0;
  for (const auto& pair : pairs_)
    for (const auto& point : pair.results())
      if (std::holds_alternative<contact::PenaltyLaw>(pair.law()) && point.state != contact::ContactState::open)
        farthest = std::max(farthest, std::abs(point.gap));
  if (farthest <= options.augmented.penetration * extent_) return solve::Outcome::converged;
  if (step_->augmentations == options.augmented.loops) {
    why = text("points that press are up to ", farthest, " off the master after ", options.augmented.loops,
               " augmentations, asked was ", options.augmented.penetration * extent_);
    return solve::Outcome::penetration;
  }
  for (auto& pair : pairs_) pair.augment();
  ++step_->augmentations;
  step_->moved = true;
  return solve::Outcome::iterating;
}

/// Tells where contact is why there was no convergence.
template <int D> void Model<D>::classify(solve::NewtonReport& report) const {
  const bool stalls =
      report.outcome == solve::Outcome::iteration_limit || report.outcome == solve::Outcome::line_search;
  if (!stalls || active_set_.restless().empty()) return;
  report.outcome = active_set_.strays().empty() ? solve::Outcome::cycling : solve::Outcome::lost_projection;
  report.message += "; the states of contact points keep changing";
}

template <int D> const solve::NewtonReport& Model<D>::iterate(const StepOptions& options) {
  if (!step_) step_ = begin_step(options);
  solve::NewtonReport& report = step_->report;
  if (report.outcome != solve::Outcome::iterating) return report;
  // The move that brings in prescribed displacements has to be whole.
  const bool flows = options.pseudo_transient && !(step_->pending && report.iterations == 0);
  solve::NewtonSystem newton = system(
      [this](bool tangent, std::string& why) { return assemble_step(tangent, why); },
      [&](double& energy) { return flows ? advance_in_pseudo_time(options, energy) : advance(options, energy); });
  newton.retreat = [this](double part) { return retreat(part); };
  newton.slope = [this] { return step_->slope; };
  newton.conclude = [&](std::string& why) { return conclude(options, why); };
  solve::NewtonOptions limits = options.newton;
  if (options.pseudo_transient) limits.iterations *= 40;
  if (!solve::iterate(newton, limits, step_->pending, report)) classify(report);
  return report;
}

template <int D> solve::NewtonReport Model<D>::solve_step(const StepOptions& options) {
  step_.reset();
  while (iterate(options).outcome == solve::Outcome::iterating) {
  }
  return step_->report;
}

template <int D> solve::Outcome Model<D>::evaluate(std::string& why) {
  if (!step_) external_ = drives_.force(targets_);
  return assemble(nullptr, true, why);
}

template <int D> void Model<D>::move(const VectorX& change) {
  require(change.size() == unknowns_.size(), "a move has one value per unknown, ", unknowns_.size(), " of them, got ",
          change.size());
  require(change.allFinite(), "a move has finite values");
  if (!step_ || step_->report.outcome != solve::Outcome::iterating) step_ = begin_step({});
  displacement_ += unknowns_.spread(change) + step_->increment;
  step_->increment.setZero();
  step_->pending = false;
  step_->moved = step_->lead = true;
  present_ = targets_;
}

/// Whether a state that move() has led to counts as converged, as solve_step() would have it by default.
template <int D> void Model<D>::judge_lead() {
  std::string why;
  const solve::Outcome outcome = assemble(nullptr, true, why);
  require(outcome == solve::Outcome::converged, "the present state has no residual: ", why, "; roll back");
  const double enough = solve::NewtonOptions{}.tolerance * force_norm() + rounding_floor();
  require(unbalanced_.norm() <= enough, "the state is not in equilibrium yet: its residual is ", unbalanced_.norm(),
          ", asked is ", enough, ": move on, or roll back");
  step_->report.outcome = solve::Outcome::converged;
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template solve::NewtonReport Model<D>::solve_step(const StepOptions&);                                               \
  template const solve::NewtonReport& Model<D>::iterate(const StepOptions&);                                           \
  template bool Model<D>::factor(const StepOptions&);                                                                  \
  template bool Model<D>::solve_for(VectorX&);                                                                         \
  template bool Model<D>::begin_landing(bool);                                                                         \
  template solve::NewtonSystem Model<D>::system(std::function<solve::Outcome(bool, std::string&)>,                     \
                                                std::function<bool(double&)>) const;                                   \
  template const std::vector<LooseMotion>& Model<D>::loose();                                                          \
  template solve::Outcome Model<D>::evaluate(std::string&);                                                            \
  template void Model<D>::move(const VectorX&);                                                                        \
  template void Model<D>::judge_lead();                                                                                \
  template double Model<D>::force_norm() const;
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::model
