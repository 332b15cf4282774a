#include "model/steps/active_set.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::model {

namespace {

constexpr unsigned char beyond = 255;

/// State as a code. Adhesive and bonded states count as open, because the traction is continuous in them.
unsigned char code(const contact::Constraint& constraint) {
  if (constraint.beyond) return beyond;
  return static_cast<unsigned char>(touches(constraint.state) ? constraint.state : contact::ContactState::open);
}

/// Slipping points are fixed to stick, because the direction of slip would change in every iteration.
contact::FixedContactState fixed_state_for(contact::ContactState state) {
  return touches(state) ? contact::FixedContactState::stick : contact::FixedContactState::open;
}

/// The same state, for the next evaluation.
contact::FixedContactState held_state(unsigned char code) {
  using contact::ContactState, contact::FixedContactState;
  if (code == beyond) return FixedContactState::free;
  const auto state = static_cast<ContactState>(code);
  return state == ContactState::open   ? FixedContactState::open
         : state == ContactState::slip ? FixedContactState::slip
                                       : FixedContactState::stick;
}

} // namespace

template <int D>
void ActiveSet<D>::begin(const contact::Formulations<D>& contacts, const Histories& histories,
                         const ActiveSetOptions& options, Controls& controls) {
  options_ = options;
  entries_.clear();
  first_.assign(1, 0);
  frictional_.clear();
  solved_.clear();
  reversed_.clear();
  frictions_.assign(contacts.size(), {});
  rounds_ = 0;
  held_ = false;
  frozen_ = options.freeze > 0;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    first_.push_back(first_.back() + constraints(histories[k]));
    frictional_.push_back(contacts[k]->friction(histories[k]) > 0);
    solved_.push_back(contacts[k]->multipliers() > 0 && contacts[k]->extra_unknowns() > 0);
    controls[k].fixed_states.clear();
    if (!frozen_) continue;
    for (int i = 0; i < constraints(histories[k]); ++i)
      controls[k].fixed_states.push_back(touches(constraint(histories[k], i).state)
                                             ? contact::FixedContactState::touching
                                             : contact::FixedContactState::open);
  }
  counts_.assign(first_.back(), 0);
}

template <int D> void ActiveSet<D>::stick_where_reversed(const Histories& histories, Controls& controls) {
  using contact::ContactState, contact::FixedContactState;
  for (const auto& [index, before] : std::exchange(reversed_, {})) {
    std::vector<FixedContactState>& fixed = controls[index.contact].fixed_states;
    if (fixed.empty()) continue; // freed meanwhile
    fixed[index.point] = before;
    if (std::all_of(fixed.begin(), fixed.end(), [](auto state) { return state == FixedContactState::free; }))
      fixed.clear();
  }
  for (std::size_t k = 0; k < histories.size(); ++k) {
    const auto& results = histories[k].multiplier_results;
    auto& before = frictions_[k];
    before.resize(results.size(), contact::FaceCoordinates<D>::Zero());
    for (std::size_t a = 0; a < results.size(); ++a) {
      const contact::FaceCoordinates<D> last = before[a];
      before[a].setZero();
      if (results[a].state == ContactState::slip) before[a] = results[a].components;
      if (!(before[a].dot(last) < 0)) continue;
      std::vector<FixedContactState>& fixed = controls[k].fixed_states;
      fixed.resize(results.size(), FixedContactState::free);
      reversed_.push_back({{static_cast<int>(k), static_cast<int>(a)}, fixed[a]});
      fixed[a] = FixedContactState::stick;
    }
  }
}

template <int D> void ActiveSet<D>::note(const Histories& histories, double residual, Controls& controls) {
  Entry entry{residual, {}};
  entry.states.reserve(counts_.size());
  for (const auto& history : histories)
    for (int i = 0; i < constraints(history); ++i) entry.states.push_back(code(constraint(history, i)));
  stick_where_reversed(histories, controls);
  if (!entries_.empty() && options_.changes > 0 && !frozen_) {
    const std::vector<unsigned char>& before = entries_.back().states;
    for (std::size_t i = 0; i < counts_.size(); ++i) counts_[i] += entry.states[i] != before[i];
    for (std::size_t k = 0; k < histories.size(); ++k) {
      const int count = constraints(histories[k]);
      const int* counts = counts_.data() + first_[k];
      if (std::none_of(counts, counts + count, [&](int changes) { return changes > options_.changes; })) continue;
      std::vector<contact::FixedContactState>& fixed = controls[k].fixed_states;
      fixed.assign(count, contact::FixedContactState::free);
      for (int i = 0; i < count; ++i)
        if (counts[i] > options_.changes) fixed[i] = fixed_state_for(constraint(histories[k], i).state);
    }
  }
  entries_.push_back(std::move(entry));
  if (entries_.size() > remembered_evaluations) entries_.pop_front();
}

