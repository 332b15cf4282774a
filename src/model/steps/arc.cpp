#include "model/steps/arc.hpp"

#include "base/error.hpp"
#include "model/steps/equilibrium.hpp"
#include "os/timer.hpp"

namespace signorini::model {

namespace {

/// Sets prescribed displacements and loads to the values at `targets`.
template <int D> void move_targets(Model<D>& model, const VectorX& targets) {
  const Drives<D>& drives = model.system.drives;
  model.present.displacement += drives.displacement(targets) - drives.displacement(model.present.targets);
  set_loads(model, targets);
  model.present.targets = targets;
}

template <int D> class ArcStep final : public StepProblem<D> {
public:
  ArcStep(Model<D>& of, const StepOptions& with, double length)
      : StepProblem<D>(of, with), direction_(of.targets - of.accepted.targets), length_(length) {}

  solve::Outcome evaluate(bool tangent, Message& why) override {
    const VectorX rate = model.system.drives.rate(model.present.targets, direction_);
    return model::evaluate(model, {.tangent = tangent, .direction = tangent ? &rate : nullptr, .corrects = true}, why);
  }
  std::optional<double> advance() override;
  /// λ: 0 at the accepted state, 1 at the targets.
  double fraction() const { return fraction_; }

private:
  using StepProblem<D>::model;

  const VectorX direction_; ///< of the targets, up to λ = 1
  const double length_;
  VectorX tangent_; ///< t times the weights of the inner product, from the predictor
  double fraction_ = 0;
};

template <int D> std::optional<double> ArcStep<D>::advance() {
  ScopedTimer timer(model.timings.linear);
  System<D>& system = model.system;
  const Unknowns<D>& unknowns = system.unknowns;
  State<D>& present = model.present;
  if (unknowns.size() == 0 || !this->factor()) return std::nullopt;
  // [theory 10.6] K δ₁ = −f,  K δ₂ = −∂f/∂λ with ∂f/∂λ = K_p ∂u_p/∂λ − ∂f_ext/∂λ
  const VectorX force = -model.unbalanced;
  VectorX load_rate = system.drives.force(direction_);
  system.followers.add_force(present.displacement, direction_, load_rate);
  const VectorX change = -unknowns.gather(system.assembly.product() - load_rate);
  VectorX first = force, second = change;
  if (!this->solve(first) || !this->solve(second)) return std::nullopt;
  const VectorX step = unknowns.spread(first), free_rate = unknowns.spread(second);
  const VectorX rate = free_rate + system.drives.rate(present.targets, direction_);
  double lambda;
  if (tangent_.size() == 0) {
    // Predictor: along the curve's tangent, in the sense of the last step
    const VectorX weighted = system.path_weights().cwiseProduct(rate);
    const double speed = std::sqrt(rate.dot(weighted));
    const bool back = weighted.dot(model.path.increment) < 0;
    lambda = (back ? -1 : 1) * length_ / speed;
    tangent_ = weighted / (back ? -speed : speed);
  } else {
    // [theory 10.6] t·(u + δ₁ + δλ (δ₂ + ∂u_p/∂λ) − u₀) = length, t with the weights of the inner product
    lambda = (length_ - tangent_.dot(present.displacement - model.accepted.displacement + step)) / tangent_.dot(rate);
  }
  if (!std::isfinite(lambda)) return std::nullopt;
  present.displacement += step + lambda * free_rate;
  fraction_ += lambda;
  move_targets<D>(model, model.accepted.targets + fraction_ * direction_);
  return -(force + lambda * change).dot(first + lambda * second);
}

} // namespace

template <int D>
ArcReport solve_arc(Model<D>& model, const StepOptions& options, double length, const AfterIteration& after) {
  require(model.targets != model.accepted.targets, "model.arc.no_path");
  require(length > 0, "model.arc.length", {{"length", length}});
  begin_contacts(model, {});
  model.step = Step{{}, true};
  ArcStep<D> problem(model, options, length);
  bool goes_on = true;
  while (goes_on) {
    goes_on = solve::iterate(problem, options.newton, true, model.step->report);
    if (after) after();
  }
  model.targets = model.present.targets;
  return {model.step->report, problem.fraction()};
}

template <int D> double last_length(Model<D>& model) {
  return std::sqrt(model.system.path_weights().dot(model.path.increment.cwiseAbs2()));
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template ArcReport solve_arc(Model<D>&, const StepOptions&, double, const AfterIteration&);                          \
  template double last_length(Model<D>&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::model
