#include "solve/reused.hpp"

#include "solve/columns.hpp"
#include "solve/gmres.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace signorini::solve {

double Forcing::next(double norm) {
  const double reduction = norm / last_;
  const bool begins = !(reduction < 1);
  if (!begins && began_) first_reduction_ = reduction;
  began_ = begins;
  last_ = norm;
  const double expected = begins ? first_reduction_ : reduction;
  return std::clamp(small_part * expected * expected, tightest_tolerance, loosest_);
}

namespace {

class Reused final : public LinearSolver {
public:
  Reused(const Pattern& pattern, MakeDirect direct, std::unique_ptr<SymmetricPart> symmetric_part, double loosest,
         LinearKind kind)
      : kind_(kind), pattern_(pattern), matrix_(pattern), symmetric_part_(std::move(symmetric_part)),
        make_direct_(std::move(direct)), forcing_(loosest), gmres_(pattern.size, most_iterations) {}

  bool factor(const double* values) override;
  bool solve(double* b) override;
  void solve_fully() override { fully_ = true; }
  LinearKind kind() const override { return kind_; }
  bool adopt(const Pattern& pattern) override;
  void watch(const std::vector<int>& unknowns) override {
    if (symmetric_part_) symmetric_part_->watch(unknowns);
  }
  SolverStatistics statistics() const override;

private:
  enum class Preconditioner { none, symmetric_part, direct };

  bool renew();
  bool renew_direct();
  void begin_cycle(Preconditioner used, const SolverStatistics& factors);
  bool apply(double* z);
  double iteration_cost() const;
  int budget() const;
  void record(const KrylovReport& report);

  LinearKind kind_;
  Pattern pattern_;
  ColumnMatrix matrix_;
  std::unique_ptr<SymmetricPart> symmetric_part_;
  MakeDirect make_direct_;
  std::unique_ptr<DirectSolver> direct_; ///< only while it is needed
  bool analyzed_ = false;                ///< whether direct_ has analyzed the current pattern
  Preconditioner used_ = Preconditioner::none;
  bool present_ = false; ///< whether the preconditioner was made from the current values
  bool first_ = true;    ///< whether the next right-hand side is the first since factor()
  bool fully_ = false;   ///< whether it is to be solved to the tightest tolerance
  Forcing forcing_;
  Gmres gmres_;
  VectorX right_, rest_, part_, sum_;
  double entries_ = 0; ///< of the current preconditioner
  double factor_cost_ = 0;
  double rate_ = 0;   ///< iterations per digit with the preconditioner of the same matrix
  double excess_ = 0; ///< iterations since the last renewal beyond those that a new preconditioner would have needed
  SolverStatistics statistics_;
};

/// Costs are counted in matrix entries read.
double Reused::iteration_cost() const {
  return entries_ + pattern_.entries();
}

bool Reused::factor(const double* values) {
  matrix_.set(values);
  present_ = false;
  first_ = true;
  // A singular symmetric part does not imply a singular K: renew() decides.
  if (used_ == Preconditioner::symmetric_part && !symmetric_part_->update(values)) used_ = Preconditioner::none;
  return used_ != Preconditioner::none || renew();
}

bool Reused::adopt(const Pattern& pattern) {
  pattern_ = pattern;
  matrix_ = ColumnMatrix(pattern);
  if (symmetric_part_) symmetric_part_->adopt(pattern);
  analyzed_ = false; // its factors may still be used
  if (used_ != Preconditioner::direct) direct_.reset();
  return true;
}

void Reused::begin_cycle(Preconditioner used, const SolverStatistics& factors) {
  used_ = used;
  present_ = true;
  entries_ = factors.entries;
  factor_cost_ =
      factors.operations > 0 ? factors.operations / operations_per_entry : most_iterations * iteration_cost();
  excess_ = 0;
}

bool Reused::renew() {
  if (!symmetric_part_ || !symmetric_part_->factor(pattern_, matrix_.values())) return renew_direct();
  direct_.reset();
  analyzed_ = false;
  begin_cycle(Preconditioner::symmetric_part, symmetric_part_->statistics());
  return true;
}

bool Reused::renew_direct() {
  used_ = Preconditioner::none;
  if (!direct_) direct_ = make_direct_();
  if (!analyzed_) direct_->analyze(pattern_);
  analyzed_ = true;
  ++statistics_.factorizations;
  if (!direct_->factor(matrix_.values().data())) return false;
  begin_cycle(Preconditioner::direct, direct_->statistics());
  return true;
}

bool Reused::apply(double* z) {
  return used_ == Preconditioner::direct ? direct_->solve(z) : symmetric_part_->solve(z);
}

/// Iterations allowed before a new factorization: as many as it and the iterations after it cost.
int Reused::budget() const {
  if (present_) return most_iterations;
  return static_cast<int>(std::min<double>(most_iterations, usual_iterations + factor_cost_ / iteration_cost()));
}

void Reused::record(const KrylovReport& report) {
  statistics_.iterations += report.iterations;
  const double digits = std::clamp(-std::log10(report.reduction), least_digits, most_digits);
  if (present_) rate_ = report.iterations / digits;
  excess_ = std::max(0.0, excess_ + report.iterations - std::max(1.0, rate_ * digits));
}

bool Reused::solve(double* b) {
  ++statistics_.solutions;
  const bool first = std::exchange(first_, false);
  right_ = rest_ = Eigen::Map<const VectorX>(b, pattern_.size);
  const double norm = right_.norm();
  if (norm == 0) return true;
  const double forced = first ? forcing_.next(norm) : tightest_tolerance;
  const double tolerance = std::exchange(fully_, false) ? tightest_tolerance : forced;
  const double renewal_cost = factor_cost_ + preparation * pattern_.entries();
  if (first && !present_ && excess_ * iteration_cost() > renewal_cost && !renew()) return false;

  const auto multiply = [this](const double* x, double* y) { matrix_.multiply(x, y); };
  const auto precondition = [this](double* z) { return apply(z); };
  sum_.setZero(pattern_.size);
  for (double left = 1;;) {
    const KrylovReport report = gmres_(multiply, precondition, rest_, tolerance / left, budget(), part_);
    record(report);
    if (std::isfinite(report.reduction)) {
      sum_ += part_;
      left *= report.reduction;
    }
    if (left <= tolerance) break;
    // Too slow: try a better preconditioner, if there is one
    if (present_ && used_ == Preconditioner::direct) return false;
    if (!(present_ ? renew_direct() : renew())) return false;
    matrix_.multiply(sum_.data(), rest_.data());
    rest_ = right_ - rest_;
    left = rest_.norm() / norm;
  }
  Eigen::Map<VectorX>(b, pattern_.size) = sum_;
  return true;
}

SolverStatistics Reused::statistics() const {
  const SolverStatistics part = symmetric_part_ ? symmetric_part_->statistics() : SolverStatistics();
  const SolverStatistics direct = direct_ ? direct_->statistics() : SolverStatistics();
  SolverStatistics sum = statistics_;
  sum.factorizations += part.factorizations;
  sum.memory = part.memory + direct.memory;
  sum.rank_memory = direct.rank_memory;
  sum.operations = used_ == Preconditioner::direct ? direct.operations : part.operations;
  sum.entries = entries_;
  return sum;
}

} // namespace

std::unique_ptr<LinearSolver> make_reused(const Pattern& pattern, MakeDirect direct,
                                          std::unique_ptr<SymmetricPart> symmetric_part, double loosest,
                                          LinearKind kind) {
  return std::make_unique<Reused>(pattern, std::move(direct), std::move(symmetric_part), loosest, kind);
}

} // namespace signorini::solve
