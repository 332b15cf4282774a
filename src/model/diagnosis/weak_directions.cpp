#include "model/diagnosis/weak_directions.hpp"

#include "solve/values.hpp"

#include <algorithm>
#include <utility>

namespace signorini::model {

namespace {

double largest_entry(const solve::Pattern& pattern, const std::vector<double>& values) {
  double largest = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(pattern.entries()); ++i)
    largest = std::max(largest, std::abs(values[i]));
  return largest;
}

/// 1 for each displacement. Multipliers have no inertia: where they follow the displacements, inverse iteration
/// converges to the eigenvectors of the constrained displacements.
std::vector<double> unit_mass(const solve::Pattern& pattern, int displacements) {
  std::vector<double> mass(static_cast<std::size_t>(pattern.entries()), 0.0);
  for (int i = 0; i < displacements; ++i) mass[pattern.find(i, i)] = 1;
  return mass;
}

/// The pair with the lowest value in the space of `count` vectors after some rounds. `only_negative`: not computed if
/// the solver finds no negative eigenvalue.
WeakDirection iterate(solve::LinearKind kind, const solve::Pattern& pattern, std::vector<double> matrix, bool symmetric,
                      int displacements, int count, int rounds, bool only_negative) {
  constexpr double relative_shift = 1e-12; // makes a singular matrix regular
  const double shift = relative_shift * largest_entry(pattern, matrix);
  SubspaceIteration iteration(
      kind, {pattern, shifted(pattern, std::move(matrix), shift), unit_mass(pattern, displacements), symmetric},
      std::min(count, displacements));
  WeakDirection weak{VectorX::Zero(pattern.size), 0};
  if (!iteration.shift(0)) return weak;
  if (iteration.negative() >= 0 && displacements == pattern.size) weak.negative = iteration.negative();
  if (only_negative && weak.negative == 0) return weak;
  for (int round = 0; round < rounds; ++round)
    if (!iteration.advance()) return weak;
  constexpr double converged = 0.1; // others may have any value
  const RitzPairs& pairs = iteration.pairs();
  Eigen::Index least = 0;
  if (pairs.values.size() == 0) return weak;
  for (Eigen::Index k = 1; k < pairs.values.size(); ++k)
    if (pairs.errors(k) < converged && pairs.values(k).real() < pairs.values(least).real()) least = k;
  weak.stiffness = pairs.values(least).real() - shift;
  weak.direction.head(displacements) = pairs.vectors.col(least).head(displacements).normalized();
  return weak;
}

} // namespace

std::vector<double> shifted(const solve::Pattern& pattern, std::vector<double> values, double shift) {
  for (int i = 0; i < pattern.size; ++i) values[pattern.find(i, i)] += shift;
  return values;
}

WeakDirection null_direction(const solve::Pattern& pattern, const std::vector<double>& values, int displacements,
                             solve::LinearKind solver) {
  return iterate(solver, pattern, values, false, displacements, 1, 6, false);
}

WeakDirection softest_direction(const solve::Pattern& pattern, const std::vector<double>& values, int displacements,
                                solve::LinearKind solver) {
  return iterate(solver, pattern, solve::symmetrized(pattern, values), true, displacements, 8, 12, true);
}

} // namespace signorini::model
