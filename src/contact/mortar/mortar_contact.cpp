#include "contact/mortar/mortar_contact.hpp"

#include "os/parallel.hpp"
#include "os/timer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace signorini::contact {

template <int D>
MortarContact<D>::MortarContact(const ContactSetting<D>& setting, const MortarLaw& law, Pass pass)
    : Formulation<D>(setting), law_(checked(law.penalty)), scale_(law.scale > 0 ? law.scale : law.penalty.normal),
      pass_(pass), functions_(this->slave_, this->points_, setting.points, law.multipliers),
      is_skipped_(this->slave_.elements(), false), cleared_(this->slave_.elements(), 0.0), sums_(functions_.count()),
      fractions_(functions_.count()), tangents_(functions_.count()), strips_(this->slave_.elements()) {
  for (const auto& [first, last] : pieces(this->points_))
    parts_.push_back({first,
                      last,
                      BlockSums<D>(this->slave(), this->master(), pass),
                      MultiplierRows<D>(this->slave(), this->master(), functions_),
                      {}});
  std::size_t sums = 0;
  for (int e = 0; e < this->slave_.elements(); ++e) {
    first_sum_.push_back(sums);
    sums += functions_.on(e).size();
  }
  element_sums_.resize(sums);
  if (!solves_multipliers()) return;
  conditions_.resize(functions_.count());
  whole_ = functions_.areas(this->points_);
}

template <int D> int MortarContact<D>::extra_unknowns() const {
  return solves_multipliers() ? functions_.count() * unknowns_per_multiplier<D>(may_rub(law_)) : 0;
}

// ── Gaps and slips weighted by multiplier ────────────────────────────────────────────────────────────────────────────

/// Whether a multiplier is open without a look at its gap.
template <int D> bool MortarContact<D>::is_far(int multiplier, const Trial<D>& trial) const {
  if (!this->active(trial.present)) return true;
  const auto& fixed = trial.controls.fixed_states;
  const FixedContactState state = fixed.empty() ? FixedContactState::free : fixed[multiplier];
  if (state != FixedContactState::free) return state == FixedContactState::open;
  const MultiplierHistory<D>& history = trial.present.multipliers[multiplier];
  // A multiplier with a pressure remains closed up to the gap pressure/ε.
  const double penalty = law(trial.present, solves_multipliers() ? 1 : trial.penalty_factor).normal;
  const double closed = (solves_multipliers() ? scale_ * unknowns_of<D>(trial.extra, multiplier, may_rub(law_)).normal
                                              : history.pressure) /
                        penalty;
  return this->travel_ + trial.controls.guessed + std::max(closed, 0.0) < history.cleared;
}

template <int D> void MortarContact<D>::evaluate_part(int index, const Trial<D>& trial, bool /*tangent*/) {
  Part& part = parts_[index];
  const auto& list = this->points_.list;
  Feet feet;
  for (std::size_t first = part.first, last = first; first < part.last; first = last) {
    const int element = list[first].element;
    const auto on = functions_.on(element);
    std::fill_n(element_sums_.begin() + static_cast<std::ptrdiff_t>(first_sum_[element]), on.size(),
                MultiplierSums<D>{});
    is_skipped_[element] = std::all_of(on.begin(), on.end(), [&](int a) { return is_far(a, trial); });
    double& cleared = cleared_[element] = std::numeric_limits<double>::infinity();
    for (; last < part.last && list[last].element == element; ++last) {
      PointResult<D>& result = trial.present.results[last];
      result = {};
      result.position = position(this->points_, this->slave(), last);
      if (!is_skipped_[element]) weigh(last, trial, part, feet);
      cleared = std::min(cleared, trial.present.points[last].cleared);
    }
  }
}

/// Area per parametric area on which tractions act: reference, in a half pass current.
template <int D> double MortarContact<D>::measure(std::size_t i, const Vec<D>& position) const {
  if (pass_ == Pass::full) return this->points_.list[i].reference_area;
  LocalGeometry<D> geometry;
  geometry.slave = position;
  geometry.slave_tangent = tangents(this->points_, this->slave(), i);
  geometry.revolved = this->points_.revolved;
  LocalRow<D> derivative;
  return slave_measure(geometry, derivative);
}

