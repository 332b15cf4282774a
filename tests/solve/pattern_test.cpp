// Patterns compared with dense matrices.
#include "solve/pattern.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <random>

namespace signorini::solve {
namespace pattern_test {

using Groups = std::vector<std::vector<int>>;
using Flags = Eigen::Matrix<bool, Eigen::Dynamic, Eigen::Dynamic>;

Groups random_groups(std::mt19937& random, int size, int count) {
  Groups groups;
  for (int g = 0; g < count; ++g) {
    groups.emplace_back();
    const int members = std::uniform_int_distribution<int>(0, 6)(random);
    // −1: prescribed unknowns; repetitions are allowed.
    for (int k = 0; k < members; ++k) groups.back().push_back(std::uniform_int_distribution<int>(-1, size - 1)(random));
  }
  return groups;
}

Flags oracle(int size, const Groups& groups) {
  Flags full = Flags::Identity(size, size);
  for (const auto& group : groups)
    for (int i : group)
      for (int j : group)
        if (i >= 0 && j >= 0) full(i, j) = true;
  return full;
}

void expect_same(const Pattern& pattern, const Flags& full) {
  ASSERT_EQ(pattern.size, full.rows());
  ASSERT_EQ(pattern.starts.size(), static_cast<std::size_t>(pattern.size) + 1);
  EXPECT_EQ(pattern.starts.back(), pattern.entries());
  EXPECT_EQ(pattern.entries(), full.count());
  for (int j = 0; j < pattern.size; ++j)
    for (int i = 0; i < pattern.size; ++i) {
      const int position = pattern.find(i, j);
      EXPECT_EQ(position >= 0, full(i, j)) << i << " " << j;
      if (position < 0) continue;
      EXPECT_EQ(pattern.rows[position], i);
      EXPECT_GE(position, pattern.starts[j]);
      EXPECT_LT(position, pattern.starts[static_cast<std::size_t>(j) + 1]);
      if (position > pattern.starts[j]) {
        EXPECT_LT(pattern.rows[static_cast<std::size_t>(position) - 1], i);
      }
    }
}

TEST(Pattern, CouplesAllMembersOfAGroup) {
  std::mt19937 random(1);
  for (int size : {1, 2, 5, 30}) {
    const Groups groups = random_groups(random, size, 12);
    expect_same(couple(size, groups), oracle(size, groups));
  }
  expect_same(couple(4, {}), oracle(4, {}));
  EXPECT_EQ(couple(0, {}).entries(), 0);
}

TEST(Pattern, ExtensionReportsNewPositionsOfEntries) {
  std::mt19937 random(2);
  for (int trial = 0; trial < 20; ++trial) {
    const int size = 25;
    Groups groups = random_groups(random, size, 8);
    const Groups more = random_groups(random, size, 5);
    const Pattern base = couple(size, groups);
    std::vector<int> moved{7, 7, 7}; // earlier contents must not matter
    const Pattern wider = extend(base, more, moved);
    groups.insert(groups.end(), more.begin(), more.end());
    expect_same(wider, oracle(size, groups));
    ASSERT_EQ(moved.size(), base.rows.size());
    for (int j = 0; j < size; ++j)
      for (int k = base.starts[j]; k < base.starts[static_cast<std::size_t>(j) + 1]; ++k)
        EXPECT_EQ(moved[k], wider.find(base.rows[k], j));
  }
}

} // namespace pattern_test
} // namespace signorini::solve
