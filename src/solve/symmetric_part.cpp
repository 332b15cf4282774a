#include "solve/symmetric_part.hpp"

#include <algorithm>
#include <type_traits>

namespace signorini::solve {

void WatchedBlock::locate(const Pattern& pattern, const std::vector<int>& border) {
  std::vector<int> place(pattern.size, -1), unknowns = border;
  std::sort(unknowns.begin(), unknowns.end());
  for (int k = 0; k < std::ssize(unknowns); ++k) place[unknowns[k]] = k;
  places_.clear();
  for (int unknown : border) places_.push_back(place[unknown]);
  runs_.clear();
  for (int column = 0; column < size(); ++column) {
    const int end = pattern.starts[unknowns[column] + 1];
    for (int k = pattern.starts[unknowns[column]], next = -1; k < end; ++k) {
      const int row = place[pattern.rows[k]];
      if (row < 0) {
        next = -1;
        continue;
      }
      if (row == next)
        ++runs_.back().length;
      else
        runs_.push_back({k, row, column, 1});
      next = row + 1;
    }
  }
}

void WatchedBlock::set_constant(const MatrixX& complement, const double* values) {
  constant_.resize(size(), size());
  constant_(places_, places_) = complement;
  for (const auto& [position, row, column, length] : runs_)
    constant_.col(column).segment(row, length) -= Eigen::Map<const VectorX>(values + position, length);
}

template <class Real> void WatchedBlock::set(const double* values, DenseMatrix<Real>& block) const {
  block = constant_.cast<Real>();
  for (const auto& [position, row, column, length] : runs_)
    for (int i = 0; i < length; ++i) block(row + i, column) += static_cast<Real>(values[position + i]);
}

template <class Real> bool WatchedBlock::factor(const double* values) {
  if (!std::holds_alternative<DenseMatrix<Real>>(factors_)) factors_.emplace<DenseMatrix<Real>>();
  auto& block = std::get<DenseMatrix<Real>>(factors_);
  set(values, block);
  const bool factored = factor_dense(block, exchanges_);
  pivots_ = {};
  for (int k = 0; k < size(); ++k) pivots_.add(static_cast<double>(block(k, k)));
  return factored && pivots_.regular(std::is_same_v<Real, float> ? least_single_pivot : least_pivot);
}

bool WatchedBlock::update(const double* values) {
  if (size() == 0) return true;
  return (precision_ == Precision::single && factor<float>(values)) || factor<double>(values);
}

void WatchedBlock::solve(double* b) {
  if (size() == 0) return;
  Eigen::Map<VectorX> given(b, size());
  VectorX right(size());
  right(places_) = given;
  std::visit([&](const auto& factors) { solve_dense(factors, exchanges_, right); }, factors_);
  given = right(places_);
}

bool WatchedBlock::is_positive_definite(const double* values) const {
  DenseMatrix<double> block;
  set(values, block);
  return solve::is_positive_definite(std::move(block));
}

SymmetricPart::SymmetricPart(std::unique_ptr<SchurSolver> solver, Border policy, Precision precision)
    : solver_(std::move(solver)), policy_(policy), block_(precision) {}

void SymmetricPart::watch(const std::vector<int>& unknowns) {
  if (unknowns == watched_) return;
  watched_ = unknowns;
  analyzed_ = false;
}

void SymmetricPart::adopt(const Pattern& pattern) {
  analyzed_ = false;
  block_.locate(pattern, solver_->border());
}

void SymmetricPart::analyze(const Pattern& pattern) {
  solver_->analyze(pattern, watched_);
  const double bordered = solver_->statistics().operations, size = std::ssize(solver_->border());
  const double block = 2.0 / 3.0 * size * size * size;
  if (policy_ == Border::where_cheap && bordered > 0 && block > large_block * bordered) {
    solver_->analyze(pattern, {});
    if (block <= bordered && bordered <= most_bordered * solver_->statistics().operations)
      solver_->analyze(pattern, watched_);
  }
  block_.locate(pattern, solver_->border());
  analyzed_ = true;
}

bool SymmetricPart::factor(const Pattern& pattern, const std::vector<double>& values) {
  return condense(pattern, symmetrized(pattern, values)) && update(values.data());
}

bool SymmetricPart::condense(const Pattern& pattern, const std::vector<double>& values) {
  if (!analyzed_) analyze(pattern);
  if (!solver_->factor(values.data())) return false;
  block_.set_constant(solver_->complement(), values.data());
  return true;
}

bool SymmetricPart::update(const double* values) {
  return block_.update(values);
}

bool SymmetricPart::solve(double* b) {
  return solver_->solve(b, [this](double* border_part) {
    block_.solve(border_part);
    return true;
  });
}

bool SymmetricPart::proves_definite(const double* values) const {
  return block_.is_positive_definite(values);
}

PivotRange SymmetricPart::pivots() const {
  PivotRange all = solver_->pivots();
  all.add(block_.pivots());
  return all;
}

SolverStatistics SymmetricPart::statistics() const {
  SolverStatistics sum = solver_->statistics();
  sum.definite = false; // of the interior
  const double square = static_cast<double>(block_.size()) * block_.size();
  sum.entries += square; // factors of the block
  sum.memory += 3 * sizeof(double) * square;
  return sum;
}

} // namespace signorini::solve
