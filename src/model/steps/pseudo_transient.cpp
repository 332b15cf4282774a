#include "model/steps/pseudo_transient.hpp"

#include "model/constants.hpp"
#include "model/steps/equilibrium.hpp"

#include <limits>

namespace signorini::model {

template <int D> bool advance_in_pseudo_time(Model<D>& model, const StepOptions& options, double& energy) {
  Step& step = *model.step;
  step.definite = false;
  Assembly<D>& assembly = model.system.assembly;
  VectorX& displacement = model.present.displacement;
  if (step.viscosity.size() == 0) {
    step.viscosity = assembly.tangent().diagonal().cwiseAbs();
    step.origin = displacement;
  }
  const auto way = [&] { return (displacement - step.origin).template lpNorm<Eigen::Infinity>(); };
  if (way() > most_way * model.system.extent) return false;
  const VectorX before = displacement, residual = model.unbalanced;
  Message why;
  for (int trial = 0; trial < most_trials; ++trial) {
    if (trial > 0) {
      displacement = before;
      if (evaluate(model, nullptr, true, why) != solve::Outcome::converged) return false;
    }
    const VectorX damping = step.pseudo_time.damping() * step.viscosity;
    assembly.add_diagonal(damping);
    VectorX move = -residual;
    double error = std::numeric_limits<double>::infinity();
    if (factor(model, options) && solve_for(model, move) && move.allFinite()) {
      energy = std::abs(residual.dot(move));
      displacement = before + model.system.unknowns.spread(move);
      // e = |r(u + Δu) + α D Δu| / |r(u)|
      if (way() <= model.system.extent && evaluate(model, nullptr, false, why) == solve::Outcome::converged)
        error = (model.unbalanced + damping.cwiseProduct(move)).norm() / residual.norm();
    }
    if (step.pseudo_time.accept(error)) {
      step.moved = true;
      return true;
    }
  }
  return false;
}

template bool advance_in_pseudo_time(Model<2>&, const StepOptions&, double&);
template bool advance_in_pseudo_time(Model<3>&, const StepOptions&, double&);

} // namespace signorini::model
