#include "solve/direct.hpp"

#include "base/error.hpp"

#include <umfpack.h>

#include <algorithm>

namespace signorini::solve {

namespace {

/// UMFPACK (Davis, ACM TOMS 30, 2004). Its analysis uses values too, so it is deferred to the first matrix.
class Umfpack final : public DirectSolver {
public:
  Umfpack() {
    umfpack_di_defaults(control_);
    control_[UMFPACK_STRATEGY] = UMFPACK_STRATEGY_SYMMETRIC; // the pattern is symmetric
    control_[UMFPACK_ORDERING] = UMFPACK_ORDERING_METIS;
    control_[UMFPACK_IRSTEP] = 0; // no iterative refinement, so that solutions need only the factors
  }
  ~Umfpack() override { clear(); }

  void analyze(const Pattern& pattern) override {
    clear();
    pattern_ = pattern;
    scratch_.resize(pattern.size);
  }

  bool factor(const double* values) override {
    const int *starts = pattern_.starts.data(), *rows = pattern_.rows.data();
    if (!symbolic_) {
      const int status =
          umfpack_di_symbolic(pattern_.size, pattern_.size, starts, rows, values, &symbolic_, control_, nullptr);
      require(status == UMFPACK_OK, "solve.umfpack.analyze", {{"status", status}});
    }
    umfpack_di_free_numeric(&numeric_);
    const int status = umfpack_di_numeric(starts, rows, values, symbolic_, &numeric_, control_, info_);
    ++statistics_.factorizations;
    statistics_.operations = info_[UMFPACK_FLOPS];
    statistics_.entries = info_[UMFPACK_LNZ] + info_[UMFPACK_UNZ];
    statistics_.memory = info_[UMFPACK_NUMERIC_SIZE] * info_[UMFPACK_SIZE_OF_UNIT];
    return status == UMFPACK_OK && pivots().regular();
  }

  bool solve(double* b) override {
    ++statistics_.solutions;
    const int status =
        umfpack_di_solve(UMFPACK_A, nullptr, nullptr, nullptr, scratch_.data(), b, numeric_, control_, nullptr);
    std::copy(scratch_.begin(), scratch_.end(), b);
    return status == UMFPACK_OK;
  }

  PivotRange pivots() const override { return {info_[UMFPACK_UMIN], info_[UMFPACK_UMAX]}; }
  SolverStatistics statistics() const override { return statistics_; }

private:
  void clear() {
    umfpack_di_free_numeric(&numeric_);
    umfpack_di_free_symbolic(&symbolic_);
  }

  Pattern pattern_;
  std::vector<double> scratch_;
  double control_[UMFPACK_CONTROL], info_[UMFPACK_INFO] = {};
  void* symbolic_ = nullptr;
  void* numeric_ = nullptr;
  SolverStatistics statistics_;
};

} // namespace

std::unique_ptr<DirectSolver> make_umfpack() {
  return std::make_unique<Umfpack>();
}

} // namespace signorini::solve
