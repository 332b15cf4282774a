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

/// The factors of an earlier matrix: of its symmetric part if that is given and can be factored, otherwise all of it.
class Preconditioner {
public:
  enum class Kind { none, symmetric_part, direct };

  Preconditioner(MakeDirect direct, std::unique_ptr<SymmetricPart> symmetric_part)
      : symmetric_part_(std::move(symmetric_part)), make_direct_(std::move(direct)) {}

  Kind kind() const { return kind_; }
  /// Updates the block of the watched unknowns. A singular symmetric part does not imply a singular K: there is then no
  /// preconditioner.
  void update(const double* values) {
    if (kind_ == Kind::symmetric_part && !symmetric_part_->update(values)) kind_ = Kind::none;
  }
  void watch(const std::vector<int>& unknowns) {
    if (symmetric_part_) symmetric_part_->watch(unknowns);
  }
  void adopt(const Pattern& pattern);
  bool factor(const Pattern& pattern, const std::vector<double>& values);
  bool factor_directly(const Pattern& pattern, const std::vector<double>& values);
  bool apply(double* z) { return kind_ == Kind::direct ? direct_->solve(z) : symmetric_part_->solve(z); }
  SolverStatistics statistics() const;

private:
  std::unique_ptr<SymmetricPart> symmetric_part_;
  MakeDirect make_direct_;
  std::unique_ptr<DirectSolver> direct_; ///< only while it is needed
  bool analyzed_ = false;                ///< true if direct_ has analyzed the current pattern
  int direct_factorizations_ = 0;
  Kind kind_ = Kind::none;
};

void Preconditioner::adopt(const Pattern& pattern) {
  if (symmetric_part_) symmetric_part_->adopt(pattern);
  analyzed_ = false; // its factors may still be used
  if (kind_ != Kind::direct) direct_.reset();
}

bool Preconditioner::factor(const Pattern& pattern, const std::vector<double>& values) {
  if (!symmetric_part_ || !symmetric_part_->factor(pattern, values)) return factor_directly(pattern, values);
  direct_.reset();
  analyzed_ = false;
  kind_ = Kind::symmetric_part;
  return true;
}

bool Preconditioner::factor_directly(const Pattern& pattern, const std::vector<double>& values) {
  kind_ = Kind::none;
  if (!direct_) direct_ = make_direct_();
  if (!analyzed_) direct_->analyze(pattern);
  analyzed_ = true;
  ++direct_factorizations_;
  if (!direct_->factor(values.data())) return false;
  kind_ = Kind::direct;
  return true;
}

SolverStatistics Preconditioner::statistics() const {
  const SolverStatistics part = symmetric_part_ ? symmetric_part_->statistics() : SolverStatistics();
  const SolverStatistics direct = direct_ ? direct_->statistics() : SolverStatistics();
  const SolverStatistics& used = kind_ == Kind::direct ? direct : part;
  SolverStatistics sum;
  sum.factorizations = part.factorizations + direct_factorizations_;
  sum.memory = part.memory + direct.memory;
  sum.rank_memory = direct.rank_memory;
  sum.operations = used.operations;
  sum.entries = used.entries;
  return sum;
}

/// Decides when a new preconditioner pays. Costs are counted in matrix entries read.
class Renewal {
public:
  explicit Renewal(const Pattern& pattern) : pattern_(pattern) {}

  /// The preconditioner has been made from the current matrix.
  void begin(const SolverStatistics& factors);
  void change_matrix() { present_ = false; }
  /// True if the preconditioner was made from the current matrix.
  bool present() const { return present_; }
  bool due() const { return !present_ && excess_ * iteration_cost() > factor_cost_ + preparation * pattern_.entries(); }
  /// Iterations allowed before a new factorization: as many as it and the iterations after it cost.
  int budget() const;
  void record(const KrylovReport& report);
  /// Entries of the preconditioner.
  double entries() const { return entries_; }

private:
  double iteration_cost() const { return entries_ + pattern_.entries(); }

  const Pattern& pattern_;
  bool present_ = false;
  double entries_ = 0;
  double factor_cost_ = 0;
  double rate_ = 0;   ///< iterations per digit with the preconditioner of the same matrix
  double excess_ = 0; ///< iterations since the last renewal beyond those that a new preconditioner would have needed
};

void Renewal::begin(const SolverStatistics& factors) {
  present_ = true;
  entries_ = factors.entries;
  factor_cost_ =
      factors.operations > 0 ? factors.operations / operations_per_entry : most_iterations * iteration_cost();
  excess_ = 0;
}

int Renewal::budget() const {
  if (present_) return most_iterations;
  return static_cast<int>(std::min<double>(most_iterations, usual_iterations + factor_cost_ / iteration_cost()));
}

