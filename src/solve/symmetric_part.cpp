#include "solve/symmetric_part.hpp"

#include "base/error.hpp"
#include "base/index.hpp"
#include "solve/cholmod.hpp"
#include "solve/lapack.hpp"
#include "solve/values.hpp"

#include <algorithm>

namespace signorini::solve {

struct SymmetricPart::Factors {
  CholmodCommon common;
  CholmodFactor lower{common};
  CholmodSolve triangular{common};
};

SymmetricPart::SymmetricPart() : factors_(std::make_unique<Factors>()) {}
SymmetricPart::~SymmetricPart() = default;

void SymmetricPart::watch(const std::vector<int>& unknowns) {
  if (unknowns == wanted_) return;
  wanted_ = unknowns;
  analysed_ = false;
}

void SymmetricPart::adopt(const Pattern& pattern) {
  analysed_ = false;
  locate(pattern);
}

double SymmetricPart::update_operations() const {
  return 2.0 / 3.0 * border() * border() * border();
}

/// An ordering with `watched` last. Returns false when S would cost more than it saves.
bool SymmetricPart::analyse(const Pattern& pattern, const std::vector<int>& watched) {
  CholmodCommon& common = factors_->common;
  cholmod_factor*& lower = factors_->lower.factor;
  cholmod_sparse matrix = lower_triangle(pattern, nullptr);
  matrix.xtype = CHOLMOD_PATTERN;
  common.supernodal = CHOLMOD_SUPERNODAL;
  common.nmethods = 1;
  common.method[0].ordering = CHOLMOD_GIVEN;
  std::vector<char> last(at(pattern.size), 0);
  for (int unknown : watched) last[at(unknown)] = 1;
  const auto analyse_in_order = [&] {
    order_ = dissection_;
    // Postordering gathers supernodes but moves watched unknowns forward: it has to be undone for these.
    for (bool postorder : {true, false}) {
      std::stable_partition(order_.begin(), order_.end(), [&](int unknown) { return !last[at(unknown)]; });
      common.postorder = postorder;
      cholmod_free_factor(&lower, &common);
      lower = cholmod_analyze_p(&matrix, order_.data(), nullptr, 0, &common);
      require(lower != nullptr, "the sparse solver could not analyse the tangent (CHOLMOD status ", common.status, ")");
      const int* order = static_cast<int*>(lower->Perm);
      order_.assign(order, order + lower->n);
    }
  };
  // Contacts that slide on change few entries; a new dissection takes as long as a few factorisations.
  constexpr double worse = 1.2;
  if (!dissection_.empty()) analyse_in_order();
  if (dissection_.empty() || common.fl > worse * best_) {
    dissection_.resize(at(pattern.size));
    const bool dissected = cholmod_metis(&matrix, nullptr, 0, true, dissection_.data(), &common);
    require(dissected, "the sparse solver could not order the tangent (CHOLMOD status ", common.status, ")");
    analyse_in_order();
    best_ = common.fl;
  }
  border_ = watched;
  right_.resize(pattern.size);
  part_.resize(border());
  pivots_.resize(at(border()));
  return update_operations() <= common.fl;
}

/// The entries between the watched unknowns.
void SymmetricPart::locate(const Pattern& pattern) {
  entries_.clear();
  std::vector<int> place(at(pattern.size), -1);
  for (int k = pattern.size - border(); k < pattern.size; ++k) place[at(order_[at(k)])] = k - (pattern.size - border());
  for (int column : border_)
    for (int k = pattern.starts[at(column)]; k < pattern.starts[at(column) + 1]; ++k)
      if (const int row = place[at(pattern.rows[at(k)])]; row >= 0) entries_.push_back({k, row, place[at(column)]});
}

bool SymmetricPart::factor(const Pattern& pattern, const double* values, const std::vector<double>& transposed) {
  values_.resize(transposed.size());
  for (std::size_t k = 0; k < values_.size(); ++k) values_[k] = 0.5 * (values[k] + transposed[k]);
  if (!analysed_) {
    if (!analyse(pattern, wanted_)) analyse(pattern, {});
    locate(pattern);
    analysed_ = true;
  }
  double largest = 0;
  for (double value : values_) largest = std::max(largest, std::abs(value));
  for (const Entry& entry : entries_)
    if (double& value = values_[at(entry.position)]; entry.row == entry.column) value = value > 0 ? 2 * value : largest;
  auto& [common, lower, triangular] = *factors_;
  cholmod_sparse matrix = lower_triangle(pattern, values_.data());
  factorize(matrix, lower.factor, common);
  count(*lower.factor, common, statistics_);
  statistics_.entries += 3.0 * border() * border(); // S, and L_cc twice
  statistics_.memory += 3.0 * sizeof(double) * border() * border();
  if (common.status != CHOLMOD_OK || !(cholmod_rcond(lower.factor, &common) > least_pivot)) return false;
  form_corner();
  return update(values);
}

void SymmetricPart::form_corner() {
  const cholmod_factor& lower = *factors_->lower.factor;
  const int *first = static_cast<int*>(lower.super), *rows_from = static_cast<int*>(lower.pi),
            *values_from = static_cast<int*>(lower.px), *rows = static_cast<int*>(lower.s);
  const double* values = static_cast<double*>(lower.x);
  const int interior = static_cast<int>(lower.n) - border();
  corner_.setZero(border(), border());
  for (int s = static_cast<int>(lower.nsuper) - 1; s >= 0 && first[s + 1] > interior; --s) {
    const int height = rows_from[s + 1] - rows_from[s];
    for (int j = std::max(first[s], interior); j < first[s + 1]; ++j)
      for (int i = j - first[s]; i < height; ++i)
        corner_(rows[rows_from[s] + i] - interior, j - interior) =
            values[values_from[s] + i + static_cast<std::ptrdiff_t>(j - first[s]) * height];
  }
  constant_.setZero(border(), border());
  const int size = border();
  const double one = 1, zero = 0;
  if (size > 0) dsyrk_("L", "N", &size, &size, &one, corner_.data(), &size, &zero, constant_.data(), &size);
  constant_.triangularView<Eigen::StrictlyUpper>() = constant_.transpose();
  for (const Entry& entry : entries_) constant_(entry.row, entry.column) -= values_[at(entry.position)];
}

bool SymmetricPart::update(const double* values) {
  const int size = border();
  if (size == 0) return true;
  block_ = constant_;
  for (const Entry& entry : entries_) block_(entry.row, entry.column) += values[entry.position];
  int info = 0;
  dgetrf_(&size, &size, block_.data(), &size, pivots_.data(), &info);
  PivotRange pivots;
  for (int k = 0; k < size; ++k) pivots.add(block_(k, k));
  return info == 0 && pivots.regular();
}

bool SymmetricPart::solve(double* b) {
  ++statistics_.solutions;
  auto& [common, lower, triangular] = *factors_;
  const int n = static_cast<int>(lower.factor->n), size = border(), interior = n - size, one = 1;
  for (int k = 0; k < n; ++k) right_(k) = b[order_[at(k)]];
  double* z = triangular(CHOLMOD_L, lower.factor, right_.data());
  if (!z) return false;
  if (size > 0) {
    Eigen::Map<VectorX> tail(z + interior, size);
    part_.noalias() = corner_.triangularView<Eigen::Lower>() * tail;
    int info = 0;
    dgetrs_("N", &size, &one, block_.data(), &size, pivots_.data(), part_.data(), &size, &info);
    tail.noalias() = corner_.transpose().triangularView<Eigen::Upper>() * part_;
  }
  std::copy_n(z, n, right_.data());
  const double* x = triangular(CHOLMOD_Lt, lower.factor, right_.data());
  if (!x) return false;
  for (int k = 0; k < n; ++k) b[order_[at(k)]] = x[k];
  return true;
}

} // namespace signorini::solve
