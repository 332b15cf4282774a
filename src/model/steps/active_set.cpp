#include "model/steps/active_set.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::model {

namespace {

/// Rule of the freeze (thesis 4.5.2) [theory 10.1]: constraints stay open or closed as in the accepted state until
/// |f·Δu| is below the fraction `freeze` of its first value. A freeze that has ended does not begin again in the same
/// step.
bool freezes(const ActiveSetOptions& options, const std::vector<double>& energies) {
  return options.freeze > 0 && (energies.empty() || energies.back() / energies.front() >= options.freeze);
}

/// Rule of fixed constraints: those whose state has changed more often than `changes` times in a step keep it until the
/// others have converged.
bool changes_too_often(const ActiveSetOptions& options, int changes) {
  return options.changes > 0 && changes > options.changes;
}

constexpr unsigned char beyond = 255;

/// State as a code. Adhesive and bonded states count as open, because the traction is continuous in them.
unsigned char code(const contact::Constraint& constraint) {
  if (constraint.beyond) return beyond;
  return static_cast<unsigned char>(touches(constraint.state) ? constraint.state : contact::ContactState::open);
}

bool is_closed(unsigned char code) {
  return code != beyond && touches(static_cast<contact::ContactState>(code));
}

/// Slipping points are fixed to stick, because the direction of slip would change in every iteration.
contact::FixedContactState fixed_state_for(contact::ContactState state) {
  return touches(state) ? contact::FixedContactState::stick : contact::FixedContactState::open;
}

} // namespace

template <int D>
void ActiveSet<D>::begin(const contact::Formulations<D>& contacts, const Histories& histories,
                         const ActiveSetOptions& options) {
  *this = {};
  options_ = options;
  phase_ = freezes(options, {}) ? Phase::frozen : Phase::free;
  fixed_.resize(contacts.size());
  int count = 0;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    contacts_.push_back(
        {count, count + constraints(histories[k]), contacts[k]->parameters().friction(histories[k].changes) > 0,
         contacts[k]->multipliers() != nullptr, contacts[k]->extra_unknowns() > 0, &contacts[k]->parameters()});
    count += constraints(histories[k]);
    for (int i = 0; phase_ == Phase::frozen && i < constraints(histories[k]); ++i)
      fixed_[k].push_back(touches(constraint(histories[k], i).state) ? contact::FixedContactState::touching
                                                                     : contact::FixedContactState::open);
  }
  counts_.assign(count, 0);
}

template <int D> void ActiveSet<D>::release() {
  for (auto& fixed : fixed_) fixed.clear();
  phase_ = Phase::free;
}

template <int D> bool ActiveSet<D>::update(const std::vector<double>& energies) {
  const bool ends = phase_ == Phase::held || (phase_ == Phase::frozen && !freezes(options_, energies));
  if (ends) release();
  return ends;
}

template <int D> bool ActiveSet<D>::record(const Histories& histories, double residual, bool begins) {
  entries_.push_back(entry(histories, residual));
  if (entries_.size() > remembered_evaluations) entries_.pop_front();
  if (phase_ == Phase::free) fix_changing(histories);
  if (begins) {
    std::ranges::fill(entries_.back().frictions, Vec<D>::Zero());
    return false;
  }
  const bool sticks = stick_reversed(), retained = retain();
  return sticks || retained;
}

template <int D> typename ActiveSet<D>::Entry ActiveSet<D>::entry(const Histories& histories, double residual) const {
  Entry entry{residual};
  const std::size_t count = contacts_.empty() ? 0 : contacts_.back().last;
  entry.states.assign(count, static_cast<unsigned char>(contact::ContactState::open));
  entry.gaps.resize(count);
  const bool reverses = std::ranges::any_of(contacts_, &ContactEntry::has_multipliers);
  if (reverses) entry.frictions.assign(count, Vec<D>::Zero());
  for (std::size_t k = 0; k < histories.size(); ++k) {
    const contact::History<D>& history = histories[k];
    const bool points = history.multipliers.empty();
    const auto add = [&](int i) {
      const int n = contacts_[k].first + i;
      const contact::Constraint one = constraint(history, i);
      entry.states[n] = code(one);
      entry.closed += is_closed(entry.states[n]);
      // All that were closed in the last evaluation are projected in each.
      entry.gaps[n] = points ? history.points[i].projection.gap -
                                   contacts_[k].parameters->offset(static_cast<std::size_t>(i), history)
                             : history.multiplier_results[i].gap;
      if (reverses && one.state == contact::ContactState::slip)
        entry.frictions[n] = points ? history.results[i].friction : history.multiplier_results[i].friction;
    };
    for (int i = 0; i < constraints(history) && !points; ++i) add(i);
    for (const std::size_t i : watched_points(history))
      if (points) add(static_cast<int>(i));
  }
  return entry;
}

