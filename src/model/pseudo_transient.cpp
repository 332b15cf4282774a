// How a model moves by pseudo-transient continuation, see solve/pseudo_time.hpp.
#include "model/model.hpp"

#include <limits>

namespace signorini::model {

/// One move in pseudo-time. D is the diagonal of the tangent at the first of them, |K_ii|. Returns false where bodies
/// move on and on, since nothing holds them.
template <int D> bool Model<D>::advance_in_pseudo_time(const StepOptions& options, double& energy) {
  if (step_->viscosity.size() == 0) {
    step_->viscosity = assembly_.diagonal().cwiseAbs();
    step_->origin = displacement_;
  }
  const auto way = [this] { return (displacement_ - step_->origin).template lpNorm<Eigen::Infinity>(); };
  if (way() > 0.5 * extent_) return false;
  const VectorX before = displacement_, residual = unbalanced_;
  // Damped strongly enough any move is accepted; what is left are tangents that cannot be factored.
  constexpr int most_trials = 30;
  std::string why;
  for (int trial = 0; trial < most_trials; ++trial) {
    if (trial > 0) {
      displacement_ = before;
      if (assemble(nullptr, true, why) != solve::Outcome::converged) return false;
    }
    const VectorX damping = step_->pseudo_time.damping() * step_->viscosity;
    assembly_.add_diagonal(damping);
    VectorX move = -residual;
    double error = std::numeric_limits<double>::infinity();
    if (factor(options) && solve_for(move) && move.allFinite()) {
      energy = std::abs(residual.dot(move));
      displacement_ = before + unknowns_.spread(move);
      // e = |r(u + Δu) + α D Δu| / |r(u)|
      if (way() <= extent_ && assemble(nullptr, false, why) == solve::Outcome::converged)
        error = (unbalanced_ + damping.cwiseProduct(move)).norm() / residual.norm();
    }
    if (step_->pseudo_time.accept(error)) {
      step_->moved = true;
      return true;
    }
  }
  return false;
}

template bool Model<2>::advance_in_pseudo_time(const StepOptions&, double&);
template bool Model<3>::advance_in_pseudo_time(const StepOptions&, double&);

} // namespace signorini::model
