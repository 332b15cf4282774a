#include "solve/band_order.hpp"

#include "base/index.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace signorini::solve {

namespace {

/// Walks through the connected part of a pattern level by level.
class Walk {
public:
  explicit Walk(const Pattern& pattern) : pattern_(pattern), level_(at(pattern.size), unseen) {}

  bool seen(int unknown) const { return level_[at(unknown)] != unseen; }
  int degree(int unknown) const { return pattern_.starts[at(unknown) + 1] - pattern_.starts[at(unknown)]; }
  int level(int unknown) const { return level_[at(unknown)]; }

  /// The part of `root` in the order of Cuthill and McKee: the neighbours of each in turn, those with few neighbours
  /// first.
  void from(int root, std::vector<int>& order) {
    const auto earlier = [this](int a, int b) { return std::pair(degree(a), a) < std::pair(degree(b), b); };
    order.assign(1, root);
    level_[at(root)] = 0;
    for (std::size_t head = 0; head < order.size(); ++head) {
      const int unknown = order[head];
      const auto known = static_cast<std::ptrdiff_t>(order.size());
      for (int k = pattern_.starts[at(unknown)]; k < pattern_.starts[at(unknown) + 1]; ++k)
        if (const int neighbour = pattern_.rows[at(k)]; !seen(neighbour)) {
          level_[at(neighbour)] = level(unknown) + 1;
          order.push_back(neighbour);
        }
      std::sort(order.begin() + known, order.end(), earlier);
    }
  }
  void forget(const std::vector<int>& order) {
    for (int unknown : order) level_[at(unknown)] = unseen;
  }

private:
  static constexpr int unseen = -1;
  const Pattern& pattern_;
  std::vector<int> level_;
};

} // namespace

std::vector<int> band_order(const Pattern& pattern) {
  Walk walk(pattern);
  std::vector<int> order, part;
  order.reserve(at(pattern.size));
  for (int first = 0; first < pattern.size; ++first) {
    if (walk.seen(first)) continue;
    // An end of the part: walk to the far side as long as that is farther away.
    int root = first, distance = -1;
    for (walk.from(root, part); walk.level(part.back()) > distance; walk.from(root, part)) {
      distance = walk.level(part.back());
      root = *std::min_element(part.rbegin(), part.rend(), [&](int a, int b) {
        return std::pair(-walk.level(a), walk.degree(a)) < std::pair(-walk.level(b), walk.degree(b));
      });
      walk.forget(part);
    }
    order.insert(order.end(), part.begin(), part.end());
  }
  std::reverse(order.begin(), order.end());
  return order;
}

int band_width(const Pattern& pattern, const std::vector<int>& order) {
  std::vector<int> place(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) place[at(order[k])] = static_cast<int>(k);
  int width = 0;
  for (int j = 0; j < pattern.size; ++j)
    for (int k = pattern.starts[at(j)]; k < pattern.starts[at(j) + 1]; ++k)
      width = std::max(width, std::abs(place[at(j)] - place[at(pattern.rows[at(k)])]));
  return width;
}

} // namespace signorini::solve
