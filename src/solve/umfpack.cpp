#include "solve/umfpack.hpp"

#include "base/error.hpp"
#include "solve/values.hpp"

#include <umfpack.h>

#include <algorithm>

namespace signorini::solve {

namespace {

/// UMFPACK (Davis, ACM TOMS 30, 2004). Its analysis looks at values too, so it waits for the first real matrix.
class Umfpack final : public LinearSolver {
public:
  explicit Umfpack(const Pattern& pattern) : pattern_(pattern), scratch_(static_cast<std::size_t>(pattern.size)) {
    umfpack_di_defaults(control_);
    control_[UMFPACK_STRATEGY] = UMFPACK_STRATEGY_SYMMETRIC; // the pattern is symmetric
    control_[UMFPACK_ORDERING] = UMFPACK_ORDERING_METIS;
    control_[UMFPACK_IRSTEP] = 0; // no refinement, so that solutions need the factors only
  }
  ~Umfpack() override {
    umfpack_di_free_numeric(&numeric_);
    umfpack_di_free_symbolic(&symbolic_);
  }

  bool factor(const double* values) override {
    const int *starts = pattern_.starts.data(), *rows = pattern_.rows.data();
    if (!symbolic_) {
      const int status =
          umfpack_di_symbolic(pattern_.size, pattern_.size, starts, rows, values, &symbolic_, control_, nullptr);
      require(status == UMFPACK_OK, "the sparse solver could not analyse the tangent (UMFPACK status ", status, ")");
    }
    umfpack_di_free_numeric(&numeric_);
    double info[UMFPACK_INFO];
    const int status = umfpack_di_numeric(starts, rows, values, symbolic_, &numeric_, control_, info);
    ++statistics_.factorisations;
    statistics_.operations = info[UMFPACK_FLOPS];
    statistics_.entries = info[UMFPACK_LNZ] + info[UMFPACK_UNZ];
    statistics_.memory = info[UMFPACK_NUMERIC_SIZE] * info[UMFPACK_SIZE_OF_UNIT];
    return status == UMFPACK_OK && info[UMFPACK_RCOND] > least_pivot;
  }

  bool solve(double* b) override {
    ++statistics_.solutions;
    const int status =
        umfpack_di_solve(UMFPACK_A, nullptr, nullptr, nullptr, scratch_.data(), b, numeric_, control_, nullptr);
    std::copy(scratch_.begin(), scratch_.end(), b);
    return status == UMFPACK_OK;
  }
  LinearKind kind() const override { return LinearKind::umfpack; }
  SolverStatistics statistics() const override { return statistics_; }

private:
  Pattern pattern_;
  std::vector<double> scratch_;
  double control_[UMFPACK_CONTROL];
  void* symbolic_ = nullptr;
  void* numeric_ = nullptr;
  SolverStatistics statistics_;
};

} // namespace

std::unique_ptr<LinearSolver> make_umfpack(const Pattern& pattern) {
  return std::make_unique<Umfpack>(pattern);
}

} // namespace signorini::solve
