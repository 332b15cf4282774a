#include "contact/gauss/formulation.hpp"

#include "base/error.hpp"
#include "contact/gauss/set_points.hpp"
#include "contact/point/crossing.hpp"
#include "os/timer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace signorini::contact {

template <int D>
Formulation<D>::Formulation(ContactSetting<D> setting, std::optional<InterfaceLaw> law, Pass pass)
    : faces_{std::move(setting.slave), std::move(setting.master)},
      points_(faces_.slave, setting.points, setting.revolved, setting.where,
              setting.adaptive ? (2 * setting.points + 2) / 3 : 0),
      parameters_{setting.start, law, pass} {
  if (faces_.master.set()) make_set(points_, faces_.slave, pass == Pass::full ? 0.5 : 1);
  if (law) check(*law);
  require(D == 3 || !law || !law->ellipse, "contact.friction.plane");
  if (law && law->along) set_axes(points_, faces_.slave, Vec<D>(law->along->template head<D>()));
  if (!setting.start.interference) return;
  for (const double gap : gaps(*this, History<D>(points_))) parameters_.overlap.push_back(std::max(0.0, -gap));
}

template <int D> void Formulation<D>::move(const double* slave_displacement, const double* master_displacement) {
  faces_.travel += faces_.slave.move(slave_displacement);
  {
    const ScopedTimer timer(counters.times_search ? &counters.search_seconds : nullptr);
    faces_.travel += faces_.master.move(master_displacement, faces_.slave.points());
  }
  if (faces_.master.set()) faces_.master.note_motion(faces_.accepted);
  take_back(blocks_);
}

namespace {

template <int D> void count(FrictionFlaw flaw, const Vec<D>& place, ContactCounters<D>& counters) {
  if (flaw == FrictionFlaw::none) return;
  ++counters.flawed;
  counters.flawed_at = place;
  counters.flaw = flaw;
}

/// ½ (φ₀ + φ₁) (A₁ − A₀) of energies φ A over a step, zero of a point that is open before or after.
double growth(double before, double first, double after, double last) {
  return first == 0 || last == 0 ? 0 : 0.5 * (before / first + after / last) * (last - first);
}

/// The area on which the law of a multiplier acts.
template <int D> double law_area(const MultiplierResult<D>& result) {
  return result.state == ContactState::open ? 0 : result.area;
}

/// Adds ∫ p dg A to the potential of a result on whose area A a pressure acts that is a formula.
template <class Result>
double with_pressure(const Parameters& parameters, const Result& result, double area, const Vec<3>& place) {
  const bool acts = touches(result.state) || result.state == ContactState::adhesion;
  if (!acts || !parameters.law || !parameters.law->pressure) return result.potential;
  return result.potential + parameters.energy_share() * area * parameters.law->pressure->energy(result.gap, place);
}

} // namespace

template <int D> void Formulation<D>::commit(History<D>& present, const History<D>& accepted, double) {
  for (const std::size_t i : watched_points(present)) {
    if (!acts(points_, present, i)) continue;
    const PointResult<D>&before = accepted.results[i], &after = present.results[i];
    if (before.law_area != after.law_area)
      present.growth +=
          growth(potential(*this, accepted, i), before.law_area, potential(*this, present, i), after.law_area);
    present.offset_work += parameters_.energy_share() * 0.5 *
                           (before.pressure * before.area + after.pressure * after.area) *
                           (parameters_.offset(i, present.changes) - parameters_.offset(i, accepted.changes));
    count(after.flaw, points_.reference[i], counters);
    // The foot of a point without force tells only that it is open. Where it is near the center of curvature of a
    // concave face, all points of this are as near, and no search settles on one of them.
    if (after.settled || !(after.area > 0)) continue;
    ++counters.unsettled;
    counters.unsettled_at = points_.reference[i];
  }
  for (std::size_t a = 0; a < present.multipliers.size(); ++a) {
    const double first = law_area(accepted.multiplier_results[a]), last = law_area(present.multiplier_results[a]);
    if (first != last)
      present.growth +=
          growth(multiplier_potential(*this, accepted, a), first, multiplier_potential(*this, present, a), last);
    count(present.multiplier_results[a].flaw, points_.reference[multipliers()->points[a]], counters);
  }
  return_to_accepted();
}

template <int D> void Formulation<D>::settle(History<D>& accepted) {
  faces_.travel = 0;
  return_to_accepted();
  look_everywhere(accepted);
  for (std::size_t i = 0; i < points_.size(); ++i) accepted.results[i].position = position(points_, slave(), i);
}

