#include "model/steps/arc.hpp"

#include "base/error.hpp"
#include "model/steps/equilibrium.hpp"
#include "os/timer.hpp"

namespace signorini::model {

/// Data of an arc-length increment.
struct Arc {
  VectorX direction; ///< of the targets, up to λ = 1
  double length;
  VectorX tangent = {}; ///< t times the weights of the inner product, from the predictor
};

namespace {

/// Sets prescribed displacements and loads to the values at `targets`.
template <int D> void move_targets(Model<D>& model, const VectorX& targets) {
  const Drives<D>& drives = model.system.drives;
  model.present.displacement += drives.displacement(targets) - drives.displacement(model.present.targets);
  set_loads(model, targets);
  model.present.targets = targets;
}

template <int D> bool advance(Model<D>& model, const StepOptions& options, Arc& arc, double& energy) {
  ScopedTimer timer(model.timings.linear);
  System<D>& system = model.system;
  const Unknowns<D>& unknowns = system.unknowns;
  State<D>& present = model.present;
  if (unknowns.size() == 0 || !factor(model, options)) return false;
  // K δ₁ = −f,  K δ₂ = −∂f/∂λ with ∂f/∂λ = K_p ∂u_p/∂λ − ∂f_ext/∂λ
  const VectorX force = -model.unbalanced;
  VectorX load_rate = system.drives.force(arc.direction);
  system.followers.add_force(present.displacement, arc.direction, load_rate);
  const VectorX change = -unknowns.gather(system.assembly.product() - load_rate);
  VectorX first = force, second = change;
  if (!solve_for(model, first) || !solve_for(model, second)) return false;
  if (!first.allFinite() || !second.allFinite()) return false;
  const VectorX step = unknowns.spread(first), free_rate = unknowns.spread(second);
  const VectorX rate = free_rate + system.drives.rate(present.targets, arc.direction);
  double lambda;
  if (arc.tangent.size() == 0) {
    // Predictor: along the curve's tangent, in the sense of the last step
    const VectorX weighted = system.path_weights().cwiseProduct(rate);
    const double speed = std::sqrt(rate.dot(weighted));
    const bool back = weighted.dot(model.path.increment) < 0;
    lambda = (back ? -1 : 1) * arc.length / speed;
    arc.tangent = weighted / (back ? -speed : speed);
  } else {
    // t·(u + δ₁ + δλ (δ₂ + ∂u_p/∂λ) − u₀) = length, t with the weights of the inner product
    lambda = (arc.length - arc.tangent.dot(present.displacement - model.accepted.displacement + step)) /
             arc.tangent.dot(rate);
  }
  if (!std::isfinite(lambda)) return false;
  energy = std::abs((force + lambda * change).dot(first + lambda * second));
  present.displacement += step + lambda * free_rate;
  model.step->fraction += lambda;
  move_targets<D>(model, model.accepted.targets + model.step->fraction * arc.direction);
  return true;
}

} // namespace

template <int D> solve::NewtonReport solve_arc(Model<D>& model, const StepOptions& options, double length) {
  Arc arc{model.targets - model.accepted.targets, length};
  require((arc.direction.array() != 0).any(), "model.arc.no_path");
  require(length > 0, "model.arc.length", {{"length", length}});
  for (std::size_t k = 0; k < model.system.contacts.size(); ++k)
    require(!model.system.contacts[k]->augmented(), "model.arc.augmented",
            {{"contact", model.system.scene.contacts[k].name}});
  begin_contacts(model, {}, false);
  model.step = Step{{}, true};
  VectorX rate;
  const auto assemble = [&](bool wanted, Message& why) {
    rate = model.system.drives.rate(model.present.targets, arc.direction);
    return evaluate(model, wanted ? &rate : nullptr, wanted, why);
  };
  const auto step = [&](double& energy) { return advance(model, options, arc, energy); };
  const solve::NewtonSystem system = newton_system<D>(model, assemble, step);
  while (solve::iterate(system, options.newton, true, model.step->report))
    if (options.after_iteration) options.after_iteration();
  if (options.after_iteration) options.after_iteration();
  model.targets = model.present.targets;
  return model.step->report;
}

template <int D> double last_length(Model<D>& model) {
  return std::sqrt(model.system.path_weights().dot(model.path.increment.cwiseAbs2()));
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template solve::NewtonReport solve_arc(Model<D>&, const StepOptions&, double);                                       \
  template double last_length(Model<D>&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::model
