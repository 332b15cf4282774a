#include "contact/mortar/mortar_contact.hpp"

#include "contact/point/touch.hpp"
#include "contact/point/unfold.hpp"
#include "os/parallel.hpp"
#include "os/timer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace signorini::contact {

template <int D>
MortarContact<D>::MortarContact(const ContactSetting<D>& setting, const InterfaceLaw& law, MultiplierSpace multipliers,
                                Pass pass)
    : Formulation<D>(setting, law, pass),
      functions_(faces_.slave, points_, setting.points, multipliers), multipliers_{functions_.largest()},
      parts_(parts_of(faces_, points_, pass)), rows_(parts_.size(), MultiplierRows<D>(faces_, functions_)),
      element_sums_(functions_, faces_.slave.elements()), weighted_(functions_.count()),
      coupling_(faces_, functions_, pass, parts_.size()) {}

// ── Gaps and slips weighted by multiplier ────────────────────────────────────────────────────────────────────────────

/// True if a multiplier is open without a look at its gap.
template <int D> bool MortarContact<D>::is_far(int multiplier, const Trial<D>& trial) const {
  if (!parameters_.active(trial.present.changes)) return true;
  const FixedContactState state = trial.controls.fixed(multiplier);
  if (state != FixedContactState::free) return state == FixedContactState::open;
  return faces_.travel + trial.controls.guessed < trial.present.multipliers[multiplier].cleared;
}

template <int D> void MortarContact<D>::evaluate_part(int index, const Trial<D>& trial, bool /*tangent*/) {
  SumPart<D>& part = parts_[index];
  const auto& list = points_.list;
  FootPoints<D> feet;
  for (std::size_t first = part.first, last = first; first < part.last; first = last) {
    const int element = list[first].element;
    const bool far = std::ranges::all_of(functions_.on(element), [&](int a) { return is_far(a, trial); });
    element_sums_.start(element, far);
    for (; last < part.last && list[last].element == element; ++last) {
      PointResult<D>& result = trial.present.results[last];
      result = {};
      result.position = position(points_, faces_.slave, last);
      if (!far) weigh(last, trial, feet, this->counters.times_search ? &part.search_seconds : nullptr);
      element_sums_.clear_up_to(element, trial.present.points[last].cleared);
    }
  }
}

/// Area per parametric area on which tractions act: reference, in a half pass current.
template <int D> double MortarContact<D>::measure(std::size_t i, const Vec<D>& position) const {
  return parameters_.pass == Pass::full ? points_.list[i].reference_area
                                        : slave_measure(points_, faces_.slave, i, position);
}

/// Projects point i and adds its gap and slip to the sums of the slave element's multipliers.
template <int D>
void MortarContact<D>::weigh(std::size_t i, const Trial<D>& trial, FootPoints<D>& feet, double* seconds) {
  PointResult<D>& result = trial.present.results[i];
  PointHistory<D>& point = trial.present.points[i];
  const Master<D>& master = faces_.master;
  {
    const ScopedTimer timer(seconds);
    find_foot(master, point, result, feet.foot);
  }
  const auto& [foot, element, along, xi, gap, last] = point.projection;
  const double distance = gap - parameters_.offset(i, trial.present.changes);
  const double clear = distance - reach(*parameters_.law);
  point.cleared = foot == Foot::regular && feet.foot.settled && clear > 0 ? faces_.travel + clear : 0;
  FaceCoordinates<D> rate;
  const double fade = result.beyond || (foot != Foot::regular && gap == 0) ? 0 : master.fade(xi, rate);
  if (fade == 0) return;

  const ContactPoint& own = points_.list[i];
  MultiplierSums<D> one;
  one.area = own.weight * measure(i, result.position) * fade;
  one.gap = one.area * distance;
  if (frictional(trial.present)) {
    one.normal = one.area * contact_normal(master, point.projection, feet.foot, result.position);
    one.along = one.area * direction_of<D>(points_.axis(i), tangents(points_, faces_.slave, i));
    if (!point.slips)
      // A point that was not projected in the accepted state slips from its foot point there.
      if (const auto from = faces_.accepted_foot(trial.accepted.results[i].position, point.projection)) {
        point.slips = true;
        point.slip = *from;
      }
    if (point.slips) {
      locate_slip(faces_, point.slip, feet.foot, feet.slip_point);
      one.slip = one.area * (feet.foot.position - feet.slip_point.position);
    }
    if (trial.controls.foresees) one.before = one.area * gap_before(i, trial, distance);
  }
  element_sums_.add(own.element, i, one);
}

