#include "base/box_least_squares.hpp"

#include "base/dense.hpp"

#include <limits>
#include <vector>

namespace signorini {

namespace {

/// Unknowns by whether they are free, by number.
std::vector<Eigen::Index> numbers_of(const std::vector<bool>& free) {
  std::vector<Eigen::Index> list;
  for (std::size_t i = 0; i < free.size(); ++i)
    if (free[i]) list.push_back(static_cast<Eigen::Index>(i));
  return list;
}

/// Moves the free unknowns to their least squares or, where that leaves the box, to the first border on the way, which
/// the unknown then keeps. True if they are within the box.
bool move_free(const MatrixX& a, const VectorX& b, const VectorX& low, const VectorX& high, std::vector<bool>& free,
               VectorX& d) {
  const std::vector<Eigen::Index> list = numbers_of(free);
  if (list.empty()) return true;
  const VectorX begin = d(list), rest = b - a * d;
  const VectorX move = dense::least_squares(a(Eigen::all, list), rest + a(Eigen::all, list) * begin) - begin;
  double part = 1;
  Eigen::Index first = -1;
  for (std::size_t k = 0; k < list.size(); ++k) {
    const double by = move(static_cast<Eigen::Index>(k)), room = (by < 0 ? low : high)(list[k]) - d(list[k]);
    if (by == 0 || room / by >= part) continue;
    part = room / by;
    first = static_cast<Eigen::Index>(k);
  }
  d(list) = begin + part * move;
  if (first < 0) return true;
  const Eigen::Index i = list[static_cast<std::size_t>(first)];
  d(i) = (move(first) < 0 ? low : high)(i);
  free[static_cast<std::size_t>(i)] = false;
  return false;
}

/// Frees the unknown on a border whose way into the box reduces the residual most; false if there is none.
bool release(const MatrixX& a, const VectorX& b, const VectorX& low, const VectorX& high, std::vector<bool>& free,
             const VectorX& d) {
  const VectorX descent = a.transpose() * (b - a * d);
  double most = std::numeric_limits<double>::epsilon() * a.norm() * b.norm();
  std::size_t found = free.size();
  for (std::size_t i = 0; i < free.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    const bool inward = (descent(k) > 0 && d(k) < high(k)) || (descent(k) < 0 && d(k) > low(k));
    if (free[i] || !inward || std::abs(descent(k)) <= most) continue;
    most = std::abs(descent(k));
    found = i;
  }
  if (found == free.size()) return false;
  free[found] = true;
  return true;
}

} // namespace

VectorX box_least_squares(const MatrixX& a, const VectorX& b, const VectorX& low, const VectorX& high) {
  VectorX d = VectorX::Zero(a.cols());
  std::vector<bool> free(static_cast<std::size_t>(a.cols()), true);
  // Each set of free unknowns comes once, since the residual falls; rounding errors may let some come again.
  for (Eigen::Index left = 10 * (a.cols() + 1); left > 0; --left)
    if (move_free(a, b, low, high, free, d) && !release(a, b, low, high, free, d)) break;
  return d;
}

} // namespace signorini