/// Projects point i and adds its gap and slip to the sums of the slave element's multipliers.
template <int D> void MortarContact<D>::weigh(std::size_t i, const Trial<D>& trial, Part& part, Feet& at) {
  PointResult<D>& result = trial.present.results[i];
  PointHistory<D>& point = trial.present.points[i];
  const Master<D>& master = this->master();
  at.foot.settled = true;
  {
    const ScopedTimer timer(this->times_search_ ? &part.search_seconds : nullptr);
    point.projection = master.project(result.position, point.projection, at.foot);
  }
  const auto& [foot, element, along, xi, gap, last] = point.projection;
  result.beyond = foot == Foot::none;
  result.settled = at.foot.settled;
  const double distance = gap - this->offset(i, trial.present);
  point.cleared = foot == Foot::regular && at.foot.settled && distance > 0 ? this->travel_ + distance : 0;
  FaceCoordinates<D> rate;
  const double fade = result.beyond || (foot != Foot::regular && gap == 0) ? 0 : master.fade(xi, rate);
  if (fade == 0) return;

  const ContactPoint& own = this->points_.list[i];
  MultiplierSums<D> one;
  one.area = own.weight * measure(i, result.position) * fade;
  one.gap = one.area * distance;
  const bool slides = frictional(trial.present);
  if (slides) {
    one.normal = one.area *
                 (foot == Foot::regular ? master.normal(at.foot) : Vec<D>((result.position - at.foot.position) / gap));
    one.along = one.area * tangents(this->points_, this->slave(), i)[0];
    if (!point.slips) remember_foot(i, trial);
    if (point.slips) {
      master.locate(point.slip, at.slip_point);
      one.slip = one.area * (at.foot.position - at.slip_point.position);
    }
    if (trial.controls.foresees) one.before = one.area * gap_before(i, trial, distance);
  }
  const std::size_t count = functions_.on(own.element).size();
  const double* values = functions_.at_point(i);
  MultiplierSums<D>* sums = element_sums_.data() + first_sum_[own.element];
  for (std::size_t a = 0; a < count; ++a) {
    sums[a].area += values[a] * one.area;
    sums[a].gap += values[a] * one.gap;
    if (!slides) continue;
    sums[a].normal += values[a] * one.normal;
    sums[a].slip += values[a] * one.slip;
    sums[a].along += values[a] * one.along;
    sums[a].before += values[a] * one.before;
  }
}

/// A point that was not projected in the accepted state slips from its foot point there.
template <int D> void MortarContact<D>::remember_foot(std::size_t i, const Trial<D>& trial) const {
  PointHistory<D>& point = trial.present.points[i];
  FacePoint<D> foot;
  const Projection<D> projection =
      this->accepted_master_.project(trial.accepted.results[i].position, point.projection, foot);
  if (projection.foot == Foot::none) return;
  point.slips = true;
  point.slip = projection.point();
}

// ── Pressures ────────────────────────────────────────────────────────────────────────────────────────────────────────

/// Sums over the elements of a multiplier.
template <int D> MultiplierSums<D> MortarContact<D>::sum_up(int multiplier) const {
  MultiplierSums<D> sum;
  for (const int element : functions_.support(multiplier)) {
    const auto on = functions_.on(element);
    const MultiplierSums<D>& part =
        element_sums_[first_sum_[element] +
                      (static_cast<int>(std::find(on.begin(), on.end(), multiplier) - on.begin()))];
    sum.area += part.area;
    sum.gap += part.gap;
    sum.normal += part.normal;
    sum.slip += part.slip;
    sum.along += part.along;
    sum.before += part.before;
  }
  return sum;
}

