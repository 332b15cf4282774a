#include "solve/symmetric_part.hpp"

#include "solve/dense_factors.hpp"

#include <algorithm>
#include <type_traits>

namespace signorini::solve {

SymmetricPart::SymmetricPart(std::unique_ptr<SchurSolver> solver, Border policy, Precision precision)
    : solver_(std::move(solver)), policy_(policy), precision_(precision) {}

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
  const double bordered = solver_->statistics().operations, size = border();
  const double block = 2.0 / 3.0 * size * size * size;
  if (policy_ == Border::where_cheap && bordered > 0 && block > large_block * bordered) {
    solver_->analyze(pattern, {});
    if (block <= bordered && bordered <= most_bordered * solver_->statistics().operations)
      solver_->analyze(pattern, watched_);
  }
  right_.resize(border());
  analyzed_ = true;
}

/// Finds the entries between the watched unknowns.
void SymmetricPart::locate(const Pattern& pattern) {
  std::vector<int> place(pattern.size, -1), unknowns = solver_->border();
  std::sort(unknowns.begin(), unknowns.end());
  for (int k = 0; k < border(); ++k) place[unknowns[k]] = k;
  places_.clear();
  for (int unknown : solver_->border()) places_.push_back(place[unknown]);
  runs_.clear();
  for (int column = 0; column < border(); ++column) {
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
  constant_.resize(border(), border());
  constant_(places_, places_) = solver_->complement();
  for (const auto& [position, row, column, length] : runs_)
    constant_.col(column).segment(row, length) -= Eigen::Map<const VectorX>(values.data() + position, length);
  return true;
}

/// S − K⁰_cc + K_cc
template <class Real> void SymmetricPart::set_block(const double* values, DenseMatrix<Real>& block) const {
  block = constant_.cast<Real>();
  for (const auto& [position, row, column, length] : runs_)
    for (int i = 0; i < length; ++i) block(row + i, column) += static_cast<Real>(values[position + i]);
}

template <class Real> bool SymmetricPart::factor_block(const double* values) {
  if (!std::holds_alternative<DenseMatrix<Real>>(block_)) block_.emplace<DenseMatrix<Real>>();
  auto& block = std::get<DenseMatrix<Real>>(block_);
  set_block(values, block);
  const bool factored = factor_dense(block, exchanges_);
  block_pivots_ = {};
  for (int k = 0; k < border(); ++k) block_pivots_.add(static_cast<double>(block(k, k)));
  return factored && block_pivots_.regular(std::is_same_v<Real, float> ? least_single_pivot : least_pivot);
}

bool SymmetricPart::update(const double* values) {
  if (border() == 0) return true;
  return (precision_ == Precision::single && factor_block<float>(values)) || factor_block<double>(values);
}

bool SymmetricPart::solve(double* b) {
  return solver_->solve(b, [this](double* border_part) {
    if (border() == 0) return true;
    Eigen::Map<VectorX> given(border_part, border());
    right_(places_) = given;
    std::visit([&](const auto& block) { solve_dense(block, exchanges_, right_); }, block_);
    given = right_(places_);
    return true;
  });
}

bool SymmetricPart::proves_definite(const double* values) const {
  DenseMatrix<double> block;
  set_block(values, block);
  return solver_->proves_definite() && is_positive_definite(std::move(block));
}

PivotRange SymmetricPart::pivots() const {
  PivotRange all = solver_->pivots();
  all.add(block_pivots_);
  return all;
}

SolverStatistics SymmetricPart::statistics() const {
  SolverStatistics sum = solver_->statistics();
  sum.definite = false; // of the interior
  const double square = static_cast<double>(border()) * border();
  sum.entries += square; // factors of the block
  sum.memory += 3 * sizeof(double) * square;
  return sum;
}

} // namespace signorini::solve