// ── Pressures ────────────────────────────────────────────────────────────────────────────────────────────────────────

template <int D> void MortarContact<D>::decide(const Trial<D>& trial) {
  const InterfaceLaw law = parameters_.law_in(trial.present.changes, trial.penalty_factor);
  const Controls& controls = trial.controls;
  for (int a = 0; a < functions_.count(); ++a) {
    MultiplierResult<D>& result = trial.present.multiplier_results[a];
    MultiplierHistory<D>& history = trial.present.multipliers[a];
    WeightedMultiplier<D>& own = weighted_[a] = {};
    const bool far = is_far(a, trial);
    result = {};
    history.cleared = element_sums_.cleared(a);
    if (!far) own.sums = element_sums_.sum(a);
    result.beyond = !far && own.sums.area == 0;
    std::optional<FixedContactState> closed;
    if (!far && !result.beyond) {
      result.area = own.sums.area;
      result.gap = own.sums.gap / own.sums.area + history.worn;
      // V*_A = s*_A V_A for a multiplier that is open in the accepted state and closed at the guess, with V_A of the
      // guess and the fraction s*_A of the step at which its gap closes on the way to it.
      if (controls.foresees && frictional(trial.present) && result.gap < 0 &&
          trial.accepted.multiplier_results[a].state == ContactState::open) {
        const double worn = history.worn * own.sums.area;
        own.fraction = touch_fraction(own.sums.before + worn, own.sums.gap + worn);
        history.touch = own.fraction * (own.sums.slip / own.sums.area);
      }
      closed = controls.closed(a, result.gap - reach(law));
    }
    if (!closed) continue;
    FrictionControl control{*closed, controls.tie()};
    if (law.coefficient || law.pressure || law.wear)
      control.interface = {trial.duration, history.slipped, history.recent,
                           place_of(points_.reference[multipliers_.points[a]])};
    own.tangent = mortar_law(law, own.sums, history, control, result);
    result.potential *= parameters_.energy_share();
    result.gap += result.worn;
  }
}

// ── Forces ───────────────────────────────────────────────────────────────────────────────────────────────────────────

/// Adds the tractions of a part's points to its blocks and, for the tangent, their rows to those of the multipliers.
template <int D> void MortarContact<D>::distribute(int index, const Trial<D>& trial, bool tangent) {
  SumPart<D>& part = parts_[index];
  rows_[index].clear();
  const auto& list = points_.list;
  FootPoints<D> feet;
  std::vector<double> weights;
  for (std::size_t first = part.first, last = first; first < part.last; first = last) {
    const int element = list[first].element;
    const bool acts = !element_sums_.skipped(element) && std::ranges::any_of(functions_.on(element), [&](int a) {
      return trial.present.multiplier_results[a].state != ContactState::open;
    });
    for (; last < part.last && list[last].element == element; ++last)
      if (acts) add_point(last, index, trial, tangent, feet, weights);
    if (acts) part.sums.close_element(tangent);
  }
}