template <int D> void MortarContact<D>::decide(const Trial<D>& trial) {
  const PenaltyLaw law = this->law(trial.present, solves_multipliers() ? 1 : trial.penalty_factor);
  const Controls& controls = trial.controls;
  const double tie = controls.onward ? -controls.guessed : controls.guessed;
  for (int a = 0; a < functions_.count(); ++a) {
    MultiplierResult<D>& result = trial.present.multiplier_results[a];
    MultiplierHistory<D>& history = trial.present.multipliers[a];
    const bool far = is_far(a, trial);
    result = {};
    tangents_[a] = {};
    history.cleared = std::numeric_limits<double>::infinity();
    for (const int element : functions_.support(a)) history.cleared = std::min(history.cleared, cleared_[element]);
    const MultiplierSums<D>& sum = sums_[a] = far ? MultiplierSums<D>{} : sum_up(a);
    result.beyond = !far && sum.area == 0;
    const FixedContactState fixed = controls.fixed_states.empty() ? FixedContactState::free : controls.fixed_states[a];
    const MultiplierControl control{fixed, controls.guessed, tie, controls.landing};
    const bool open = far || result.beyond;
    fractions_[a] = 0;
    if (controls.foresees && !open && frictional(trial.present)) foresee_touch(a, sum, trial);
    if (!solves_multipliers()) {
      if (!open) tangents_[a] = mortar_law(law, sum, history, control, result);
      result.potential *= energy_share(pass_);
      continue;
    }
    const auto unknowns = unknowns_of<D>(trial.extra, a, may_rub(law_));
    conditions_[a] = open ? open_multiplier(scale_, whole_[a], unknowns)
                          : multiplier_law(law, scale_, sum, whole_[a], unknowns, history.touch, control, result);
  }
}

// ── Forces ───────────────────────────────────────────────────────────────────────────────────────────────────────────

/// Adds the tractions of a part's points to its blocks and, for the tangent, their rows to those of the multipliers.
template <int D> void MortarContact<D>::distribute(Part& part, const Trial<D>& trial, bool tangent) {
  part.rows.clear();
  const auto& list = this->points_.list;
  Feet feet;
  std::vector<double> weights;
  for (std::size_t first = part.first, last = first; first < part.last; first = last) {
    const int element = list[first].element;
    const auto on = functions_.on(element);
    const bool acts = !is_skipped_[element] && std::any_of(on.begin(), on.end(), [&](int a) {
      return trial.present.multiplier_results[a].state != ContactState::open;
    });
    for (; last < part.last && list[last].element == element; ++last)
      if (acts) add_point(last, trial, tangent, part, feet, weights);
    if (acts) part.sums.close_element(tangent);
  }
}

template <int D>
void MortarContact<D>::add_point(std::size_t i, const Trial<D>& trial, bool tangent, Part& part, Feet& at,
                                 std::vector<double>& weights) {
  const PointHistory<D>& point = trial.present.points[i];
  PointResult<D>& result = trial.present.results[i];
  const Projection<D>& projection = point.projection;
  if (result.beyond || (projection.foot != Foot::regular && projection.gap == 0)) return;
  const ContactPoint& own = this->points_.list[i];
  const auto on = functions_.on(own.element);
  const double* values = functions_.at_point(i);
  const double area = own.weight * own.reference_area;
  // p = Σ M_A z_A, t_T = Σ M_A t_A; the state is that of the multiplier with the largest part of p
  double pressure = 0, largest = -1;
  Vec<D> friction = Vec<D>::Zero();
  weights.assign(on.size(), 0);
  for (std::size_t a = 0; a < on.size(); ++a) {
    const MultiplierResult<D>& multiplier = trial.present.multiplier_results[on[a]];
    if (multiplier.state == ContactState::open || values[a] == 0) continue;
    const double share = values[a] * multiplier.pressure;
    pressure += share;
    friction += values[a] * multiplier.friction;
    weights[a] = area * values[a];
    if (std::abs(share) <= largest) continue;
    largest = std::abs(share);
    result.state = multiplier.state;
  }
  const Master<D>& master = this->master();
  master.locate(projection, at.foot);
  master.functions(at.foot, 1);
  LocalGeometry<D> geometry =
      point_geometry(this->points_, i, this->slave(), master, result.position, projection, at.foot);
  geometry.offset = this->offset(i, trial.present);
  if (geometry.fade == 0) return;
  LocalForce<D> force;
  const GapRows<D> gap = gap_rows(geometry, force.shift);
  const Vec<D> traction = pressure * geometry.normal - friction;
  LocalRow<D> measure_row = LocalRow<D>::Zero();
  force.measure = pass_ == Pass::full ? geometry.reference_measure : slave_measure(geometry, measure_row);
  fade_area(geometry, force.shift, force.measure, measure_row);
  force.force = force.measure * traction;
  force.tangent = (force.measure * pressure) * gap.normal;
  force.tangent.noalias() += traction * measure_row;
  part.sums.add(this->points_, i, at.foot, nullptr, force, tangent);

  result.gap = projection.gap - geometry.offset;
  result.pressure = pressure;
  for (int k = 0; k < D - 1; ++k) result.tangents.col(k) = geometry.slave_tangent[k];
  result.friction = friction;
  result.force = own.weight * force.force;
  result.area = own.weight * force.measure;
  if (!tangent) return;
  const FacePoint<D>* slip_point = nullptr;
  const bool slides = frictional(trial.present);
  if (slides && point.slips) {
    master.locate(point.slip, at.slip_point);
    slip_point = &at.slip_point;
  }
  // J = measure/reference measure
  const double ratio = force.measure / geometry.reference_measure;
  measure_row /= geometry.reference_measure;
  part.rows.add(this->points_, i, at.foot, slip_point,
                point_rows(geometry, gap, force.shift, ratio, measure_row, slip_point, slides),
                PointRows<D>::count(slides), ratio, weights.data());
}

