#include "solve/pattern.hpp"

#include "base/index.hpp"

#include <algorithm>
#include <iterator>

namespace signorini::solve {

namespace {

void make_distinct(std::vector<int>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
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

Pattern extend(const Pattern& base, const std::vector<std::vector<int>>& groups, std::vector<int>& moved) {
  std::vector<std::vector<int>> added(at(base.size));
  std::vector<int> members;
  for (const auto& group : groups) {
    members = group;
    make_distinct(members);
    const auto first = std::lower_bound(members.begin(), members.end(), 0);
    for (auto column = first; column != members.end(); ++column)
      added[at(*column)].insert(added[at(*column)].end(), first, members.end());
  }

  Pattern result;
  result.size = base.size;
  result.starts.push_back(0);
  result.rows.reserve(base.rows.size());
  moved.resize(base.rows.size());
  for (std::size_t j = 0; j < added.size(); ++j) {
    auto& list = added[j];
    make_distinct(list);
    const auto from = base.rows.begin() + base.starts[j], to = base.rows.begin() + base.starts[j + 1];
    std::set_union(from, to, list.begin(), list.end(), std::back_inserter(result.rows));
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