void Renewal::record(const KrylovReport& report) {
  const double digits = std::clamp(-std::log10(report.reduction), least_digits, most_digits);
  if (present_) rate_ = report.iterations / digits;
  excess_ = std::max(0.0, excess_ + report.iterations - std::max(1.0, rate_ * digits));
}

class Reused final : public LinearSolver {
public:
  Reused(const Pattern& pattern, MakeDirect direct, std::unique_ptr<SymmetricPart> symmetric_part, double loosest,
         LinearKind kind)
      : kind_(kind), pattern_(pattern), matrix_(pattern), preconditioner_(std::move(direct), std::move(symmetric_part)),
        renewal_(pattern_), forcing_(loosest), gmres_(pattern.size, most_iterations) {}
  Reused(const Reused&) = delete; // renewal_ refers to pattern_
  Reused& operator=(const Reused&) = delete;

  bool factor(const double* values) override;
  bool solve(double* b, bool fully) override;
  bool solve_aside(double* b, double tolerance) override;
  LinearKind kind() const override { return kind_; }
  bool adopt(const Pattern& pattern) override;
  void watch(const std::vector<int>& unknowns) override { preconditioner_.watch(unknowns); }
  SolverStatistics statistics() const override;

private:
  bool renew(bool directly = false);

  LinearKind kind_;
  Pattern pattern_;
  ColumnMatrix matrix_;
  Preconditioner preconditioner_;
  Renewal renewal_;
  Forcing forcing_;
  Gmres gmres_;
  bool first_ = true; ///< true if the next right-hand side is the first since factor()
  int solutions_ = 0, iterations_ = 0;
};

bool Reused::factor(const double* values) {
  matrix_.set(values);
  renewal_.change_matrix();
  first_ = true;
  preconditioner_.update(values);
  return preconditioner_.kind() != Preconditioner::Kind::none || renew();
}

bool Reused::adopt(const Pattern& pattern) {
  pattern_ = pattern;
  matrix_ = ColumnMatrix(pattern);
  preconditioner_.adopt(pattern);
  return true;
}

bool Reused::renew(bool directly) {
  const std::vector<double>& values = matrix_.values();
  if (!(directly ? preconditioner_.factor_directly(pattern_, values) : preconditioner_.factor(pattern_, values)))
    return false;
  renewal_.begin(preconditioner_.statistics());
  return true;
}

bool Reused::solve(double* b, bool fully) {
  ++solutions_;
  const bool first = std::exchange(first_, false);
  const VectorX right = Eigen::Map<const VectorX>(b, pattern_.size);
  const double norm = right.norm();
  if (norm == 0) return true;
  const double forced = first ? forcing_.next(norm) : tightest_tolerance;
  const double tolerance = fully ? tightest_tolerance : forced;
  if (first && renewal_.due() && !renew()) return false;

  const auto multiply = [this](const double* x, double* y) { matrix_.multiply(x, y); };
  const auto precondition = [this](double* z) { return preconditioner_.apply(z); };
  VectorX rest = right, part, sum = VectorX::Zero(pattern_.size);
  for (double left = 1;;) {
    const KrylovReport report = gmres_(multiply, precondition, rest, tolerance / left, renewal_.budget(), part);
    iterations_ += report.iterations;
    renewal_.record(report);
    if (std::isfinite(report.reduction)) {
      sum += part;
      left *= report.reduction;
    }
    if (left <= tolerance) break;
    // Too slow: try a better preconditioner, if there is one
    if (renewal_.present() && preconditioner_.kind() == Preconditioner::Kind::direct) return false;
    if (!renew(renewal_.present())) return false;
    matrix_.multiply(sum.data(), rest.data());
    rest = right - rest;
    left = rest.norm() / norm;
  }
  Eigen::Map<VectorX>(b, pattern_.size) = sum;
  return true;
}

bool Reused::solve_aside(double* b, double tolerance) {
  const VectorX right = Eigen::Map<const VectorX>(b, pattern_.size);
  if (right.norm() == 0) return true;
  VectorX solution;
  const KrylovReport report =
      gmres_([this](const double* x, double* y) { matrix_.multiply(x, y); },
             [this](double* z) { return preconditioner_.apply(z); }, right, tolerance, most_iterations, solution);
  if (!std::isfinite(report.reduction)) return false;
  Eigen::Map<VectorX>(b, pattern_.size) = solution;
  return true;
}

SolverStatistics Reused::statistics() const {
  SolverStatistics sum = preconditioner_.statistics();
  sum.solutions = solutions_;
  sum.iterations = iterations_;
  sum.entries = renewal_.entries();
  return sum;
}

} // namespace

std::unique_ptr<LinearSolver> make_reused(const Pattern& pattern, MakeDirect direct,
                                          std::unique_ptr<SymmetricPart> symmetric_part, double loosest,
                                          LinearKind kind) {
  return std::make_unique<Reused>(pattern, std::move(direct), std::move(symmetric_part), loosest, kind);
}

} // namespace signorini::solve
