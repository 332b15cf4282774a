#include "solve/changing_block.hpp"

#include "base/index.hpp"
#include "solve/lapack.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

namespace signorini::solve {

ChangingBlock::ChangingBlock(MatrixX constant)
    : constant_(std::move(constant)), order_(at(size())), place_(at(size())), lower_(size(), size()),
      pivots_(at(size())), work_(size()) {}

bool ChangingBlock::covers(const std::vector<char>& touched) const {
  return !allowed_.empty() && std::equal(touched.begin(), touched.end(), allowed_.begin(), std::less_equal<>());
}

void ChangingBlock::condense(const std::vector<char>& touched) {
  allowed_ = touched;
  std::iota(order_.begin(), order_.end(), 0);
  const auto border = std::stable_partition(order_.begin(), order_.end(), [&](int i) { return !touched[at(i)]; });
  untouched_ = static_cast<int>(border - order_.begin());
  if (!eliminate()) {
    untouched_ = 0;
    eliminate();
  }
  for (int k = 0; k < size(); ++k) place_[at(order_[at(k)])] = k;
  const int rest = size() - untouched_;
  reduced_ = lower_.bottomRightCorner(rest, rest).selfadjointView<Eigen::Lower>();
}

/// L, W and the lower triangle of T; false when S_nn is singular.
bool ChangingBlock::eliminate() {
  const int leading = size(), rest = size() - untouched_;
  for (int j = 0; j < size(); ++j)
    for (int i = j; i < size(); ++i) {
      const auto [column, row] = std::minmax(order_[at(i)], order_[at(j)]);
      lower_(i, j) = constant_(row, column);
    }
  untouched_pivots_ = {};
  if (untouched_ == 0) return true;
  int info = 0;
  dpotrf_("L", &untouched_, lower_.data(), &leading, &info);
  if (info != 0) return false;
  for (int k = 0; k < untouched_; ++k) untouched_pivots_.add(lower_(k, k) * lower_(k, k));
  if (!untouched_pivots_.regular()) return false;
  const double one = 1, minus = -1;
  double* coupling = lower_.data() + untouched_;
  double* corner = coupling + at(untouched_) * at(leading);
  dtrsm_("R", "L", "T", "N", &rest, &untouched_, &one, lower_.data(), &leading, coupling, &leading);
  dsyrk_("L", "N", &rest, &untouched_, &minus, coupling, &leading, &one, corner, &leading);
  return true;
}

void ChangingBlock::factor(const std::vector<Change>& changes, PivotRange& pivots) {
  const int rest = size() - untouched_;
  pivots.add(untouched_pivots_);
  if (rest == 0) return;
  factors_ = reduced_;
  for (const Change& change : changes)
    factors_(place_[at(change.row)] - untouched_, place_[at(change.column)] - untouched_) += change.value;
  int info = 0;
  dgetrf_(&rest, &rest, factors_.data(), &rest, pivots_.data(), &info);
  for (int k = 0; k < rest; ++k) pivots.add(factors_(k, k));
}

void ChangingBlock::solve(double* b) {
  const int rest = size() - untouched_, one = 1;
  for (int k = 0; k < size(); ++k) work_(k) = b[order_[at(k)]];
  auto head = work_.head(untouched_);
  auto tail = work_.tail(rest);
  const auto triangle = lower_.topLeftCorner(untouched_, untouched_);
  const auto coupling = lower_.bottomLeftCorner(rest, untouched_);
  // L y = b_n, (T + C) x_a = b_a − W y, Lᵀ x_n = y − Wᵀ x_a
  triangle.triangularView<Eigen::Lower>().solveInPlace(head);
  tail.noalias() -= coupling * head;
  int info = 0;
  if (rest > 0) dgetrs_("N", &rest, &one, factors_.data(), &rest, pivots_.data(), tail.data(), &rest, &info);
  head.noalias() -= coupling.transpose() * tail;
  triangle.transpose().triangularView<Eigen::Upper>().solveInPlace(head);
  for (int k = 0; k < size(); ++k) b[order_[at(k)]] = work_(k);
}

} // namespace signorini::solve
