#include "solve/automatic.hpp"

#include "solve/kept.hpp"
#include "solve/klu.hpp"

namespace signorini::solve {

namespace {

class Automatic final : public LinearSolver {
public:
  explicit Automatic(const Pattern& pattern) : pattern_(pattern), solver_(make_klu(pattern)) {}

  bool factor(const double* values) override {
    // KLU's analysis has counted before the first factorisation.
    if (solver_->kind() != LinearKind::kept &&
        worth_keeping(solver_->statistics().operations, solver_->statistics().entries)) {
      before_ = solver_->statistics();
      solver_ = make_kept(pattern_);
      solver_->watch(watched_);
    }
    return solver_->factor(values);
  }
  bool solve(double* b) override { return solver_->solve(b); }
  LinearKind kind() const override { return solver_->kind(); }
  int negative_pivots() const override { return solver_->negative_pivots(); }
  bool adopt(const Pattern& pattern) override {
    pattern_ = pattern;
    return solver_->adopt(pattern);
  }
  void watch(const std::vector<int>& unknowns) override {
    watched_ = unknowns;
    solver_->watch(unknowns);
  }
  SolverStatistics statistics() const override {
    SolverStatistics sum = solver_->statistics();
    sum.factorisations += before_.factorisations;
    sum.solutions += before_.solutions;
    return sum;
  }

private:
  Pattern pattern_;
  std::unique_ptr<LinearSolver> solver_;
  std::vector<int> watched_;
  SolverStatistics before_; ///< what was done before the choice
};

} // namespace

bool worth_keeping(double operations, double entries) {
  constexpr double many = 70;
  return operations > many * entries;
}

std::unique_ptr<LinearSolver> make_automatic(const Pattern& pattern) {
  return std::make_unique<Automatic>(pattern);
}

} // namespace signorini::solve
