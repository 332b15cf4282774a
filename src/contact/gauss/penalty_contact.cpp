#include "contact/gauss/penalty_contact.hpp"

#include "contact/point/touch.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace signorini::contact {

template <int D>
PenaltyContact<D>::PenaltyContact(ContactSetting<D> setting, const PenaltyLaw& law, Pass pass)
    : GaussPointContact<D>(std::move(setting), pass), law_(checked(law)) {}

template <int D> void PenaltyContact<D>::evaluate_point(std::size_t i, const Trial<D>& trial, Part& part, Feet& at) {
  if (!this->active(trial.present)) return;
  const std::optional<FixedContactState> fixed = close(i, trial, part, at);
  if (!fixed) return;
  const PenaltyLaw law = this->law(trial.present, trial.penalty_factor);
  const LocalGeometry<D> geometry = closed_geometry(i, trial, law, *fixed, at);
  LocalForce<D> force;
  penalty_force(law, geometry, force);
  this->record(i, trial, geometry, force, part, at);
}

template <int D>
std::optional<FixedContactState> PenaltyContact<D>::close(std::size_t i, const Trial<D>& trial, Part& part,
                                                          Feet& at) const {
  PointHistory<D>& point = trial.present.points[i];
  const Controls& controls = trial.controls;
  const double travel = this->travel_;
  FixedContactState fixed = controls.fixed_states.empty() ? FixedContactState::free : controls.fixed_states[i];
  if (fixed == FixedContactState::open) return {};
  if (fixed == FixedContactState::free && travel + controls.guessed < point.cleared) return {};
  const bool opposite = this->find_foot(i, trial, part, at);
  const PenaltyLaw law = this->law(trial.present, trial.penalty_factor);
  const Foot foot = point.projection.foot;
  const double gap = point.projection.gap;
  // t_N = λ_N − ε_N (g − o) > 0 below a gap of o + λ_N/ε_N
  const double distance = gap - this->offset(i, trial.present) - point.multiplier / law.normal;
  // A point beyond an end of the master comes behind it without a way when the end turns.
  const bool clear = foot == Foot::regular && at.foot.settled && distance > 0;
  point.cleared = clear ? travel + distance : 0;
  if (!opposite) return {};
  if (fixed == FixedContactState::free && std::abs(distance) < controls.guessed) fixed = FixedContactState::stick;
  if (fixed == FixedContactState::free && distance >= 0) return {};
  if (fixed == FixedContactState::free && controls.landing) fixed = FixedContactState::stick;
  if (foot != Foot::regular && gap == 0) return {}; // no direction
  return fixed;
}

template <int D>
LocalGeometry<D> PenaltyContact<D>::closed_geometry(std::size_t i, const Trial<D>& trial, const PenaltyLaw& law,
                                                    FixedContactState fixed, Feet& at) const {
  const PointHistory<D>& point = trial.present.points[i];
  const Controls& controls = trial.controls;
  LocalGeometry<D> geometry = this->geometry(i, trial, at);
  geometry.multiplier = point.multiplier;
  geometry.fixed_state = fixed;
  geometry.tie = controls.onward ? -controls.guessed : controls.guessed;
  if (law.friction > 0 && !point.slips && controls.foresees) foresee_touch(i, trial, law);
  if (law.friction > 0 && !point.slips) remember_touch(i, trial);
  if (law.friction > 0 && point.slips) {
    this->master().locate(point.slip, at.slip_point);
    geometry.slip_point = &at.slip_point.position;
  }
  return geometry;
}

/// A point that the guess of the step closes slips from where it touches on the way to it.
template <int D>
void PenaltyContact<D>::foresee_touch(std::size_t i, const Trial<D>& trial, const PenaltyLaw& law) const {
  PointHistory<D>& point = trial.present.points[i];
  const double pressed = point.multiplier / law.normal; // t_N > 0 below a gap of o + λ_N/ε_N
  const std::optional<MasterPoint<D>> touch =
      touch_point<D>(this->accepted_master_, this->master(),
                     {trial.accepted.results[i].position, this->offset(i, trial.accepted) + pressed},
                     {trial.present.results[i].position, this->offset(i, trial.present) + pressed}, point.projection);
  if (!touch) return;
  point.slips = true;
  point.slip = *touch;
}