/// Hysteresis of penalties: under a stiff one penetrations are smaller than errors of linearized gaps, so that a
/// solution opens many constraints by tiny gaps, nothing holds the body any more, and all close again. Where many open
/// at once, those whose gap is small against its change since the evaluation before remain closed for this solution. At
/// convergence gaps do not change, and all are open. Returns true if any remains closed.
template <int D> bool ActiveSet<D>::retain() {
  if (entries_.size() < 2 || phase_ == Phase::frozen) return false;
  const Entry& before = entries_[entries_.size() - 2];
  Entry& now = entries_.back();
  if (now.states == before.states) return false; // nothing opens
  int closed = 0;
  std::vector<PointIndex> opened;
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    const ContactEntry& own = contacts_[k];
    for (int i = own.first; i < own.last && !own.solved && fixed_[k].empty(); ++i) {
      closed += is_closed(before.states[i]);
      if (is_closed(before.states[i]) && !is_closed(now.states[i]) && now.states[i] != beyond)
        opened.push_back({static_cast<int>(k), i - own.first});
    }
  }
  if (static_cast<double>(opened.size()) <= many_opened * closed) return false;
  bool any = false;
  for (const PointIndex& index : opened) {
    const ContactEntry& own = contacts_[index.contact];
    const int i = own.first + index.point;
    if (now.gaps[i] >= linearization_error * std::abs(now.gaps[i] - before.gaps[i])) continue;
    fixed_[index.contact].resize(own.last - own.first, contact::FixedContactState::free);
    // Where friction alone holds the body, points that stuck must still hold it.
    const bool stuck = before.states[i] == static_cast<unsigned char>(contact::ContactState::stick);
    fixed_[index.contact][index.point] =
        stuck ? contact::FixedContactState::stick : contact::FixedContactState::touching;
    now.states[i] = before.states[i];
    any = true;
  }
  if (any) phase_ = Phase::held;
  return any;
}

/// Slipping constraints whose friction opposes that of the last iteration stick in this evaluation: Newton's method has
/// passed over a state of stick, and would return, because the tangent of slip has no stiffness that stops it. They are
/// freed in the next iteration. Of contacts without multipliers pressures change less. Returns true if there are any.
template <int D> bool ActiveSet<D>::stick_reversed() {
  if (entries_.size() < 2 || phase_ != Phase::free) return false;
  const Entry& before = entries_[entries_.size() - 2];
  Entry& now = entries_.back();
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    const ContactEntry& own = contacts_[k];
    if (!own.has_multipliers() || !fixed_[k].empty()) continue;
    for (int i = own.first; i < own.last; ++i) {
      if (!(now.frictions[i].dot(before.frictions[i]) < 0)) continue;
      fixed_[k].resize(own.last - own.first, contact::FixedContactState::free);
      fixed_[k][i - own.first] = contact::FixedContactState::stick;
      now.states[i] = static_cast<unsigned char>(contact::ContactState::stick);
      now.frictions[i].setZero();
      phase_ = Phase::held;
    }
  }
  return phase_ == Phase::held;
}

