#pragma once
// Groups of numbers that belong together (union-find).

#include <algorithm>
#include <map>
#include <numeric>
#include <vector>

namespace signorini {

/// Numbers from 0, each at first in a group of its own; a group is represented by its lowest number.
class Groups {
public:
  explicit Groups(int count) : leader_(count) { std::iota(leader_.begin(), leader_.end(), 0); }

  void unite(int a, int b) {
    const int first = leader(a), second = leader(b);
    leader_[std::max(first, second)] = std::min(first, second);
  }

  /// The lowest number of a number's group.
  int leader(int number) const {
    while (leader_[number] != number) number = leader_[number];
    return number;
  }

  /// The groups of two or more numbers, both lists increasing.
  std::vector<std::vector<int>> all() const {
    std::map<int, std::vector<int>> members;
    for (int number = 0; number < std::ssize(leader_); ++number) members[leader(number)].push_back(number);
    std::vector<std::vector<int>> result;
    for (auto& [first, group] : members)
      if (group.size() > 1) result.push_back(std::move(group));
    return result;
  }

private:
  std::vector<int> leader_;
};

} // namespace signorini