/// A newly closed point without a forecast slips from its foot point in the accepted state.
template <int D> void PenaltyContact<D>::remember_touch(std::size_t i, const Trial<D>& trial) const {
  PointHistory<D>& point = trial.present.points[i];
  FacePoint<D> foot;
  const Projection<D> projection =
      this->accepted_master_.project(trial.accepted.results[i].position, point.projection, foot);
  if (projection.foot == Foot::none) return;
  point.slips = true;
  point.slip = projection.point();
}

template <int D>
void PenaltyContact<D>::commit_points(History<D>& present, const History<D>& accepted, double penalty_factor) {
  const PenaltyLaw law = this->law(present, penalty_factor);
  if (law.friction == 0) return release(present, accepted, penalty_factor);
  for (std::size_t i = 0; i < this->points_.size(); ++i) advance_slip_point(i, present, accepted, law);
}

/// Friction that a path switches off leaves no slip points: later friction starts at the foot points of its time. Its
/// springs' energy is dissipated.
template <int D>
void PenaltyContact<D>::release(History<D>& present, const History<D>& accepted, double penalty_factor) const {
  if (!may_rub(law_)) return;
  const double tangential = law(accepted, penalty_factor).tangential;
  for (std::size_t i = 0; i < this->points_.size(); ++i) {
    PointHistory<D>& point = present.points[i];
    const PointResult<D>& before = accepted.results[i];
    // A friction t on a fraction d of the area: d (t/d)²/(2 ε_T)
    const double friction = friction_of(accepted, i).norm() * stretch(before), fraction = rubbing(accepted, i);
    if (friction > 0)
      present.dissipated += this->share() * before.law_area * friction * friction / (2 * tangential * fraction);
    point.slips = false;
    point.limit = 0;
  }
}

/// Updates a point's slip point at the end of an accepted step.
template <int D>
void PenaltyContact<D>::advance_slip_point(std::size_t i, History<D>& history, const History<D>& accepted,
                                           const PenaltyLaw& law) const {
  const Master<D>& master = this->master();
  PointHistory<D>& point = history.points[i];
  PointResult<D>& result = history.results[i];
  const PointResult<D>& last = accepted.results[i];
  const double limit = rubbing(history, i) * law.friction * pressure_of(history, i) * result.area;
  const double before_slip =
      limit_before(point.limit, this->friction(accepted), law.friction, friction_of(accepted, i).norm() * last.area);
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
    history.dissipated += this->share() * 0.5 * (before_slip + limit) * slipped;
    point.slip = master.advance(point.slip, foot, length);
    master.locate(point.slip, slip_point);
    const double after = (slip_point.position - foot.position).norm();
    // Distances are differences of positions, whose rounding errors exceed the tolerance where springs are very short.
    const double rounding = distance_rounding * (foot.position.norm() + slip_point.position.norm());
    if (slipped > 0 && std::abs(after - length) > slip_tolerance * before + rounding) result.settled = false;
  }
}

/// λ_N at each point becomes λ_N − ε_N (g − o) of the last evaluation.
template <int D> void PenaltyContact<D>::augment(History<D>& history) const {
  for (std::size_t i = 0; i < history.points.size(); ++i)
    history.points[i].multiplier = history.results[i].pressure * stretch(history.results[i]);
}

/// Includes positive gaps: an opening point keeps its pressure until its multiplier is reduced.
template <int D> double PenaltyContact<D>::violation(const History<D>& history) const {
  double farthest = 0;
  for (const PointResult<D>& point : history.results)
    if (touches(point.state)) farthest = std::max(farthest, std::abs(point.gap));
  return farthest;
}

template <int D> double PenaltyContact<D>::stiffness(const History<D>& history, double penalty_factor) const {
  const double penalty = largest_penalty(law(history, penalty_factor));
  double sum = 0;
  for (const PointResult<D>& point : history.results)
    if (touches(point.state)) sum += point.law_area * penalty * point.law_area * penalty;
  return std::sqrt(sum);
}

template class PenaltyContact<2>;
template class PenaltyContact<3>;

} // namespace signorini::contact
