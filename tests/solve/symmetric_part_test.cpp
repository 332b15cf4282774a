// The symmetric part of a tangent with an up-to-date block of watched unknowns: products with M⁻¹, changes, singular
// blocks.
#include "solve/symmetric_part.hpp"

#include "solve/constants.hpp"
#include "solve/matrices.hpp"
#include "solve/reused.hpp"
#include "solve/values.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace signorini::solve {
namespace symmetric_part_test {

using namespace test;
using Eigen::VectorXd;

TEST(SymmetricPart, IsFactoredOnSeveralPatterns) {
  std::mt19937 random(47);
  SymmetricPart part(make_schur_cholesky(0));
  Pattern pattern = cube(4);
  for (int round = 0; round < 3; ++round) {
    Values values = random_definite(random, pattern);
    const Values noise = random_values(random, pattern);
    for_entries(pattern, [&](int i, int j, int k) { values[k] += 3 * (noise[k] - noise[pattern.find(j, i)]); });
    ASSERT_TRUE(part.factor(pattern, values));
    const Eigen::MatrixXd k = dense(pattern, values);
    const VectorXd b = VectorXd::LinSpaced(pattern.size, -1, 2);
    VectorXd x = b;
    ASSERT_TRUE(part.solve(x.data()));
    EXPECT_LT((0.5 * (k + k.transpose()) * x - b).norm(), 1e-12 * k.norm() * x.norm());

    Values indefinite = values;
    indefinite[pattern.find(7, 7)] *= -1;
    EXPECT_FALSE(part.factor(pattern, indefinite));
    std::vector<int> moved;
    pattern = extend(pattern, {{round, pattern.size - 1 - round}}, moved);
    part.adopt(pattern);
  }
  EXPECT_EQ(part.statistics().factorizations, 6);
}

/// M of symmetric_part.hpp from dense blocks: the symmetric part of `old` with the current block of `watched`.
Eigen::MatrixXd with_block(const Pattern& pattern, const Values& old, const Values& present,
                           const std::vector<int>& watched) {
  const Eigen::MatrixXd k = dense(pattern, old), now = dense(pattern, present);
  Eigen::MatrixXd m = 0.5 * (k + k.transpose());
  m(watched, watched) = now(watched, watched);
  return m;
}

TEST(SymmetricPart, UpdatesTheBlockOfWatchedUnknowns) {
  std::mt19937 random(50);
  for (const auto& [nodes, precision] : {std::pair{3, Precision::full}, {6, Precision::full}, {6, Precision::single}}) {
    const double tolerance = precision == Precision::single ? 1e-6 : 1e-12;
    Pattern pattern = cube(nodes);
    std::vector<int> watched, moved;
    for (int i = 0; i < pattern.size; i += 7) watched.push_back(i);
    SymmetricPart part(make_schur_cholesky(0, precision), SymmetricPart::Border::where_cheap, precision);
    part.watch(watched);
    const Values old = random_definite(random, pattern);
    const auto check = [&](const Values& start, const Values& present) {
      const Eigen::MatrixXd m = with_block(pattern, start, present, watched);
      const VectorXd b = VectorXd::LinSpaced(pattern.size, -1, 2);
      VectorXd x = b;
      ASSERT_TRUE(part.solve(x.data()));
      EXPECT_LT((m * x - b).norm(), tolerance * (m.norm() * x.norm() + b.norm()));
    };
    // Indefinite among the watched unknowns, and unsymmetric
    const auto changed = [&](Values values) {
      const Values noise = random_values(random, pattern);
      for (std::size_t k = 0; k < values.size(); ++k) values[k] += noise[k];
      for (int i : watched) values[pattern.find(i, i)] *= i % 2 ? -3 : 10;
      return values;
    };
    const Values first = changed(old);
    Values start = old;
    for (int i : watched) start[pattern.find(i, i)] = first[pattern.find(i, i)];
    ASSERT_TRUE(part.factor(pattern, start));
    check(start, start);
    for (int round = 0; round < 3; ++round) {
      const Values present = changed(old);
      ASSERT_TRUE(part.update(present.data()));
      check(start, present);
    }
    // Two watched unknowns come into contact.
    const Pattern next = extend(pattern, {{watched.front(), watched.back()}}, moved);
    Values grown(next.entries(), 0.0);
    for (std::size_t k = 0; k < moved.size(); ++k) grown[moved[k]] = start[k];
    start = grown;
    pattern = next;
    part.adopt(pattern);
    const Values present = changed(grown);
    ASSERT_TRUE(part.update(present.data()));
    check(start, present);
    EXPECT_EQ(part.statistics().factorizations, 1);
  }
}

/// A long strip whose contact unknowns are its lower edge: without them no narrow separator is left.
TEST(SymmetricPart, BorderDoesNotMultiplyOperations) {
  constexpr int columns = 300, rows = 6;
  std::vector<std::vector<int>> groups;
  for (int i = 0; i + 1 < columns; ++i)
    for (int j = 0; j + 1 < rows; ++j) {
      const int node = rows * i + j;
      groups.push_back({node, node + 1, node + rows, node + rows + 1});
    }
  const Pattern pattern = couple(columns * rows, groups);
  std::mt19937 random(57);
  const Values values = random_definite(random, pattern);
  SymmetricPart plain(make_schur_cholesky(0));
  ASSERT_TRUE(plain.factor(pattern, values));
  const double least = plain.statistics().operations;
  for (int length : {5, 20, 50, 100, 200, 300}) {
    std::vector<int> edge;
    for (int i = 0; i < length; ++i) edge.push_back(rows * i);
    SymmetricPart part(make_schur_cholesky(0));
    part.watch(edge);
    ASSERT_TRUE(part.factor(pattern, values));
    EXPECT_LE(part.statistics().operations, most_bordered * least) << length;
    if (length == 5) {
      EXPECT_GT(part.statistics().operations, least);
    }
  }
}

/// A free body: K 1 = 0.
TEST(SymmetricPart, RefusesASingularBlockInAnyPrecision) {
  std::mt19937 random(53);
  const Pattern pattern = cube(6);
  Values values(pattern.entries(), 0.0);
  for_entries(pattern, [&](int i, int j, int k) {
    if (i >= j) return;
    const double stiffness = 1 + std::uniform_real_distribution<double>()(random);
    values[k] = values[pattern.find(j, i)] = -stiffness;
    for (int end : {i, j}) values[pattern.find(end, end)] += stiffness;
  });
  std::vector<int> watched;
  for (int i = 0; i < pattern.size; i += 7) watched.push_back(i);
  for (const Precision precision : {Precision::full, Precision::single}) {
    SymmetricPart part(make_schur_cholesky(0, precision), SymmetricPart::Border::always, precision);
    part.watch(watched);
    EXPECT_FALSE(part.factor(pattern, values));
    values[pattern.find(0, 0)] += 1; // now it is held
    EXPECT_TRUE(part.factor(pattern, values));
    values[pattern.find(0, 0)] -= 1;
  }
}

} // namespace symmetric_part_test
} // namespace signorini::solve