// ── Coupling of a multiplier's unknowns ──────────────────────────────────────────────────────────────────────────────

template <int D> Block& MortarContact<D>::new_block() {
  if (spare_.empty()) spare_.emplace_back();
  Block& block = this->blocks_.emplace_back(std::move(spare_.back()));
  spare_.pop_back();
  return block;
}

/// Appends the blocks of multipliers that are unknowns.
template <int D> void MortarContact<D>::add_conditions(bool tangent) {
  for (int a = 0; a < functions_.count(); ++a) fill_conditions(conditions_[a], a, may_rub(law_), tangent, new_block());
  if (!tangent) return;
  for (const Part& part : parts_)
    for (const Strip& strip : part.rows.strips())
      fill_coupling(strip, this->slave(), this->master(), functions_, conditions_, scale_, may_rub(law_), new_block());
}

/// Appends a block for each group with a multiplier that is not open.
template <int D> void MortarContact<D>::couple_all(bool frictional) {
  for (auto& list : strips_) list.clear();
  for (const Part& part : parts_)
    for (const Strip& strip : part.rows.strips()) strips_[strip.slave_element].push_back(&strip);
  const auto& groups = functions_.groups();
  const std::size_t first = this->blocks_.size(), chunks = parts_.size();
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const auto& members = groups[g].members;
    if (std::all_of(members.begin(), members.end(), [&](int a) { return tangents_[a].pressure == 0; })) continue;
    Block& block = new_block();
    block.slave_element = block.master_element = block.slip_element = -1;
    block.group = static_cast<int>(g);
  }
  const std::size_t count = this->blocks_.size() - first;
  parallel(static_cast<int>(chunks), [&](int chunk) {
    const std::size_t own = chunk;
    for (std::size_t k = own * count / chunks; k < (own + 1) * count / chunks; ++k) {
      Block& block = this->blocks_[first + k];
      couple<D>(groups[block.group], functions_, sums_, tangents_, this->slave(), this->master(), strips_,
                PointRows<D>::count(frictional), pass_, parts_[own].space, block);
    }
  });
}

template <int D> void MortarContact<D>::gather(const Trial<D>& trial, bool tangent) {
  decide(trial);
  parallel(parts(), [&](int part) { distribute(parts_[part], trial, tangent); });
  for (Part& part : parts_) {
    part.blocks = part.sums.hand_over(this->blocks_);
    this->search_seconds_ += std::exchange(part.search_seconds, 0);
  }
  if (solves_multipliers())
    add_conditions(tangent);
  else if (tangent)
    couple_all(frictional(trial.present));
  if (trial.controls.foresees && frictional(trial.present)) move_feet(trial);
}

template <int D> void MortarContact<D>::take_back(std::vector<Block>& blocks) {
  auto block = blocks.begin();
  for (Part& part : parts_)
    for (; part.blocks > 0; --part.blocks) part.sums.recycle(std::move(*block++));
  std::move(block, blocks.end(), std::back_inserter(spare_));
  blocks.clear();
}

template <int D> double MortarContact<D>::memory() const {
  const auto bytes = [](const auto& list) { return static_cast<double>(list.capacity() * sizeof(list[0])); };
  double sum = Formulation<D>::memory() + functions_.memory() + bytes(element_sums_) + bytes(sums_) + bytes(tangents_);
  for (const Part& part : parts_) {
    sum += part.sums.memory();
    for (const Strip& strip : part.rows.strips()) sum += bytes(strip.rows) + bytes(strip.shares);
  }
  return sum;
}

template class MortarContact<2>;
template class MortarContact<3>;

} // namespace signorini::contact
