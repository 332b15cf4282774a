#include "contact/gauss/gauss_point_contact.hpp"

#include "contact/gauss/set_points.hpp"
#include "contact/point/interface_force.hpp"
#include "contact/point/touch.hpp"
#include "contact/point/unfold.hpp"
#include "os/timer.hpp"

#include <cmath>

namespace signorini::contact {

template <int D> void GaussPointContact<D>::evaluate_part(int index, const Trial<D>& trial, bool tangent) {
  SumPart<D>& part = parts_[index];
  part.tangent = tangent;
  part.law = parameters_.law_in(trial.present.changes, trial.penalty_factor);
  FootPoints<D> feet;
  part.watched.clear();
  for (int e = points_.list[part.first].element; e <= points_.list[part.last - 1].element; ++e) {
    const PointRange range{points_.starts[e], points_.starts[e + 1]};
    if (range.first == range.last) continue;
    const bool alone = faces_.master.set() && is_alone(*this, e, trial.present, trial.accepted, trial.controls.guessed);
    if (!alone || !has_no_past(*this, e, trial.present))
      part.watched.push_back(range);
    else if (!is_watched(trial.present, range.first))
      continue;
    for (std::size_t i = range.first; i < range.last; ++i) {
      if (!acts(points_, trial.present, i)) continue;
      trial.present.results[i] = {};
      trial.present.results[i].position = position(points_, faces_.slave, i);
      if (!alone) evaluate_point(i, trial, part, feet);
    }
    part.sums.close_element(tangent);
  }
}

template <int D>
bool GaussPointContact<D>::find_foot(std::size_t i, const Trial<D>& trial, SumPart<D>& part,
                                     FootPoints<D>& feet) const {
  const ScopedTimer timer(this->counters.times_search ? &part.search_seconds : nullptr);
  const Lookout<D> from = lookout(*this, i, trial);
  return contact::find_foot(faces_.master, trial.present.points[i], trial.present.results[i], feet.foot, from);
}

template <int D>
LocalGeometry<D> GaussPointContact<D>::geometry(std::size_t i, const Trial<D>& trial, FootPoints<D>& feet) const {
  faces_.master.functions(feet.foot, 1);
  LocalGeometry<D> geometry = point_geometry(points_, i, faces_, trial.present.results[i].position,
                                             trial.present.points[i].projection, feet.foot);
  geometry.offset = parameters_.offset(i, trial.present);
  return geometry;
}

template <int D>
void GaussPointContact<D>::record(std::size_t i, const Trial<D>& trial, const LocalGeometry<D>& geometry,
                                  const LocalForce<D>& force, SumPart<D>& part, const FootPoints<D>& feet) const {
  PointResult<D>& result = trial.present.results[i];
  const double weight = points_.list[i].weight;
  result.state = force.state;
  result.gap = geometry.gap - geometry.offset + force.worn;
  result.worn = force.worn;
  // Cauchy tractions, whatever the area on which the law's act: t da = T dA
  result.pressure = force.pressure / force.stretch;
  for (int k = 0; k < D - 1; ++k) result.tangents.col(k) = geometry.slave_tangent[k];
  result.friction = force.friction / force.stretch;
  result.mu = force.mu;
  result.flaw = force.flaw;
  result.force = weight * force.force;
  result.law_area = weight * force.measure;
  result.area = result.law_area * force.stretch;
  result.potential = parameters_.energy_share() * result.law_area * force.potential;
  part.sums.add(points_, i, feet.foot, geometry.slip_point ? &feet.slip_point : nullptr, force, part.tangent);
}

template <int D> void GaussPointContact<D>::gather(const Trial<D>& trial, bool) {
  hand_over(parts_, this->blocks_, this->counters.search_seconds);
  trial.present.watched.clear();
  for (const SumPart<D>& part : parts_)
    for (const PointRange& range : part.watched) watch(trial.present, range);
}

template <int D> void GaussPointContact<D>::take_back(std::vector<Block>& blocks) {
  auto block = blocks.begin();
  for (SumPart<D>& part : parts_) part.sums.take_back(block);
  blocks.clear();
}

template <int D>
void GaussPointContact<D>::evaluate_point(std::size_t i, const Trial<D>& trial, SumPart<D>& part, FootPoints<D>& feet) {
  if (!parameters_.active(trial.present.changes)) return;
  const std::optional<FixedContactState> fixed = close(i, trial, part, feet);
  if (!fixed) return;
  const LocalGeometry<D> geometry = closed_geometry(i, trial, *part.law, *fixed, feet);
  LocalForce<D> force;
  interface_force(*part.law, geometry, force);
  record(i, trial, geometry, force, part, feet);
}

template <int D>
std::optional<FixedContactState> GaussPointContact<D>::close(std::size_t i, const Trial<D>& trial, SumPart<D>& part,
                                                             FootPoints<D>& feet) const {
  PointHistory<D>& point = trial.present.points[i];
  const Controls& controls = trial.controls;
  const double reach = contact::reach(*parameters_.law);
  const bool always = std::isinf(reach);
  const FixedContactState fixed = always ? FixedContactState::free : controls.fixed(static_cast<int>(i));
  if (fixed == FixedContactState::open) return {};
  if (fixed == FixedContactState::free && faces_.travel + controls.guessed < point.cleared) return {};
  const bool opposite = find_foot(i, trial, part, feet);
  const Foot foot = point.projection.foot;
  const double distance = point.projection.gap - parameters_.offset(i, trial.present) - reach;
  // A point beyond an end of the master comes behind it without a way when the end turns.
  const bool clear = !faces_.master.set() && foot == Foot::regular && feet.foot.settled && distance > 0;
  point.cleared = clear ? faces_.travel + distance : 0;
  if (!opposite || (foot != Foot::regular && point.projection.gap == 0)) return {}; // no direction
  return always ? fixed : controls.closed(static_cast<int>(i), distance);
}

template <int D>
LocalGeometry<D> GaussPointContact<D>::closed_geometry(std::size_t i, const Trial<D>& trial, const InterfaceLaw& law,
                                                       FixedContactState fixed, FootPoints<D>& feet) const {
  PointHistory<D>& point = trial.present.points[i];
  LocalGeometry<D> geometry = this->geometry(i, trial, feet);
  geometry.fixed_state = fixed;
  geometry.tie = trial.controls.tie();
  if (law.coefficient || law.pressure || law.wear)
    geometry.interface = {trial.duration, point.slipped, point.recent, place_of(points_.reference[i])};
  if (!slides(law)) return geometry;
  if (!point.slips) {
    // A newly closed point slips from where it touches or, without a forecast, from its foot in the accepted state.
    std::optional<MasterPoint<D>> from;
    if (trial.controls.foresees) from = foresee_touch(i, trial);
    if (!from)
      from = faces_.accepted_foot(trial.accepted.results[i].position, point.projection, lookout(faces_, points_, i));
    point.slips = from.has_value();
    if (from) point.slip = *from;
  }
  if (point.slips) {
    locate_slip(faces_, point.slip, feet.foot, feet.slip_point);
    geometry.slip_point = &feet.slip_point.position;
    if (point.projection.foot == Foot::corner)
      geometry.way = way_to_corner(faces_.master, feet.foot, feet.slip_point.position);
  }
  return geometry;
}

/// Where a point that the guess of the step closes touches on the way to it.
template <int D>
std::optional<MasterPoint<D>> GaussPointContact<D>::foresee_touch(std::size_t i, const Trial<D>& trial) const {
  const auto touching = [&](const History<D>& history) -> Touching<D> {
    return {history.results[i].position, parameters_.offset(i, history)};
  };
  return touch_point<D>(faces_.accepted, faces_.master, touching(trial.accepted), touching(trial.present),
                        trial.present.points[i].projection, lookout(faces_, points_, i));
}

template <int D> double GaussPointContact<D>::stiffness(const History<D>& history, double penalty_factor) const {
  const InterfaceLaw law = parameters_.law_in(history.changes, penalty_factor);
  double sum = 0;
  for (const std::size_t i : watched_points(history)) {
    const PointResult<D>& point = history.results[i];
    if (has_penalty(law) ? !touches(point.state) : point.law_area == 0) continue;
    const double slope = contact::stiffness(law, point.gap, place_of(points_.reference[i]));
    sum += point.law_area * slope * point.law_area * slope;
  }
  return std::sqrt(sum);
}

template <int D> double GaussPointContact<D>::memory() const {
  double sum = Formulation<D>::memory();
  for (const SumPart<D>& part : parts_) sum += part.sums.memory();
  return sum;
}

template class GaussPointContact<2>;
template class GaussPointContact<3>;

} // namespace signorini::contact
