#include "solve/pattern.hpp"

#include "base/error.hpp"
#include "base/index.hpp"

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

/// Whether columns j and j − 1 are in the same groups, as those of one node: then their rows are the same.
bool same_groups(const Membership& member, std::size_t j) {
  const auto at = [&](std::size_t column) {
    return member.groups.begin() + static_cast<std::ptrdiff_t>(member.starts[column]);
  };
  return j > 0 && std::equal(at(j - 1), at(j), at(j), at(j + 1));
}

Membership membership(int size, const std::vector<std::vector<int>>& groups) {
  Membership result;
  result.starts.assign(at(size) + 1, 0);
  for (const auto& group : groups)
    for (int j : group)
      if (j >= 0) ++result.starts[at(j) + 1];
  std::partial_sum(result.starts.begin(), result.starts.end(), result.starts.begin());
  result.groups.resize(result.starts.back());
  std::vector<std::size_t> next(result.starts.begin(), result.starts.end() - 1);
  for (std::size_t k = 0; k < groups.size(); ++k)
    for (int j : groups[k])
      if (j >= 0) result.groups[next[at(j)]++] = k;
  return result;
}

} // namespace

int Pattern::find(int row, int column) const {
  const auto from = rows.begin() + starts[at(column)];
  const auto to = rows.begin() + starts[at(column) + 1];
  const auto it = std::lower_bound(from, to, row);
  return it != to && *it == row ? static_cast<int>(it - rows.begin()) : -1;
}

Pattern couple(int size, const std::vector<std::vector<int>>& groups) {
  Pattern diagonal;
  diagonal.size = size;
  for (int j = 0; j < size; ++j) {
    diagonal.starts.push_back(j);
    diagonal.rows.push_back(j);
  }
  diagonal.starts.push_back(size);
  std::vector<int> moved;
  return extend(diagonal, groups, moved);
}

/// Positions are of type int.
static void require_countable(const Pattern& pattern) {
  if (pattern.rows.size() > std::numeric_limits<int>::max()) fail("solve.pattern.entries", {{"size", pattern.size}});
}

Pattern extend(const Pattern& base, const std::vector<std::vector<int>>& groups, std::vector<int>& moved) {
  const Membership member = membership(base.size, groups);
  Pattern result;
  result.size = base.size;
  result.starts.push_back(0);
  result.rows.reserve(base.rows.size());
  moved.resize(base.rows.size());
  std::vector<int> list, listed_for(at(base.size), -1);
  for (int column = 0; column < base.size; ++column) {
    const std::size_t j = at(column);
    const auto from = base.rows.begin() + base.starts[j], to = base.rows.begin() + base.starts[j + 1];
    if (member.starts[j] == member.starts[j + 1]) {
      std::iota(moved.begin() + base.starts[j], moved.begin() + base.starts[j + 1], result.entries());
      result.rows.insert(result.rows.end(), from, to);
      require_countable(result);
      result.starts.push_back(result.entries());
      continue;
    }
    if (!same_groups(member, j)) {
      list.clear();
      for (std::size_t k = member.starts[j]; k < member.starts[j + 1]; ++k)
        for (int i : groups[member.groups[k]])
          if (i >= 0 && std::exchange(listed_for[at(i)], column) != column) list.push_back(i);
      std::sort(list.begin(), list.end());
    }
    std::set_union(from, to, list.begin(), list.end(), std::back_inserter(result.rows));
    require_countable(result);
    int position = result.starts.back();
    for (auto it = from; it != to; ++it, ++position) {
      while (result.rows[at(position)] != *it) ++position;
      moved[static_cast<std::size_t>(it - base.rows.begin())] = position;
    }
    result.starts.push_back(static_cast<int>(result.rows.size()));
  }
  return result;
}

} // namespace signorini::solve
