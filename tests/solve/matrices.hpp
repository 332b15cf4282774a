#pragma once
// Patterns and values for the solvers' tests, with dense reference solutions.

#include "solve/linear.hpp"
#include "solve/mumps.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace signorini::solve::test {

using Values = std::vector<double>;

/// The kinds that factor every matrix by a direct solver of general matrices.
inline std::vector<LinearKind> direct_kinds() {
  std::vector<LinearKind> kinds = {LinearKind::klu, LinearKind::umfpack};
  if (has_mumps()) kinds.push_back(LinearKind::mumps);
  return kinds;
}

/// The pattern of a chain of overlapping groups with some distant couplings.
inline Pattern chain(int size) {
  std::vector<std::vector<int>> groups;
  for (int i = 0; i + 2 < size; i += 2) groups.push_back({i, i + 1, i + 2, (7 * i + 3) % size});
  return couple(size, groups);
}

/// A cube of nodes with three unknowns each, coupled over one element: the fill of a solid.
inline Pattern cube(int nodes) {
  std::vector<std::vector<int>> groups;
  for (int k = 0; k + 1 < nodes; ++k)
    for (int j = 0; j + 1 < nodes; ++j)
      for (int i = 0; i + 1 < nodes; ++i) {
        std::vector<int> group;
        for (int corner = 0; corner < 8; ++corner) {
          const int node = i + corner % 2 + nodes * (j + corner / 2 % 2 + nodes * (k + corner / 4));
          for (int c = 0; c < 3; ++c) group.push_back(3 * node + c);
        }
        groups.push_back(group);
      }
  return couple(3 * nodes * nodes * nodes, groups);
}

/// Calls visit(row, column, position) for every entry.
template <class Visit> void for_entries(const Pattern& pattern, Visit visit) {
  for (int j = 0; j < pattern.size; ++j)
    for (int k = pattern.starts[j]; k < pattern.starts[j + 1]; ++k) visit(pattern.rows[k], j, k);
}

inline Values random_values(std::mt19937& random, const Pattern& pattern) {
  Values values(pattern.entries());
  for (double& value : values) value = std::uniform_real_distribution<double>(-1, 1)(random);
  return values;
}

/// Positive definite symmetric values that are not diagonally dominant; with `diagonal` −1 they are negative definite.
inline Values random_definite(std::mt19937& random, const Pattern& pattern, double diagonal = 1) {
  Values values = random_values(random, pattern), sums(pattern.size, 0.1);
  for_entries(pattern, [&](int i, int j, int k) {
    if (i < j) values[k] = values[pattern.find(j, i)];
    if (i != j) sums[i] += std::abs(values[std::min(k, pattern.find(j, i))]);
  });
  for_entries(pattern, [&](int i, int j, int k) {
    if (i == j) values[k] = diagonal * sums[i];
  });
  return values;
}

inline Eigen::MatrixXd dense(const Pattern& pattern, const Values& values) {
  Eigen::MatrixXd full = Eigen::MatrixXd::Zero(pattern.size, pattern.size);
  for_entries(pattern, [&](int i, int j, int k) { full(i, j) = values[k]; });
  return full;
}

/// K x from the sparse K.
inline Eigen::VectorXd product(const Pattern& pattern, const Values& values, const Eigen::VectorXd& x) {
  Eigen::VectorXd y = Eigen::VectorXd::Zero(pattern.size);
  for_entries(pattern, [&](int i, int j, int k) { y(i) += values[k] * x(j); });
  return y;
}

/// Largest backward error |K x − b| / (|K||x| + |b|) of two right-hand sides after one factorization; 1 if it failed.
template <class Solver> double backward_error(Solver& solver, const Pattern& pattern, const Values& values) {
  if (!solver.factor(values.data())) return 1;
  const double norm = Eigen::Map<const Eigen::VectorXd>(values.data(), pattern.entries()).norm();
  double worst = 0;
  for (double from : {-1.0, 0.5}) {
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(pattern.size, from, 2);
    Eigen::VectorXd x = b;
    if (!solver.solve(x.data())) return 1;
    worst = std::max(worst, (product(pattern, values, x) - b).norm() / (norm * x.norm() + b.norm()));
  }
  return worst;
}

/// Springs of random stiffness that connect each of `size` unknowns to the next, without supports.
inline std::pair<Pattern, Values> free_springs(std::mt19937& random, int size) {
  std::vector<std::vector<int>> pairs;
  for (int i = 0; i + 1 < size; ++i) pairs.push_back({i, i + 1});
  Pattern pattern = couple(size, pairs);
  Values values(pattern.entries(), 0.0);
  for (int i = 0; i + 1 < size; ++i) {
    const double stiffness = std::uniform_real_distribution<double>(0.1, 1)(random);
    for (int a : {i, i + 1})
      for (int b : {i, i + 1}) values[pattern.find(a, b)] += a == b ? stiffness : -stiffness;
  }
  return {std::move(pattern), std::move(values)};
}

/// Slowly changing tangents: definite, two springs that appear and disappear, and an unsymmetric part of size `skew`.
struct Drift {
  Pattern pattern;
  Values base, change;
  double skew;

  Drift(std::mt19937& random, Pattern wanted, double skew)
      : pattern(std::move(wanted)), base(random_definite(random, pattern)), change(random_values(random, pattern)),
        skew(skew) {}
  Values at_time(int time) const {
    Values values = base;
    for (std::size_t k = 0; k < values.size(); ++k) values[k] += 0.02 * skew * std::sin(0.1 * time) * change[k];
    for (int i = time % 5; i < pattern.size; i += 1100) values[pattern.find(i, i)] += 20;
    return values;
  }
};

inline double residual(const Pattern& pattern, const Values& values, const Eigen::VectorXd& x,
                       const Eigen::VectorXd& b) {
  return (b - product(pattern, values, x)).norm() / b.norm();
}

} // namespace signorini::solve::test
