#include "contact/gauss/penalty_contact.hpp"

#include "contact/point/touch.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace signorini::contact {

template <int D>
void PenaltyContact<D>::evaluate_point(std::size_t i, const Trial<D>& trial, SumPart<D>& part, FootPoints<D>& feet) {
  if (!parameters_.active(trial.present.changes)) return;
  const std::optional<FixedContactState> fixed = close(i, trial, part, feet);
  if (!fixed) return;
  const PenaltyLaw law = parameters_.law_in(trial.present.changes, trial.penalty_factor);
  const LocalGeometry<D> geometry = closed_geometry(i, trial, law, *fixed, feet);
  LocalForce<D> force;
  penalty_force(law, geometry, force);
  this->record(i, trial, geometry, force, part, feet);
}

template <int D>
std::optional<FixedContactState> PenaltyContact<D>::close(std::size_t i, const Trial<D>& trial, SumPart<D>& part,
                                                          FootPoints<D>& feet) const {
  PointHistory<D>& point = trial.present.points[i];
  const Controls& controls = trial.controls;
  const FixedContactState fixed = controls.fixed(static_cast<int>(i));
  if (fixed == FixedContactState::open) return {};
  if (fixed == FixedContactState::free && faces_.travel + controls.guessed < point.cleared) return {};
  const bool opposite = this->find_foot(i, trial, part, feet);
  const Foot foot = point.projection.foot;
  const double distance = point.projection.gap - parameters_.offset(i, trial.present.changes);
  // A point beyond an end of the master comes behind it without a way when the end turns.
  const bool clear = foot == Foot::regular && feet.foot.settled && distance > 0;
  point.cleared = clear ? faces_.travel + distance : 0;
  if (!opposite || (foot != Foot::regular && point.projection.gap == 0)) return {}; // no direction
  return controls.closed(static_cast<int>(i), distance);
}

template <int D>
LocalGeometry<D> PenaltyContact<D>::closed_geometry(std::size_t i, const Trial<D>& trial, const PenaltyLaw& law,
                                                    FixedContactState fixed, FootPoints<D>& feet) const {
  PointHistory<D>& point = trial.present.points[i];
  LocalGeometry<D> geometry = this->geometry(i, trial, feet);
  geometry.fixed_state = fixed;
  geometry.tie = trial.controls.tie();
  if (law.friction == 0) return geometry;
  if (!point.slips) {
    // A newly closed point slips from where it touches or, without a forecast, from its foot in the accepted state.
    std::optional<MasterPoint<D>> from;
    if (trial.controls.foresees) from = foresee_touch(i, trial);
    if (!from) from = faces_.accepted_foot(trial.accepted.results[i].position, point.projection);
    point.slips = from.has_value();
    if (from) point.slip = *from;
  }
  if (point.slips) {
    faces_.master.locate(point.slip, feet.slip_point);
    geometry.slip_point = &feet.slip_point.position;
  }
  return geometry;
}

/// Where a point that the guess of the step closes touches on the way to it.
template <int D>
std::optional<MasterPoint<D>> PenaltyContact<D>::foresee_touch(std::size_t i, const Trial<D>& trial) const {
  const auto touching = [&](const History<D>& history) -> Touching<D> {
    return {history.results[i].position, parameters_.offset(i, history.changes)};
  };
  return touch_point<D>(faces_.accepted, faces_.master, touching(trial.accepted), touching(trial.present),
                        trial.present.points[i].projection);
}

template <int D>
void PenaltyContact<D>::commit(History<D>& present, const History<D>& accepted, double penalty_factor) {
  const PenaltyLaw law = parameters_.law_in(present.changes, penalty_factor);
  if (law.friction > 0)
    for (std::size_t i = 0; i < points_.size(); ++i) advance_slip_point(i, present, accepted, law);
  else if (may_rub(*parameters_.law))
    release(present, accepted, parameters_.law_in(accepted.changes, penalty_factor).tangential);
  GaussPointContact<D>::commit(present, accepted, penalty_factor);
}

/// Friction that a path switches off leaves no slip points: later friction starts at the foot points of its time. Its
/// springs' energy is dissipated.
template <int D>
void PenaltyContact<D>::release(History<D>& present, const History<D>& accepted, double tangential) const {
  for (std::size_t i = 0; i < points_.size(); ++i) {
    PointHistory<D>& point = present.points[i];
    const PointResult<D>& before = accepted.results[i];
    // A friction t on a fraction d of the area: d (t/d)²/(2 ε_T)
    const double friction = friction_of(accepted, i).norm() * stretch(before), fraction = rubbing(accepted, i);
    if (friction > 0)
      present.dissipated +=
          parameters_.energy_share() * before.law_area * friction * friction / (2 * tangential * fraction);
    point.slips = false;
    point.limit = 0;
  }
}

/// Updates a point's slip point at the end of an accepted step.
template <int D>
void PenaltyContact<D>::advance_slip_point(std::size_t i, History<D>& history, const History<D>& accepted,
                                           const PenaltyLaw& law) const {
  const Master<D>& master = faces_.master;
  PointHistory<D>& point = history.points[i];
  PointResult<D>& result = history.results[i];
  const PointResult<D>& last = accepted.results[i];
  const double limit = rubbing(history, i) * law.friction * pressure_of(history, i) * result.area;
  const double before_slip = limit_before(point.limit, parameters_.friction(accepted.changes), law.friction,
                                          friction_of(accepted, i).norm() * last.area);
  point.limit = limit;
  if (!touches(result.state)) {
    point.slips = false;
  } else if (!point.slips) {
    // The point was beyond the master's end before: friction starts at its present foot point.
    point.slips = true;
    point.slip = point.projection.point();
  } else if (result.state == ContactState::slip) {
    FacePoint<D> foot, slip_point;
    master.locate(point.projection.point(), foot);
    master.locate(point.slip, slip_point);
    // |x̄ᵐ − xᵐ(ξ_sl)| decreases to μ t_N/ε_T; the difference is the slip Δγ.
    const double length = law.friction * pressure_of(history, i) * stretch(result) / law.tangential;
    const double before = (slip_point.position - foot.position).norm(), slipped = std::max(before - length, 0.0);
    history.dissipated += parameters_.energy_share() * 0.5 * (before_slip + limit) * slipped;
    point.slip = master.advance(point.slip, foot, length);
    master.locate(point.slip, slip_point);
    const double after = (slip_point.position - foot.position).norm();
    // Distances are differences of positions, whose rounding errors exceed the tolerance where springs are very short.
    const double rounding = distance_rounding * (foot.position.norm() + slip_point.position.norm());
    if (slipped > 0 && std::abs(after - length) > slip_tolerance * before + rounding) result.settled = false;
  }
}

template <int D> double PenaltyContact<D>::stiffness(const History<D>& history, double penalty_factor) const {
  const double penalty = largest_penalty(parameters_.law_in(history.changes, penalty_factor));
  double sum = 0;
  for (const PointResult<D>& point : history.results)
    if (touches(point.state)) sum += point.law_area * penalty * point.law_area * penalty;
  return std::sqrt(sum);
}

template class PenaltyContact<2>;
template class PenaltyContact<3>;

} // namespace signorini::contact
