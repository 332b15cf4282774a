#include "solve/symmetric_part.hpp"

#include "base/index.hpp"
#include "solve/lapack.hpp"

namespace signorini::solve {

void SymmetricPart::watch(const std::vector<int>& unknowns) {
  if (unknowns == watched_) return;
  watched_ = unknowns;
  analyzed_ = false;
}

void SymmetricPart::adopt(const Pattern& pattern) {
  analyzed_ = false;
  locate(pattern);
}

void SymmetricPart::analyze(const Pattern& pattern) {
  solver_->analyze(pattern, watched_);
  const double saves = solver_->statistics().operations, size = border();
  const double costs = 2.0 / 3.0 * size * size * size;
  if (policy_ == Border::where_cheap && saves > 0 && costs > saves) solver_->analyze(pattern, {});
  exchanges_.resize(at(border()));
  analyzed_ = true;
}

/// Finds the entries between the watched unknowns.
void SymmetricPart::locate(const Pattern& pattern) {
  entries_.clear();
  const std::vector<int>& watched = solver_->border();
  std::vector<int> place(at(pattern.size), -1);
  for (int k = 0; k < border(); ++k) place[at(watched[at(k)])] = k;
  for (int column : watched)
    for (int k = pattern.starts[at(column)]; k < pattern.starts[at(column) + 1]; ++k)
      if (const int row = place[at(pattern.rows[at(k)])]; row >= 0) entries_.push_back({k, row, place[at(column)]});
}

bool SymmetricPart::factor(const Pattern& pattern, const std::vector<double>& values) {
  std::vector<double> mean;
  Symmetry(pattern).transpose(values.data(), mean);
  for (std::size_t k = 0; k < mean.size(); ++k) mean[k] = 0.5 * (values[k] + mean[k]);
  return condense(pattern, mean) && update(values.data());
}

bool SymmetricPart::condense(const Pattern& pattern, const std::vector<double>& values) {
  if (!analyzed_) {
    analyze(pattern);
    locate(pattern);
  }
  if (!solver_->factor(values.data())) return false;
  constant_ = solver_->complement();
  for (const Entry& entry : entries_) constant_(entry.row, entry.column) -= values[at(entry.position)];
  return true;
}

bool SymmetricPart::update(const double* values) {
  const int size = border();
  if (size == 0) return true;
  block_ = constant_;
  for (const Entry& entry : entries_) block_(entry.row, entry.column) += values[entry.position];
  int info = 0;
  dgetrf_(&size, &size, block_.data(), &size, exchanges_.data(), &info);
  block_pivots_ = {};
  for (int k = 0; k < size; ++k) block_pivots_.add(block_(k, k));
  return info == 0 && block_pivots_.regular();
}

bool SymmetricPart::solve(double* b) {
  return solver_->solve(b, [this](double* border_part) {
    const int size = border(), one = 1;
    int info = 0;
    if (size > 0) dgetrs_("N", &size, &one, block_.data(), &size, exchanges_.data(), border_part, &size, &info);
    return info == 0;
  });
}

PivotRange SymmetricPart::pivots() const {
  PivotRange all = solver_->pivots();
  all.add(block_pivots_);
  return all;
}

SolverStatistics SymmetricPart::statistics() const {
  SolverStatistics sum = solver_->statistics();
  const double square = static_cast<double>(border()) * border();
  sum.entries += square; // factors of the block
  sum.memory += 3 * sizeof(double) * square;
  return sum;
}

} // namespace signorini::solve
