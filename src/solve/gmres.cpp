#include "solve/gmres.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini::solve {

Gmres::Gmres(int size, int most)
    : basis_(size, most + 1), directions_(size, most), triangle_(most, most), right_(most + 1), cosine_(most),
      sine_(most) {}

KrylovReport Gmres::operator()(const Apply& apply, const Precondition& precondition, const VectorX& b, double tolerance,
                               int most, VectorX& x) {
  constexpr double broken = std::numeric_limits<double>::infinity();
  const double norm = b.norm();
  most = std::min<int>(most, static_cast<int>(directions_.cols()));
  basis_.col(0) = b / norm;
  right_(0) = norm;
  KrylovReport report;
  int& k = report.iterations;
  while (k < most && report.reduction > tolerance) {
    directions_.col(k) = basis_.col(k);
    if (!precondition(directions_.col(k).data())) return {k, broken};
    auto next = basis_.col(k + 1);
    apply(directions_.col(k).data(), next.data());
    // Classical Gram–Schmidt, twice: orthogonal to rounding error
    const auto before = basis_.leftCols(k + 1);
    column_.noalias() = before.transpose() * next;
    next.noalias() -= before * column_;
    correction_.noalias() = before.transpose() * next;
    next.noalias() -= before * correction_;
    column_ += correction_;
    double below = next.norm();
    if (!std::isfinite(below)) return {k, broken};
    if (below > 0) next /= below;

    for (int i = 0; i < k; ++i) {
      const double upper = column_(i);
      column_(i) = cosine_(i) * upper + sine_(i) * column_(i + 1);
      column_(i + 1) = cosine_(i) * column_(i + 1) - sine_(i) * upper;
    }
    const double diagonal = std::hypot(column_(k), below);
    if (diagonal == 0) return {k, broken}; // K M⁻¹ is singular
    cosine_(k) = column_(k) / diagonal;
    sine_(k) = below / diagonal;
    column_(k) = diagonal;
    triangle_.col(k).head(k + 1) = column_;
    right_(k + 1) = -sine_(k) * right_(k);
    right_(k) *= cosine_(k);
    ++k;
    report.reduction = std::abs(right_(k)) / norm;
  }
  right_.head(k) = triangle_.topLeftCorner(k, k).triangularView<Eigen::Upper>().solve(right_.head(k));
  x.noalias() = directions_.leftCols(k) * right_.head(k);
  if (!x.allFinite()) report.reduction = broken;
  return report;
}

} // namespace signorini::solve
