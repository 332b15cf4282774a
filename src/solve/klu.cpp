#include "solve/direct.hpp"

#include "base/error.hpp"

#include <klu.h>

#include <algorithm>

namespace signorini::solve {

namespace {

/// KLU (Davis & Palamadai Natarajan, ACM TOMS 37, 2010): a refactorization reuses the pivots of the last full one at a
/// fraction of its cost; growth of the factors shows when the pivots are no longer suitable.
class Klu final : public DirectSolver {
public:
  Klu() {
    klu_defaults(&common_);
    common_.btf = 0;      // the tangent is structurally symmetric and irreducible
    common_.ordering = 0; // approximate minimum degree
    common_.scale = -1;   // none: pivots are compared within a column, whose entries have the same units
  }
  ~Klu() override { clear(); }

  void analyze(const Pattern& pattern) override {
    clear();
    pattern_ = pattern;
    symbolic_ = klu_analyze(pattern_.size, pattern_.starts.data(), pattern_.rows.data(), &common_);
    require(symbolic_ != nullptr || pattern_.size == 0, "solve.klu.analyze", {{"status", common_.status}});
    if (!symbolic_) return;
    statistics_.operations = symbolic_->est_flops;
    statistics_.entries = symbolic_->lnz + symbolic_->unz;
  }

  bool factor(const double* values) override {
    ++statistics_.factorizations;
    double* const read = const_cast<double*>(values); // KLU only reads the values
    refactored_ = numeric_ &&
                  klu_refactor(pattern_.starts.data(), pattern_.rows.data(), read, symbolic_, numeric_, &common_) &&
                  common_.status == KLU_OK && pivots().regular();
    if (!refactored_) return factor_with_pivots(read);
    judge_pivots();
    values_.assign(values, values + pattern_.entries());
    return true;
  }

  bool solve(double* b) override {
    ++statistics_.solutions;
    if (refactored_) {
      // Reused pivots can be unsuitable for the new values: then the residual is large, and the matrix is factored with
      // new pivots.
      right_.assign(b, b + pattern_.size);
      if (!klu_solve(symbolic_, numeric_, pattern_.size, 1, b, &common_)) return false;
      if (relative_residual(pattern_, values_.data(), b, right_.data(), difference_) <= refactored_residual)
        return true;
      std::copy(right_.begin(), right_.end(), b);
      ++statistics_.factorizations;
      if (!factor_with_pivots(values_.data())) return false;
    }
    return klu_solve(symbolic_, numeric_, pattern_.size, 1, b, &common_);
  }

  PivotRange pivots() const override {
    PivotRange range;
    const double* diagonal = static_cast<const double*>(numeric_->Udiag);
    for (int k = 0; k < pattern_.size; ++k) range.add(diagonal[k]);
    return range;
  }
  SolverStatistics statistics() const override { return statistics_; }

private:
  void clear() {
    klu_free_numeric(&numeric_, &common_);
    klu_free_symbolic(&symbolic_, &common_);
  }

  bool factor_with_pivots(double* values) {
    refactored_ = false;
    klu_free_numeric(&numeric_, &common_);
    numeric_ = klu_factor(pattern_.starts.data(), pattern_.rows.data(), values, symbolic_, &common_);
    statistics_.memory = static_cast<double>(common_.memusage);
    const bool regular = numeric_ != nullptr && common_.status == KLU_OK && pivots().regular();
    if (regular) judge_pivots();
    return regular;
  }

  /// Looks at the pivots' signs.
  void judge_pivots() {
    const double* pivots = static_cast<const double*>(numeric_->Udiag);
    statistics_.definite = std::equal(numeric_->Pnum, numeric_->Pnum + pattern_.size, symbolic_->Q) &&
                           std::all_of(pivots, pivots + pattern_.size, [](double pivot) { return pivot > 0; });
  }

  Pattern pattern_;
  std::vector<double> values_; ///< the refactored values, with which solutions are checked
  std::vector<double> right_, difference_;
  bool refactored_ = false;
  klu_common common_{};
  klu_symbolic* symbolic_ = nullptr;
  klu_numeric* numeric_ = nullptr;
  SolverStatistics statistics_;
};

} // namespace

std::unique_ptr<DirectSolver> make_klu() {
  return std::make_unique<Klu>();
}

} // namespace signorini::solve