template <int D>
void MortarContact<D>::add_point(std::size_t i, int part, const Trial<D>& trial, bool tangent, FootPoints<D>& feet,
                                 std::vector<double>& weights) {
  const PointHistory<D>& point = trial.present.points[i];
  PointResult<D>& result = trial.present.results[i];
  const Projection<D>& projection = point.projection;
  if (result.beyond || (projection.foot != Foot::regular && projection.gap == 0)) return;
  const ContactPoint& own = points_.list[i];
  const auto on = functions_.on(own.element);
  const double* values = functions_.at_point(i);
  const double area = reference_area(own);
  // p = Σ M_A z_A, t_T = Σ M_A t_A; the state is that of the multiplier with the largest part of p
  double pressure = 0, largest = -1, worn = point.worn;
  Vec<D> friction = Vec<D>::Zero();
  weights.assign(on.size(), 0);
  for (std::size_t a = 0; a < on.size(); ++a) {
    const MultiplierResult<D>& multiplier = trial.present.multiplier_results[on[a]];
    if (multiplier.state == ContactState::open || values[a] == 0) continue;
    const double share = values[a] * multiplier.pressure;
    pressure += share;
    friction += values[a] * multiplier.friction;
    result.mu += values[a] * multiplier.mu;
    worn += values[a] * multiplier.worn;
    weights[a] = area * values[a];
    if (std::abs(share) <= largest) continue;
    largest = std::abs(share);
    result.state = multiplier.state;
  }
  const Master<D>& master = faces_.master;
  master.locate(projection, feet.foot);
  master.functions(feet.foot, 1);
  LocalGeometry<D> geometry = point_geometry(points_, i, faces_, result.position, projection, feet.foot);
  geometry.offset = parameters_.offset(i, trial.present.changes);
  if (geometry.fade == 0) return;
  LocalForce<D> force;
  const GapRows<D> gap = gap_rows(geometry, force.shift);
  const Vec<D> traction = pressure * geometry.normal - friction;
  LocalRow<D> measure_row = LocalRow<D>::Zero();
  force.measure = parameters_.pass == Pass::full ? geometry.reference_measure : slave_measure(geometry, measure_row);
  fade_area(geometry, force.shift, force.measure, measure_row);
  force.force = force.measure * traction;
  force.tangent = (force.measure * pressure) * gap.normal;
  force.tangent.noalias() += traction * measure_row;
  parts_[part].sums.add(points_, i, feet.foot, nullptr, force, tangent);

  result.gap = projection.gap - geometry.offset + worn;
  result.pressure = pressure;
  for (int k = 0; k < D - 1; ++k) result.tangents.col(k) = geometry.slave_tangent[k];
  result.friction = friction;
  result.force = own.weight * force.force;
  result.area = own.weight * force.measure;
  if (!tangent) return;
  const FacePoint<D>* slip_point = nullptr;
  const bool slides = frictional(trial.present);
  if (slides && point.slips) {
    locate_slip(faces_, point.slip, feet.foot, feet.slip_point);
    slip_point = &feet.slip_point;
  }
  // J = measure/reference measure
  const double ratio = force.measure / geometry.reference_measure;
  measure_row /= geometry.reference_measure;
  rows_[part].add(points_, i, feet.foot, slip_point,
                  point_rows(geometry, gap, force.shift, ratio, measure_row, slip_point, slides),
                  PointRows<D>::count(slides), ratio, weights);
}

// ── Coupling below a multiplier ──────────────────────────────────────────────────────────────────────────────────────

/// Appends a block for each group with a multiplier that is not open.
template <int D> void MortarContact<D>::couple(bool frictional) {
  coupling_.collect(rows_);
  const auto& groups = functions_.groups();
  const std::size_t first = blocks_.size(), chunks = parts_.size();
  for (int g = 0; g < std::ssize(groups); ++g) {
    if (std::ranges::all_of(groups[g].members, [&](int a) { return weighted_[a].tangent.pressure == 0; })) continue;
    Block& block = reuse(spare_, blocks_);
    block.slave_element = block.master_element = block.slip_element = -1;
    block.group = g;
  }
  const std::size_t count = blocks_.size() - first;
  parallel(static_cast<int>(chunks), [&](int chunk) {
    const std::size_t own = chunk;
    for (std::size_t k = own * count / chunks; k < (own + 1) * count / chunks; ++k)
      coupling_.fill(weighted_, frictional, chunk, blocks_[first + k]);
  });
}

template <int D> void MortarContact<D>::gather(const Trial<D>& trial, bool tangent) {
  decide(trial);
  parallel(parts(), [&](int part) { distribute(part, trial, tangent); });
  hand_over(parts_, blocks_, this->counters.search_seconds);
  if (tangent) couple(frictional(trial.present));
  if (trial.controls.foresees && frictional(trial.present)) move_slip_points(trial);
}

template <int D> void MortarContact<D>::take_back(std::vector<Block>& blocks) {
  auto block = blocks.begin();
  for (SumPart<D>& part : parts_) part.sums.take_back(block);
  std::move(block, blocks.end(), std::back_inserter(spare_));
  blocks.clear();
}

template <int D> double MortarContact<D>::memory() const {
  const auto bytes = [](const auto& list) { return static_cast<double>(list.capacity() * sizeof(list[0])); };
  double sum = Formulation<D>::memory() + functions_.memory() + element_sums_.memory() + bytes(weighted_);
  for (const SumPart<D>& part : parts_) sum += part.sums.memory();
  for (const MultiplierRows<D>& part : rows_)
    for (const Strip& strip : part.strips()) sum += bytes(strip.rows) + bytes(strip.shares);
  return sum;
}

// ── From one accepted step to the next ───────────────────────────────────────────────────────────────────────────────

