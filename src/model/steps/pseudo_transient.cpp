#include "model/steps/pseudo_transient.hpp"

#include "model/constants.hpp"

#include <limits>

namespace signorini::model {

template <int D> std::optional<double> advance_in_pseudo_time(StepProblem<D>& problem) {
  Model<D>& model = problem.model;
  Step& step = *model.step;
  step.definite = false;
  Assembly<D>& assembly = model.system.assembly;
  VectorX& displacement = model.present.displacement;
  if (!step.pseudo_transient)
    step.pseudo_transient = PseudoTransient{assembly.tangent().diagonal().cwiseAbs(), displacement};
  PseudoTransient& pseudo = *step.pseudo_transient;
  const auto way = [&] { return (displacement - pseudo.origin).template lpNorm<Eigen::Infinity>(); };
  if (way() > most_way * model.system.extent) return std::nullopt;
  const VectorX before = displacement, residual = model.unbalanced;
  Message why;
  for (int trial = 0; trial < most_trials; ++trial) {
    if (trial > 0) {
      displacement = before;
      if (evaluate(model, {}, why) != solve::Outcome::converged) return std::nullopt;
    }
    const VectorX damping = pseudo.time.damping() * pseudo.viscosity;
    assembly.add_diagonal(damping);
    VectorX move = -residual;
    double error = std::numeric_limits<double>::infinity();
    if (problem.factor(pseudo.time.damping() > 0) && problem.solve(move)) {
      displacement = before + model.system.unknowns.spread(move);
      // e = |r(u + Δu) + α D Δu| / |r(u)|
      if (way() <= model.system.extent && evaluate(model, {.tangent = false}, why) == solve::Outcome::converged)
        error = (model.unbalanced + damping.cwiseProduct(move)).norm() / residual.norm();
    }
    if (pseudo.time.accept(error)) return residual.dot(move);
  }
  return std::nullopt;
}

template std::optional<double> advance_in_pseudo_time(StepProblem<2>&);
template std::optional<double> advance_in_pseudo_time(StepProblem<3>&);

} // namespace signorini::model
