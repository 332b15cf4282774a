// How a model follows its path by arc length.
#include "model/model.hpp"

#include "base/error.hpp"
#include "base/timer.hpp"
#include "model/path_norm.hpp"

namespace signorini::model {

template <int D> const VectorX& Model<D>::path_weights() {
  if (!path_weights_) path_weights_ = model::path_weights(scene_, unknowns_);
  return *path_weights_;
}

template <int D> double Model<D>::last_length() {
  return std::sqrt(path_weights().dot(last_increment_.cwiseAbs2()));
}

/// Brings the prescribed displacements and loads from present_ to other targets.
template <int D> void Model<D>::move_targets(const VectorX& targets) {
  displacement_ += drives_.displacement(targets) - drives_.displacement(present_);
  external_ = drives_.force(targets);
  present_ = targets;
}

template <int D>
bool Model<D>::advance_arc(const StepOptions& options, const VectorX& direction, double length, VectorX& tangent,
                           double& energy) {
  ScopedTimer timer(timings_.linear);
  if (unknowns_.size() == 0 || !factor(options)) return false;
  // K δ₁ = −f,  K δ₂ = −∂f/∂λ with ∂f/∂λ = K_p ∂u_p/∂λ − ∂f_ext/∂λ
  const VectorX force = -unbalanced_;
  const VectorX change = -unknowns_.gather(assembly_.product() - drives_.force(direction));
  VectorX first = force, second = change;
  if (!solve_for(first) || !solve_for(second)) return false;
  if (!first.allFinite() || !second.allFinite()) return false;
  const VectorX step = unknowns_.spread(first), free_rate = unknowns_.spread(second);
  const VectorX rate = free_rate + drives_.rate(present_, direction);
  double lambda;
  if (tangent.size() == 0) {
    // Predictor: along the curve's tangent, on in the sense of the last step
    const VectorX weighted = path_weights().cwiseProduct(rate);
    const double speed = std::sqrt(rate.dot(weighted));
    const bool back = weighted.dot(last_increment_) < 0;
    lambda = (back ? -1 : 1) * length / speed;
    tangent = weighted / (back ? -speed : speed);
  } else {
    // t·(u + δ₁ + δλ (δ₂ + ∂u_p/∂λ) − u₀) = length, t with the weights of the inner product
    lambda = (length - tangent.dot(displacement_ - accepted_ + step)) / tangent.dot(rate);
  }
  if (!std::isfinite(lambda)) return false;
  energy = std::abs((force + lambda * change).dot(first + lambda * second));
  displacement_ += step + lambda * free_rate;
  arc_fraction_ += lambda;
  move_targets(accepted_targets_ + arc_fraction_ * direction);
  return true;
}

template <int D> solve::NewtonReport Model<D>::solve_arc(const StepOptions& options, double length) {
  const VectorX direction = targets_ - accepted_targets_;
  require((direction.array() != 0).any(), "an arc needs a path: set a target other than the accepted one");
  require(length > 0, "an arc's length must be positive, got ", length);
  arc_fraction_ = 0;
  active_set_.begin(pairs_, {});
  begin_landing(false);
  step_ = Step{{}, true};
  VectorX rate, tangent;
  const auto assemble_rate = [&](bool wanted, std::string& why) {
    rate = drives_.rate(present_, direction);
    return assemble(wanted ? &rate : nullptr, wanted, why);
  };
  const auto step = [&](double& energy) { return advance_arc(options, direction, length, tangent, energy); };
  step_->report = solve::newton(system(assemble_rate, step), options.newton, true);
  targets_ = present_;
  return step_->report;
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template double Model<D>::last_length();                                                                             \
  template solve::NewtonReport Model<D>::solve_arc(const StepOptions&, double);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::model