template <int D> double Formulation<D>::memory() const {
  const auto bytes = [](const auto& list) { return static_cast<double>(list.capacity() * sizeof(list[0])); };
  double sum = bytes(points_.list) + bytes(points_.values) + bytes(points_.reference) + bytes(blocks_);
  for (const Block& block : blocks_) sum += bytes(block.force) + bytes(block.matrix);
  return sum;
}

template <int D> History<D> initial_history(const Formulation<D>& contact) {
  return History<D>(contact.points(), contact.multipliers() ? contact.multipliers()->count() : 0, contact.bonds());
}

template <int D> Vec<D> position(const Formulation<D>& contact, const History<D>& history, std::size_t i) {
  return is_watched(history, i) ? history.results[i].position : position(contact.points(), contact.slave(), i);
}

template <int D> std::vector<double> gaps(const Formulation<D>& contact, const History<D>& history) {
  std::vector<double> gaps;
  FacePoint<D> foot;
  for (std::size_t i = 0; i < history.points.size(); ++i) {
    const Projection<D> found = contact.master().project(position(contact, history, i), history.points[i].projection,
                                                         foot, lookout(contact.faces(), contact.points(), i));
    if (found.element < 0) {
      gaps.push_back(std::numeric_limits<double>::infinity());
      continue;
    }
    // Beyond an open end the distance has no sign.
    gaps.push_back((found.foot == Foot::none ? std::abs(found.gap) : found.gap) -
                   contact.parameters().offset(i, history));
  }
  return gaps;
}

template <int D> double potential(const Formulation<D>& contact, const History<D>& history, std::size_t i) {
  const PointResult<D>& result = history.results[i];
  return with_pressure(contact.parameters(), result, result.law_area, place_of(contact.points().reference[i]));
}

template <int D> double multiplier_potential(const Formulation<D>& contact, const History<D>& history, std::size_t a) {
  const MultiplierResult<D>& result = history.multiplier_results[a];
  const Vec<D>& place = contact.points().reference[contact.multipliers()->points[a]];
  return with_pressure(contact.parameters(), result, result.area, place_of(place));
}

template <int D> double potential(const Formulation<D>& contact, const History<D>& history) {
  double sum = 0;
  for (const std::size_t i : watched_points(history)) sum += potential(contact, history, i);
  for (std::size_t a = 0; a < history.multiplier_results.size(); ++a) sum += multiplier_potential(contact, history, a);
  return sum;
}

template <int D>
std::vector<int> crossed(const Formulation<D>& contact, const History<D>& present, const History<D>& accepted) {
  const Faces<D>& faces = contact.faces();
  const ContactPoints<D>& points = contact.points();
  const Parameters& parameters = contact.parameters();
  std::vector<int> numbers;
  if (!parameters.active(present.changes) || !parameters.active(accepted.changes)) return numbers;
  const double master_moved = faces.master_moved();
  bool alone = false;
  for (const std::size_t i : watched_points(present)) {
    const PointHistory<D>& point = present.points[i];
    const PointResult<D>& result = present.results[i];
    if (faces.master.set() && is_first_of_element(points, i))
      alone = is_alone(contact, points.list[i].element, present, accepted);
    if (alone || !acts(points, present, i) || result.beyond) continue;
    if (faces.master.set()) {
      if (has_passed_through(contact, i, present, accepted, master_moved)) numbers.push_back(static_cast<int>(i));
      continue;
    }
    const double touching = parameters.offset(i, present);
    const Vec<D>& before = accepted.results[i].position;
    const double moved = (result.position - before).norm() + master_moved;
    if (touches(result.state)) continue;
    // Points at a distance of more than their approach need no test.
    const double least = point.cleared > 0 ? point.cleared - faces.travel + touching : point.projection.gap;
    if (moved <= 0 || least > moved) continue;
    const Vec<D> outward = normal_at(points, faces.slave, i);
    if (has_crossed(faces.accepted, faces.master, before, result.position, outward, point.projection,
                    std::min(0.0, touching)))
      numbers.push_back(static_cast<int>(i));
  }
  return numbers;
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template class Formulation<D>;                                                                                       \
  template History<D> initial_history(const Formulation<D>&);                                                          \
  template Vec<D> position(const Formulation<D>&, const History<D>&, std::size_t);                                     \
  template std::vector<double> gaps(const Formulation<D>&, const History<D>&);                                         \
  template double potential(const Formulation<D>&, const History<D>&, std::size_t);                                    \
  template double multiplier_potential(const Formulation<D>&, const History<D>&, std::size_t);                         \
  template double potential(const Formulation<D>&, const History<D>&);                                                 \
  template std::vector<int> crossed(const Formulation<D>&, const History<D>&, const History<D>&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::contact