template <int D> void MortarContact<D>::commit(History<D>& present, const History<D>& accepted, double penalty_factor) {
  if (frictional(present))
    advance(present, accepted);
  else if (may_rub(*parameters_.law))
    release(present, accepted, parameters_.law_in(accepted.changes, penalty_factor).tangential);
  Formulation<D>::commit(present, accepted, penalty_factor);
}

/// Sums the work of friction; the next step slips from the present foot points.
template <int D> void MortarContact<D>::advance(History<D>& present, const History<D>& accepted) const {
  const double before = parameters_.friction(accepted.changes), friction = parameters_.friction(present.changes);
  for (std::size_t a = 0; a < present.multipliers.size(); ++a) {
    MultiplierHistory<D>& history = present.multipliers[a];
    const MultiplierResult<D>& result = present.multiplier_results[a];
    const bool open = result.state == ContactState::open;
    const double limit = open ? 0 : result.mu * result.pressure * result.area;
    const MultiplierResult<D>& last = accepted.multiplier_results[a];
    const double before_slip = limit_before(history.limit, before, friction, last.friction.norm() * last.area);
    // ∫ μ z dγ a by the trapezoidal rule
    present.dissipated += parameters_.energy_share() * 0.5 * (before_slip + limit) * result.slipped;
    history.limit = limit;
    history.elastic = result.elastic;
    history.touch.setZero();
    add_slip(history, result.state, result.state == ContactState::slip ? result.slipped : 0);
  }
  for (std::size_t i = 0; i < present.points.size(); ++i) {
    PointHistory<D>& point = present.points[i];
    point.slips = !element_sums_.skipped(points_.list[i].element) && point.projection.foot != Foot::none;
    point.slip = point.projection.point();
  }
  if (parameters_.wears()) wear(present, accepted);
  spread(present);
}

/// Gives the points what the multipliers have slipped and worn, Σ M_A γ_A and Σ M_A w_A.
template <int D> void MortarContact<D>::spread(History<D>& present) const {
  for (std::size_t i = 0; i < present.points.size(); ++i) {
    PointHistory<D>& point = present.points[i];
    point.slipped = point.worn = 0;
    const double* value = functions_.at_point(i);
    for (const int a : functions_.on(points_.list[i].element)) {
      point.slipped += *value * present.multipliers[a].slipped;
      point.worn += *value++ * present.multipliers[a].worn;
    }
  }
}

/// Adds what the multipliers have worn in an accepted step.
template <int D> void MortarContact<D>::wear(History<D>& present, const History<D>& accepted) const {
  const double share = parameters_.energy_share();
  for (std::size_t a = 0; a < present.multipliers.size(); ++a) {
    const MultiplierResult<D>&result = present.multiplier_results[a], &last = accepted.multiplier_results[a];
    present.worn_volume += share * result.area * result.worn;
    present.wear += share * 0.5 * (last.pressure * last.area + result.pressure * result.area) * result.worn;
    present.multipliers[a].worn += result.worn;
  }
}

/// Friction that a path switches off leaves no history: later friction starts at the foot points of its time. The
/// energy of its springs is dissipated.
template <int D>
void MortarContact<D>::release(History<D>& present, const History<D>& accepted, double tangential) const {
  for (std::size_t a = 0; a < present.multipliers.size(); ++a) {
    MultiplierHistory<D>& history = present.multipliers[a];
    present.dissipated += parameters_.energy_share() * 0.5 * tangential * history.elastic.squaredNorm() *
                          accepted.multiplier_results[a].area;
    history.limit = history.slipped = history.recent = 0;
    history.elastic.setZero();
    history.touch.setZero();
  }
  for (PointHistory<D>& point : present.points) {
    point.slips = false;
    point.slipped = 0;
  }
}

template <int D> double MortarContact<D>::stiffness(const History<D>& history, double penalty_factor) const {
  const InterfaceLaw law = parameters_.law_in(history.changes, penalty_factor);
  double sum = 0;
  for (int a = 0; a < functions_.count(); ++a) {
    const MultiplierResult<D>& result = history.multiplier_results[a];
    if (result.state == ContactState::open) continue;
    const double slope = contact::stiffness(law, result.gap, place_of(points_.reference[multipliers_.points[a]]));
    sum += result.area * slope * result.area * slope;
  }
  return std::sqrt(sum);
}

template class MortarContact<2>;
template class MortarContact<3>;

} // namespace signorini::contact
