#include "solve/pattern.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

namespace signorini::solve {

namespace {

/// The groups of each unknown: of unknown j those numbered groups[starts[j] … starts[j+1]).
struct Membership {
  std::vector<std::size_t> starts, groups;
};

/// True if columns j and j − 1 are in the same groups, as those of one node: then their rows are the same.
bool same_groups(const Membership& member, std::size_t j) {
  const auto at = [&](std::size_t column) {
    return member.groups.begin() + static_cast<std::ptrdiff_t>(member.starts[column]);
  };
  return j > 0 && std::equal(at(j - 1), at(j), at(j), at(j + 1));
}

Membership membership(int size, const std::vector<std::vector<int>>& groups) {
  Membership result;
  result.starts.assign(size + 1, 0);
  for (const auto& group : groups)
    for (int j : group)
      if (j >= 0) ++result.starts[j + 1];
  std::partial_sum(result.starts.begin(), result.starts.end(), result.starts.begin());
  result.groups.resize(result.starts.back());
  std::vector<std::size_t> next(result.starts.begin(), result.starts.end() - 1);
  for (std::size_t k = 0; k < groups.size(); ++k)
    for (int j : groups[k])
      if (j >= 0) result.groups[next[j]++] = k;
  return result;
}

} // namespace

int Pattern::find(int row, int column) const {
  const auto from = rows.begin() + starts[column];
  const auto to = rows.begin() + starts[column + 1];
  const auto it = std::lower_bound(from, to, row);
  return it != to && *it == row ? static_cast<int>(it - rows.begin()) : -1;
}

/// Positions are of type int.
static void require_countable(const Pattern& pattern) {
  if (pattern.rows.size() > std::numeric_limits<int>::max()) fail("solve.pattern.entries", {{"size", pattern.size}});
}

namespace {

/// The sorted unknowns that share a group with an unknown, for one column after the other.
class Coupled {
public:
  Coupled(int size, const std::vector<std::vector<int>>& groups)
      : groups_(groups), member_(membership(size, groups)), listed_for_(size, -1) {}

  /// True if the unknown is in no group.
  bool alone(int column) const { return member_.starts[column] == member_.starts[column + 1]; }
  const std::vector<int>& list(int column) {
    const std::size_t j = column;
    if (same_groups(member_, j)) return list_;
    list_.clear();
    for (std::size_t k = member_.starts[j]; k < member_.starts[j + 1]; ++k)
      for (int i : groups_[member_.groups[k]])
        if (i >= 0 && std::exchange(listed_for_[i], column) != column) list_.push_back(i);
    std::sort(list_.begin(), list_.end());
    return list_;
  }

private:
  const std::vector<std::vector<int>>& groups_;
  Membership member_;
  std::vector<int> list_, listed_for_;
};

} // namespace

Pattern couple(int size, const std::vector<std::vector<int>>& groups) {
  Coupled coupled(size, groups);
  Pattern result{size, {0}, {}};
  result.starts.reserve(size + 1);
  for (int column = 0; column < size; ++column) {
    if (coupled.alone(column)) {
      result.rows.push_back(column);
    } else {
      const std::vector<int>& list = coupled.list(column); // which contains the column
      result.rows.insert(result.rows.end(), list.begin(), list.end());
    }
    require_countable(result);
    result.starts.push_back(result.entries());
  }
  return result;
}

Pattern extend(const Pattern& base, const std::vector<std::vector<int>>& groups, std::vector<int>& moved) {
  if (groups.empty()) {
    moved.resize(base.rows.size());
    std::iota(moved.begin(), moved.end(), 0);
    return base;
  }
  Coupled coupled(base.size, groups);
  Pattern result;
  result.size = base.size;
  result.starts.push_back(0);
  result.rows.reserve(base.rows.size());
  moved.resize(base.rows.size());
  for (int column = 0; column < base.size; ++column) {
    const std::size_t j = column;
    const auto from = base.rows.begin() + base.starts[j], to = base.rows.begin() + base.starts[j + 1];
    if (coupled.alone(column)) {
      std::iota(moved.begin() + base.starts[j], moved.begin() + base.starts[j + 1], result.entries());
      result.rows.insert(result.rows.end(), from, to);
      require_countable(result);
      result.starts.push_back(result.entries());
      continue;
    }
    const std::vector<int>& list = coupled.list(column);
    std::set_union(from, to, list.begin(), list.end(), std::back_inserter(result.rows));
    require_countable(result);
    int position = result.starts.back();
    for (auto it = from; it != to; ++it, ++position) {
      while (result.rows[position] != *it) ++position;
      moved[it - base.rows.begin()] = position;
    }
    result.starts.push_back(static_cast<int>(result.rows.size()));
  }
  return result;
}

} // namespace signorini::solve
