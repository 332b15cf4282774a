#include "solve/kept.hpp"

#include "solve/gmres.hpp"
#include "solve/rows.hpp"
#include "solve/symmetric_part.hpp"
#include "solve/umfpack.hpp"

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
  return std::clamp(0.1 * expected * expected, tightest, loosest);
}

namespace {

constexpr int most_iterations = 40;

class Kept final : public LinearSolver {
public:
  explicit Kept(const Pattern& pattern) : pattern_(pattern), matrix_(pattern), gmres_(pattern.size, most_iterations) {}

  bool factor(const double* values) override;
  bool solve(double* b) override;
  LinearKind kind() const override { return LinearKind::kept; }
  bool adopt(const Pattern& pattern) override;
  void watch(const std::vector<int>& unknowns) override { symmetric_part_.watch(unknowns); }
  SolverStatistics statistics() const override;

private:
  enum class Preconditioner { none, symmetric_part, pivoting };

  bool renew();
  bool renew_with_pivots();
  void begin_cycle(Preconditioner used, const SolverStatistics& factors);
  bool apply(double* z);
  double iteration_cost() const;
  int budget() const;
  void write_down(double cost);

  Pattern pattern_;
  RowMatrix matrix_;
  const double* values_ = nullptr;
  SymmetricPart symmetric_part_;
  std::unique_ptr<LinearSolver> pivoting_;
  Preconditioner used_ = Preconditioner::none;
  bool present_ = false; ///< whether the preconditioner was made from the present values
  bool first_ = true;    ///< whether the next right-hand side is the first since factor()
  Forcing forcing_;
  Gmres gmres_;
  VectorX right_, rest_, part_, sum_;
  double entries_ = 0; ///< of the preconditioner that is used
  double factor_cost_ = 0;
  double cost_ = 0;        ///< since the preconditioner was made, which is included
  int solutions_ = 0;      ///< since then
  double recent_cost_ = 0; ///< of a solution, on average over the last few
  SolverStatistics statistics_;
};

/// Costs are counted in entries of a matrix that are read.
double Kept::iteration_cost() const {
  return entries_ + 1.5 * pattern_.entries(); // an entry of K comes with its index
}

bool Kept::factor(const double* values) {
  values_ = values;
  matrix_.set(values);
  present_ = false;
  first_ = true;
  // A part that is singular all the same tells nothing of K.
  if (used_ == Preconditioner::symmetric_part && !symmetric_part_.update(values)) used_ = Preconditioner::none;
  return used_ != Preconditioner::none || renew();
}

bool Kept::adopt(const Pattern& pattern) {
  pattern_ = pattern;
  matrix_ = RowMatrix(pattern);
  symmetric_part_.adopt(pattern);
  if (used_ != Preconditioner::pivoting) pivoting_.reset();
  return true;
}

void Kept::begin_cycle(Preconditioner used, const SolverStatistics& factors) {
  // Dense kernels do about ten operations while one entry of the factors is read.
  constexpr double operations_per_entry = 10;
  used_ = used;
  present_ = true;
  entries_ = factors.entries;
  cost_ = factor_cost_ = factors.operations / operations_per_entry;
  solutions_ = 0;
}

bool Kept::renew() {
  if (!symmetric_part_.factor(pattern_, values_, matrix_.values())) return renew_with_pivots();
  pivoting_.reset();
  begin_cycle(Preconditioner::symmetric_part, symmetric_part_.statistics());
  return true;
}

bool Kept::renew_with_pivots() {
  used_ = Preconditioner::none;
  pivoting_ = make_umfpack(pattern_);
  ++statistics_.factorisations;
  if (!pivoting_->factor(values_)) return false;
  begin_cycle(Preconditioner::pivoting, pivoting_->statistics());
  return true;
}

bool Kept::apply(double* z) {
  return used_ == Preconditioner::pivoting ? pivoting_->solve(z) : symmetric_part_.solve(z);
}

/// How many iterations to spend before a new factorisation: as many as it costs, and what would follow it.
int Kept::budget() const {
  if (present_) return most_iterations;
  constexpr int usual = 6;
  return static_cast<int>(std::min<double>(most_iterations, usual + factor_cost_ / iteration_cost()));
}

void Kept::write_down(double cost) {
  // A step asks for few digits at first and many in the end, so single solutions say little.
  constexpr double weight = 0.25;
  recent_cost_ = solutions_ == 0 ? cost : recent_cost_ + weight * (cost - recent_cost_);
  cost_ += cost;
  ++solutions_;
}

bool Kept::solve(double* b) {
  ++statistics_.solutions;
  const bool first = std::exchange(first_, false);
  right_ = rest_ = Eigen::Map<const VectorX>(b, pattern_.size);
  const double norm = right_.norm();
  if (norm == 0) return true;
  const double tolerance = first ? forcing_.next(norm) : Forcing::tightest;
  if (first && recent_cost_ * solutions_ > cost_ && !renew()) return false;

  const auto multiply = [this](const double* x, double* y) { matrix_.multiply(x, y); };
  const auto precondition = [this](double* z) { return apply(z); };
  sum_.setZero(pattern_.size);
  for (double left = 1;;) {
    const KrylovReport report = gmres_(multiply, precondition, rest_, tolerance / left, budget(), part_);
    statistics_.iterations += report.iterations;
    write_down(report.iterations * iteration_cost());
    if (std::isfinite(report.reduction)) {
      sum_ += part_;
      left *= report.reduction;
    }
    if (left <= tolerance) break;
    // Too slow: a better preconditioner, as long as there is one
    if (present_ && used_ == Preconditioner::pivoting) return false;
    if (!(present_ ? renew_with_pivots() : renew())) return false;
    matrix_.multiply(sum_.data(), rest_.data());
    rest_ = right_ - rest_;
    left = rest_.norm() / norm;
  }
  Eigen::Map<VectorX>(b, pattern_.size) = sum_;
  return true;
}

SolverStatistics Kept::statistics() const {
  SolverStatistics sum = statistics_;
  const SolverStatistics& part = symmetric_part_.statistics();
  sum.factorisations += part.factorisations;
  sum.memory += part.memory;
  const SolverStatistics pivoting = pivoting_ ? pivoting_->statistics() : SolverStatistics();
  sum.memory += pivoting.memory;
  sum.operations = used_ == Preconditioner::pivoting ? pivoting.operations : part.operations;
  sum.entries = entries_;
  return sum;
}

} // namespace

std::unique_ptr<LinearSolver> make_kept(const Pattern& pattern) {
  return std::make_unique<Kept>(pattern);
}

} // namespace signorini::solve
