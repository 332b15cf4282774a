// What mortar contact keeps from one accepted step to the next.

#include "contact/mortar/mortar_contact.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::contact {

template <int D>
void MortarContact<D>::commit_points(History<D>& present, const History<D>& accepted, double penalty_factor) {
  if (!frictional(present)) return release(present, accepted, penalty_factor);
  const double friction = this->friction(present);
  for (std::size_t a = 0; a < present.multipliers.size(); ++a) {
    MultiplierHistory<D>& history = present.multipliers[a];
    const MultiplierResult<D>& result = present.multiplier_results[a];
    const bool open = result.state == ContactState::open;
    const double limit = open ? 0 : friction * result.pressure * result.area;
    const MultiplierResult<D>& last = accepted.multiplier_results[a];
    const double before_slip =
        limit_before(history.limit, this->friction(accepted), friction, last.friction.norm() * last.area);
    // ∫ μ z dγ a by the trapezoidal rule
    present.dissipated += share() * 0.5 * (before_slip + limit) * result.slipped;
    history.limit = limit;
    history.elastic = result.elastic;
    history.touch.setZero();
    if (open) history.friction.setZero();
  }
  for (std::size_t i = 0; i < present.points.size(); ++i) {
    PointHistory<D>& point = present.points[i];
    point.slips = !is_skipped_[this->points_.list[i].element] && point.projection.foot != Foot::none;
    point.slip = point.projection.point();
  }
}

/// Friction that a path switches off leaves no history: later friction starts at the foot points of its time. The
/// energy of its springs is dissipated.
template <int D>
void MortarContact<D>::release(History<D>& present, const History<D>& accepted, double penalty_factor) const {
  if (!may_rub(law_)) return;
  const double tangential = law(accepted, penalty_factor).tangential;
  for (std::size_t a = 0; a < present.multipliers.size(); ++a) {
    MultiplierHistory<D>& history = present.multipliers[a];
    present.dissipated +=
        share() * 0.5 * tangential * history.elastic.squaredNorm() * accepted.multiplier_results[a].area;
    history.limit = 0;
    history.elastic.setZero();
    history.touch.setZero();
    history.friction.setZero();
  }
  for (PointHistory<D>& point : present.points) point.slips = false;
}

/// λ_A and λ_TA become the pressure and friction of the last evaluation.
template <int D> void MortarContact<D>::augment(History<D>& history) const {
  for (std::size_t a = 0; a < history.multipliers.size(); ++a) {
    history.multipliers[a].pressure = history.multiplier_results[a].pressure;
    history.multipliers[a].friction = history.multiplier_results[a].components;
  }
}

/// Includes positive gaps, and elastic slip where a multiplier sticks.
template <int D> double MortarContact<D>::violation(const History<D>& history) const {
  double farthest = 0;
  for (const MultiplierResult<D>& result : history.multiplier_results) {
    if (result.state == ContactState::open) continue;
    farthest = std::max({farthest, std::abs(result.gap), result.elastic.norm()});
  }
  return farthest;
}

template <int D> double MortarContact<D>::stiffness(const History<D>& history, double penalty_factor) const {
  const double penalty = solves_multipliers() ? scale_ : largest_penalty(law(history, penalty_factor));
  double sum = 0;
  for (const MultiplierResult<D>& result : history.multiplier_results)
    if (result.state != ContactState::open) sum += result.area * penalty * result.area * penalty;
  return std::sqrt(sum);
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template void MortarContact<D>::commit_points(History<D>&, const History<D>&, double);                               \
  template void MortarContact<D>::release(History<D>&, const History<D>&, double) const;                               \
  template void MortarContact<D>::augment(History<D>&) const;                                                          \
  template double MortarContact<D>::violation(const History<D>&) const;                                                \
  template double MortarContact<D>::stiffness(const History<D>&, double) const;
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::contact
