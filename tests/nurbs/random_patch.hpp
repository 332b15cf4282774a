#pragma once
// Random inputs with fixed seeds, and a slow direct evaluation of the basis for comparison.

#include "base/error.hpp"
#include "nurbs/patch.hpp"

#include <algorithm>
#include <random>

namespace signorini::nurbs::test {

using Random = std::mt19937;

inline double uniform(Random& random, double from, double to) {
  return std::uniform_real_distribution<double>(from, to)(random);
}

inline int integer(Random& random, int from, int to) {
  return std::uniform_int_distribution<int>(from, to)(random);
}

/// Open knots from −1 to 3 with up to `breaks` interior knots, each repeated 1 to degree times.
inline KnotVector random_knots(Random& random, int degree, int breaks) {
  const std::size_t ends = static_cast<std::size_t>(degree) + 1;
  std::vector<double> knots(ends, -1.0);
  for (int i = 0; i < breaks; ++i) {
    const double knot = -1 + 4 * (i + uniform(random, 0.2, 0.8)) / breaks;
    knots.insert(knots.end(), static_cast<std::size_t>(integer(random, 1, std::max(degree, 1))), knot);
  }
  knots.insert(knots.end(), ends, 3.0);
  return {degree, knots};
}

/// A patch with random degrees 1 … highest, knots with repetitions, weights in [0.5, 2] and points in [−1, 1].
inline Patch random_patch(Random& random, int parametric_dimension, int dimension, int highest = 4) {
  std::vector<KnotVector> directions;
  int size = 1;
  for (int d = 0; d < parametric_dimension; ++d) {
    directions.push_back(random_knots(random, integer(random, 1, highest), integer(random, 0, 3)));
    size *= directions.back().functions();
  }
  MatrixX points(dimension, size);
  VectorX weights(size);
  for (int a = 0; a < size; ++a) {
    for (int i = 0; i < dimension; ++i) points(i, a) = uniform(random, -1, 1);
    weights(a) = uniform(random, 0.5, 2);
  }
  return make_patch(std::move(directions), points, weights);
}

/// A row of B-splines as a patch.
inline Patch patch_of(const Row& row) {
  std::vector<KnotVector> directions;
  for (const Space1D& direction : row.directions()) directions.push_back(*direction.knots());
  return {std::move(directions), row.homogeneous()};
}

inline VectorX random_parameter(Random& random, const Patch& patch) {
  VectorX xi(patch.parametric_dimension());
  for (int d = 0; d < xi.size(); ++d) xi(d) = uniform(random, patch.direction(d).first(), patch.direction(d).last());
  return xi;
}

/// N_{i,p}(ξ) by the Cox–de Boor recursion (NURBS Book, eq. 2.5), 0/0 = 0, the last span closed on the right.
inline double cox_de_boor(const KnotVector& knots, int i, int p, double xi) {
  const auto u = [&](int k) { return knots.knots()[k]; };
  if (p == 0) return u(i) <= xi && (xi < u(i + 1) || (xi == knots.last() && u(i) < u(i + 1) && xi == u(i + 1)));
  double value = 0;
  if (u(i + p) > u(i)) value += (xi - u(i)) / (u(i + p) - u(i)) * cox_de_boor(knots, i, p - 1, xi);
  if (u(i + p + 1) > u(i + 1))
    value += (u(i + p + 1) - xi) / (u(i + p + 1) - u(i + 1)) * cox_de_boor(knots, i + 1, p - 1, xi);
  return value;
}

/// N^(k)_{i,p}(ξ) by eq. 2.9 of the same book.
inline double cox_de_boor(const KnotVector& knots, int i, int p, double xi, int k) {
  if (k == 0) return cox_de_boor(knots, i, p, xi);
  if (p == 0) return 0;
  const auto u = [&](int n) { return knots.knots()[n]; };
  double value = 0;
  if (u(i + p) > u(i)) value += p / (u(i + p) - u(i)) * cox_de_boor(knots, i, p - 1, xi, k - 1);
  if (u(i + p + 1) > u(i + 1)) value -= p / (u(i + p + 1) - u(i + 1)) * cox_de_boor(knots, i + 1, p - 1, xi, k - 1);
  return value;
}

/// The message of the signorini::Error that `action` throws; empty if it throws none.
template <class Action> std::string error_of(Action action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

} // namespace signorini::nurbs::test

/// Checks that `action` throws a signorini::Error whose message contains `part`.
#define EXPECT_ERROR(action, part)                                                                                     \
  EXPECT_PRED2(                                                                                                        \
      [](const std::string& message, const std::string& text) { return message.find(text) != std::string::npos; },     \
      signorini::nurbs::test::error_of([&] { action; }), std::string(part))
