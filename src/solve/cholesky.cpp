#include "solve/cholesky.hpp"

#include "base/error.hpp"
#include "solve/cholmod.hpp"
#include "solve/values.hpp"

#include <algorithm>

namespace signorini::solve {

namespace {

class Cholesky final : public LinearSolver {
public:
  explicit Cholesky(const Pattern& pattern);

  bool factor(const double* values) override;
  bool solve(double* b) override;
  LinearKind kind() const override { return LinearKind::cholmod; }
  int negative_pivots() const override { return negative_; }
  SolverStatistics statistics() const override { return statistics_; }

private:
  bool factor_definite(cholmod_sparse& matrix);
  bool factor_symmetric(cholmod_sparse& matrix);
  bool factor_with_pivots();

  Pattern pattern_;
  Symmetry symmetry_;
  const double* values_ = nullptr;
  CholmodCommon common_;
  CholmodFactor dense_blocks_{common_}, by_columns_{common_}; ///< L Lᵀ of supernodes, where it pays; L D Lᵀ
  CholmodFactor* used_ = nullptr;                             ///< nullptr: UMFPACK
  std::unique_ptr<LinearSolver> pivoting_;
  CholmodSolve triangular_{common_};
  int negative_ = -1;
  std::vector<double> right_, difference_;
  SolverStatistics statistics_;
};

Cholesky::Cholesky(const Pattern& pattern)
    : pattern_(pattern), symmetry_(pattern), right_(static_cast<std::size_t>(pattern.size)) {
  cholmod_sparse matrix = lower_triangle(pattern_, nullptr);
  matrix.xtype = CHOLMOD_PATTERN;
  cholmod_factor* analysed = cholmod_analyze(&matrix, &common_);
  require(analysed != nullptr, "the sparse solver could not analyse the tangent (CHOLMOD status ", common_.status, ")");
  if (!analysed->is_super) {
    by_columns_.factor = analysed;
    return;
  }
  dense_blocks_.factor = analysed;
  common_.nmethods = 1;
  common_.method[0].ordering = CHOLMOD_GIVEN;
  common_.supernodal = CHOLMOD_SIMPLICIAL;
  by_columns_.factor = cholmod_analyze_p(&matrix, static_cast<int*>(analysed->Perm), nullptr, 0, &common_);
  require(by_columns_.factor != nullptr, "the sparse solver could not analyse the tangent (CHOLMOD status ",
          common_.status, ")");
}

bool Cholesky::factor(const double* values) {
  require(symmetry_.holds(values),
          "linear: the solver 'cholmod' needs a symmetric tangent, and this one is not, as with "
          "friction; take 'umfpack' or 'auto'");
  values_ = values;
  cholmod_sparse matrix = lower_triangle(pattern_, values);
  // What was indefinite the last time is likely to be so again.
  if (dense_blocks_.factor && negative_ <= 0 && factor_definite(matrix)) return true;
  return factor_symmetric(matrix) || factor_with_pivots();
}

bool Cholesky::factor_definite(cholmod_sparse& matrix) {
  common_.supernodal = CHOLMOD_SUPERNODAL;
  factorize(matrix, dense_blocks_.factor, common_);
  count(*dense_blocks_.factor, common_, statistics_);
  if (common_.status != CHOLMOD_OK || !(cholmod_rcond(dense_blocks_.factor, &common_) > least_pivot)) return false;
  used_ = &dense_blocks_;
  negative_ = 0;
  return true;
}

bool Cholesky::factor_symmetric(cholmod_sparse& matrix) {
  negative_ = -1;
  common_.supernodal = CHOLMOD_SIMPLICIAL;
  cholmod_factor* factor = by_columns_.factor;
  factorize(matrix, factor, common_);
  count(*factor, common_, statistics_);
  if (common_.status != CHOLMOD_OK || !(cholmod_rcond(factor, &common_) > least_pivot)) return false;
  used_ = &by_columns_;
  const int* starts = static_cast<int*>(factor->p);
  const double* entries = static_cast<double*>(factor->x);
  negative_ = static_cast<int>(
      std::count_if(starts, starts + factor->n, [&](int diagonal) { return entries[diagonal] < 0; })); // D is on top
  return true;
}

bool Cholesky::factor_with_pivots() {
  ++statistics_.factorisations;
  used_ = nullptr;
  negative_ = -1;
  if (!pivoting_) pivoting_ = make_solver(LinearKind::umfpack, pattern_);
  const bool regular = pivoting_->factor(values_);
  const SolverStatistics pivoting = pivoting_->statistics();
  statistics_.operations = pivoting.operations;
  statistics_.entries = pivoting.entries;
  statistics_.memory = pivoting.memory;
  return regular;
}

bool Cholesky::solve(double* b) {
  ++statistics_.solutions;
  if (!used_) return pivoting_->solve(b);
  std::copy_n(b, pattern_.size, right_.data());
  const double* x = triangular_(CHOLMOD_A, used_->factor, b);
  if (!x) return false;
  std::copy_n(x, pattern_.size, b);
  // Without row exchanges, pivots of both signs can be bad ones.
  if (negative_ == 0 || relative_residual(pattern_, values_, b, right_.data(), difference_) <= 1e-10) return true;
  std::copy(right_.begin(), right_.end(), b);
  return factor_with_pivots() && pivoting_->solve(b);
}

} // namespace

std::unique_ptr<LinearSolver> make_cholesky(const Pattern& pattern) {
  return std::make_unique<Cholesky>(pattern);
}

} // namespace signorini::solve
