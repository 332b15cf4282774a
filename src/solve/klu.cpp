#include "solve/klu.hpp"

#include "base/error.hpp"
#include "solve/values.hpp"

#include <klu.h>

#include <algorithm>

namespace signorini::solve {

namespace {

/// KLU (Davis & Palamadai Natarajan, ACM TOMS 37, 2010): a refactorisation keeps the pivots of the last full one and
/// costs a fraction of it; growth of the factors tells when the pivots no longer fit.
class Klu final : public LinearSolver {
public:
  explicit Klu(const Pattern& pattern) : pattern_(pattern), right_(static_cast<std::size_t>(pattern.size)) {
    klu_defaults(&common_);
    common_.btf = 0;      // the tangent is structurally symmetric and irreducible
    common_.ordering = 0; // approximate minimum degree
    common_.scale = -1;   // none: pivots are compared within a column, where the entries are of one kind
    symbolic_ = klu_analyze(pattern_.size, pattern_.starts.data(), pattern_.rows.data(), &common_);
    require(symbolic_ != nullptr || pattern_.size == 0, "the sparse solver could not analyse the tangent (KLU status ",
            common_.status, ")");
    if (!symbolic_) return;
    statistics_.operations = symbolic_->est_flops;
    statistics_.entries = symbolic_->lnz + symbolic_->unz;
  }
  ~Klu() override {
    klu_free_numeric(&numeric_, &common_);
    klu_free_symbolic(&symbolic_, &common_);
  }

  bool factor(const double* values) override {
    values_ = const_cast<double*>(values); // KLU reads the values only
    ++statistics_.factorisations;
    refactored_ = numeric_ &&
                  klu_refactor(pattern_.starts.data(), pattern_.rows.data(), values_, symbolic_, numeric_, &common_) &&
                  common_.status == KLU_OK && regular();
    return refactored_ || factor_with_pivots();
  }

  bool solve(double* b) override {
    ++statistics_.solutions;
    if (refactored_) {
      // Kept pivots can be bad ones for the new values: then K x = b is missed, and new pivots are taken.
      std::copy_n(b, pattern_.size, right_.data());
      if (!klu_solve(symbolic_, numeric_, pattern_.size, 1, b, &common_)) return false;
      if (relative_residual(pattern_, values_, b, right_.data(), difference_) <= 1e-8) return true;
      std::copy(right_.begin(), right_.end(), b);
      ++statistics_.factorisations;
      if (!factor_with_pivots()) return false;
    }
    return klu_solve(symbolic_, numeric_, pattern_.size, 1, b, &common_);
  }
  LinearKind kind() const override { return LinearKind::klu; }
  SolverStatistics statistics() const override { return statistics_; }

private:
  bool factor_with_pivots() {
    refactored_ = false;
    klu_free_numeric(&numeric_, &common_);
    numeric_ = klu_factor(pattern_.starts.data(), pattern_.rows.data(), values_, symbolic_, &common_);
    statistics_.memory = static_cast<double>(common_.memusage);
    return numeric_ != nullptr && common_.status == KLU_OK && regular();
  }

  bool regular() { return klu_rcond(symbolic_, numeric_, &common_) && common_.rcond > least_pivot; }

  Pattern pattern_;
  std::vector<double> right_, difference_;
  double* values_ = nullptr;
  bool refactored_ = false;
  klu_common common_{};
  klu_symbolic* symbolic_ = nullptr;
  klu_numeric* numeric_ = nullptr;
  SolverStatistics statistics_;
};

} // namespace

std::unique_ptr<LinearSolver> make_klu(const Pattern& pattern) {
  return std::make_unique<Klu>(pattern);
}

} // namespace signorini::solve
