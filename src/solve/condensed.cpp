#include "solve/condensed.hpp"

#include "base/error.hpp"
#include "base/index.hpp"
#include "solve/changing_block.hpp"

#include <algorithm>

namespace signorini::solve {

namespace {

/// With the contact unknowns c behind the interior i and the Schur complement S of K₀, what is left of the matrix after
/// the interior is S + C.
class Condensed final : public LinearSolver {
public:
  Condensed(const Pattern& pattern, const Condensation& condensation, std::unique_ptr<SchurSolver> solver);

  bool factor(const double* values) override;
  bool solve(double* b) override;
  LinearKind kind() const override { return LinearKind::condensed; }
  SolverStatistics statistics() const override { return statistics_; }

private:
  struct Entry {
    int position;    ///< in the pattern
    int row, column; ///< places among the contact unknowns
    double constant; ///< its part of K₀
  };

  std::unique_ptr<SchurSolver> solver_;
  std::vector<Entry> entries_;
  bool regular_ = false;
  ChangingBlock block_; ///< S + C
  std::vector<ChangingBlock::Change> changes_;
  std::vector<char> touched_, beside_; ///< contact unknowns that C touches; and those coupled with them
  SolverStatistics statistics_;
};

void check(const Pattern& pattern, const Condensation& condensation) {
  const auto& [constant, contact] = condensation;
  require(constant.size() == pattern.rows.size(), "condensed solver: the constant matrix has ", constant.size(),
          " values, expected ", pattern.rows.size(), ", one for each entry of the pattern");
  const bool increases = std::adjacent_find(contact.begin(), contact.end(), std::greater_equal<>()) == contact.end();
  require(increases && (contact.empty() || (contact.front() >= 0 && contact.back() < pattern.size)),
          "condensed solver: the contact unknowns must increase and lie in 0 … ", pattern.size - 1);
  require(Symmetry(pattern).holds(constant.data()), "condensed solver: the constant matrix is not symmetric");
}

/// The part of a matrix that is not zero, with the diagonal: what is zero for good, such as the couplings of two faces,
/// costs no fill.
Pattern nonzero(const Pattern& pattern, const std::vector<double>& values, std::vector<double>& kept) {
  Pattern result{pattern.size, {0}, {}};
  for (int j = 0; j < pattern.size; ++j) {
    for (int k = pattern.starts[at(j)]; k < pattern.starts[at(j) + 1]; ++k) {
      if (pattern.rows[at(k)] != j && values[at(k)] == 0) continue;
      result.rows.push_back(pattern.rows[at(k)]);
      kept.push_back(values[at(k)]);
    }
    result.starts.push_back(result.entries());
  }
  return result;
}

Condensed::Condensed(const Pattern& pattern, const Condensation& condensation, std::unique_ptr<SchurSolver> solver)
    : solver_(std::move(solver)), touched_(condensation.contact.size()), beside_(touched_.size()) {
  check(pattern, condensation);
  std::vector<double> constant;
  solver_->analyze(nonzero(pattern, condensation.constant, constant), condensation.contact);
  regular_ = solver_->factor(constant.data());
  statistics_ = solver_->statistics();
  if (!regular_) return;
  block_ = ChangingBlock(solver_->complement());
  const double contacts = static_cast<double>(condensation.contact.size());
  statistics_.memory += 4 * sizeof(double) * contacts * contacts; // of the solver, and of the changing block

  std::vector<int> place(at(pattern.size), -1);
  for (std::size_t k = 0; k < touched_.size(); ++k) place[at(solver_->border()[k])] = static_cast<int>(k);
  for (int column : condensation.contact)
    for (int k = pattern.starts[at(column)]; k < pattern.starts[at(column) + 1]; ++k)
      if (const int row = place[at(pattern.rows[at(k)])]; row >= 0)
        entries_.push_back({k, row, place[at(column)], condensation.constant[at(k)]});
  changes_.reserve(entries_.size());
}

bool Condensed::factor(const double* values) {
  if (!regular_) return false;
  ++statistics_.factorisations;
  changes_.clear();
  std::fill(touched_.begin(), touched_.end(), 0);
  for (const Entry& entry : entries_) {
    const double change = values[entry.position] - entry.constant;
    if (change == 0) continue;
    changes_.push_back({entry.row, entry.column, change});
    touched_[at(entry.row)] = touched_[at(entry.column)] = 1;
  }
  if (!block_.covers(touched_)) {
    // Contact spreads to what is beside it next.
    beside_ = touched_;
    for (const Entry& entry : entries_)
      if (touched_[at(entry.column)]) beside_[at(entry.row)] = 1;
    block_.condense(beside_);
  }
  PivotRange pivots = solver_->pivots();
  block_.factor(changes_, pivots);
  return pivots.regular();
}

bool Condensed::solve(double* b) {
  ++statistics_.solutions;
  return solver_->solve(b, [this](double* contact) {
    block_.solve(contact);
    return true;
  });
}

} // namespace

std::unique_ptr<LinearSolver> make_condensed(const Pattern& pattern, const Condensation& condensation,
                                             std::unique_ptr<SchurSolver> solver) {
  return std::make_unique<Condensed>(pattern, condensation, std::move(solver));
}

} // namespace signorini::solve