template <int D>
bool ActiveSet<D>::hold_back(const Histories& histories, const std::function<double(const PointIndex&)>& violation,
                             Controls& controls) {
  if (entries_.size() < 2 || frozen_) return false;
  const std::vector<unsigned char>& before = entries_[entries_.size() - 2].states;
  std::vector<unsigned char>& now = entries_.back().states;
  std::vector<PointIndex> changed;
  for (std::size_t k = 0; k < histories.size(); ++k) {
    if (!solved_[k]) continue;
    if (!controls[k].fixed_states.empty()) return false;
    for (int i = first_[k]; i < first_[k + 1]; ++i)
      if (now[i] != before[i] && now[i] != beyond && before[i] != beyond)
        changed.push_back({static_cast<int>(k), i - first_[k]});
  }
  if (changed.size() <= 1) return false;
  // The same states twice are the beginning of a cycle, unless they are those of the accepted state, at the front.
  const bool again =
      std::any_of(entries_.begin() + 1, entries_.end() - 1, [&](const Entry& entry) { return entry.states == now; });
  if (!again) return false;
  std::vector<double> violations;
  for (const PointIndex& index : changed) violations.push_back(violation(index));
  const double least = (1 - same_violation) * *std::max_element(violations.begin(), violations.end());
  for (std::size_t c = 0; c < changed.size(); ++c) {
    const std::size_t i = first_[changed[c].contact] + changed[c].point;
    if (violations[c] < least) now[i] = before[i];
  }
  for (std::size_t k = 0; k < histories.size(); ++k)
    for (int i = first_[k]; i < first_[k + 1] && solved_[k]; ++i)
      controls[k].fixed_states.push_back(held_state(now[i]));
  held_ = true;
  return true;
}

template <int D> bool ActiveSet<D>::let_go(Controls& controls) {
  if (!held_) return false;
  for (auto& control : controls) control.fixed_states.clear();
  held_ = false;
  return true;
}

template <int D> void ActiveSet<D>::thaw(double ratio, Controls& controls) {
  if (!frozen_ || ratio >= options_.freeze) return;
  frozen_ = false;
  for (auto& control : controls) control.fixed_states.clear();
}

template <int D> bool ActiveSet<D>::release(Controls& controls) {
  bool fixed = false;
  for (auto& control : controls) {
    fixed = fixed || !control.fixed_states.empty();
    control.fixed_states.clear();
  }
  std::fill(counts_.begin(), counts_.end(), 0);
  if (fixed && !frozen_) ++rounds_;
  frozen_ = false;
  return fixed;
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

/// Number of changes of each point's state in the last evaluations; `past_end`: only changes to or from beyond the
/// master's end.
template <int D> std::vector<int> ActiveSet<D>::changes(bool past_end) const {
  std::vector<int> sums(counts_.size(), 0);
  for (std::size_t k = entries_.size() - std::min(entries_.size(), recent_evaluations) + 1; k < entries_.size(); ++k)
    for (std::size_t i = 0; i < sums.size(); ++i) {
      const unsigned char now = entries_[k].states[i], before = entries_[k - 1].states[i];
      sums[i] += now != before && (!past_end || now == beyond || before == beyond);
    }
  return sums;
}

template <int D> std::vector<PointIndex> ActiveSet<D>::points_with(const std::vector<int>& changes, int least) const {
  std::vector<int> order;
  for (std::size_t i = 0; i < changes.size(); ++i)
    if (changes[i] >= least) order.push_back(static_cast<int>(i));
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return changes[a] > changes[b]; });
  std::vector<PointIndex> points;
  for (int i : order) {
    const auto contact = std::upper_bound(first_.begin(), first_.end(), i) - first_.begin() - 1;
    points.push_back({static_cast<int>(contact), i - first_[contact]});
  }
  return points;
}

template <int D> std::vector<PointIndex> ActiveSet<D>::cycling_points() const {
  return points_with(changes(false), 2);
}

template <int D> std::string ActiveSet<D>::alternating(const PointIndex& index) const {
  const std::size_t i = first_[index.contact] + index.point;
  const bool frictional = frictional_[index.contact];
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

template <int D> std::vector<PointIndex> ActiveSet<D>::cycling_past_end() const {
  return points_with(changes(true), 2);
}

template class ActiveSet<2>;
template class ActiveSet<3>;

} // namespace signorini::model