template <int D> void ActiveSet<D>::fix_changing(const Histories& histories) {
  if (entries_.size() < 2) return;
  const std::vector<unsigned char>&states = entries_.back().states, &before = entries_[entries_.size() - 2].states;
  const auto often = [&](int changes) { return changes_too_often(options_, changes); };
  if (states != before)
    for (std::size_t i = 0; i < counts_.size(); ++i) counts_[i] += states[i] != before[i];
  for (std::size_t k = 0; k < histories.size(); ++k) {
    const int first = contacts_[k].first, count = contacts_[k].last - first;
    if (std::none_of(counts_.begin() + first, counts_.begin() + contacts_[k].last, often)) continue;
    fixed_[k].assign(count, contact::FixedContactState::free);
    for (int i = 0; i < count; ++i)
      if (often(counts_[first + i])) fixed_[k][i] = fixed_state_for(constraint(histories[k], i).state);
  }
}

template <int D> bool ActiveSet<D>::release_all() {
  const bool fixed = std::ranges::any_of(fixed_, [](const auto& one) { return !one.empty(); });
  if (phase_ != Phase::held) counts_.assign(counts_.size(), 0);
  if (phase_ == Phase::free && fixed) ++rounds_;
  release();
  return fixed;
}

template <int D> bool ActiveSet<D>::shrinks() const {
  const auto closed = [&](std::size_t from) {
    int sum = 0;
    for (std::size_t k = from; k < from + trend; ++k) sum += entries_[k].closed;
    return sum;
  };
  const std::size_t n = entries_.size();
  return n >= 2 * trend && closed(n - trend) < closed(n - 2 * trend);
}

template <int D> int ActiveSet<D>::period() const {
  const std::size_t n = entries_.size();
  for (std::size_t p = 2; 3 * p <= n; ++p) {
    bool repeats = true, changes = false;
    for (std::size_t i = n - 2 * p; i < n && repeats; ++i) {
      const Entry &now = entries_[i], &before = entries_[i - p];
      repeats = std::abs(now.residual - before.residual) <= same_residual * now.residual && now.states == before.states;
      changes = changes || now.states != entries_[i - 1].states;
    }
    if (repeats && changes) return static_cast<int>(p);
  }
  return 0;
}

/// Points with at least two changes of state in the last evaluations; `past_end`: only changes to or from beyond the
/// master's end count.
template <int D> std::vector<PointIndex> ActiveSet<D>::cycling_points(bool past_end) const {
  std::vector<int> changes(counts_.size(), 0), order;
  for (std::size_t k = entries_.size() - std::min(entries_.size(), recent_evaluations) + 1; k < entries_.size(); ++k)
    for (std::size_t i = 0; i < changes.size(); ++i) {
      const unsigned char now = entries_[k].states[i], before = entries_[k - 1].states[i];
      changes[i] += now != before && (!past_end || now == beyond || before == beyond);
    }
  for (int i = 0; i < std::ssize(changes); ++i)
    if (changes[i] >= 2) order.push_back(i);
  std::ranges::stable_sort(order, [&](int a, int b) { return changes[a] > changes[b]; });
  std::vector<PointIndex> points;
  for (const int i : order) {
    const auto after = std::ranges::upper_bound(contacts_, i, {}, &ContactEntry::first);
    points.push_back({static_cast<int>(after - contacts_.begin()) - 1, i - std::prev(after)->first});
  }
  return points;
}

template <int D> std::string ActiveSet<D>::alternating(const PointIndex& index) const {
  const std::size_t i = contacts_[index.contact].first + index.point;
  const bool frictional = contacts_[index.contact].frictional;
  const auto name = [&](unsigned char code) -> std::string {
    if (code == beyond) return "beyond";
    const auto state = static_cast<contact::ContactState>(code);
    return state == contact::ContactState::stick && !frictional ? "touching" : name_of(state);
  };
  // Backward, so that states are in the order of their last occurrence
  std::vector<unsigned char> met;
  std::string names;
  for (std::size_t k = 0; k < std::min(entries_.size(), recent_evaluations); ++k) {
    const unsigned char code = entries_[entries_.size() - 1 - k].states[i];
    if (std::find(met.begin(), met.end(), code) != met.end()) continue;
    met.push_back(code);
    names = names.empty() ? name(code) : name(code) + " / " + names;
  }
  return names;
}

template class ActiveSet<2>;
template class ActiveSet<3>;

} // namespace signorini::model
