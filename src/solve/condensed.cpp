#include "solve/condensed.hpp"

#include "base/error.hpp"
#include "base/index.hpp"
#include "solve/symmetric_part.hpp"

#include <algorithm>

namespace signorini::solve {

namespace {

void check(const Pattern& pattern, const Condensation& condensation) {
  const auto& [constant, contact] = condensation;
  require(constant.size() == pattern.rows.size(), "solve.condensed.size",
          {{"count", constant.size()}, {"expected", pattern.rows.size()}});
  const bool increases = std::adjacent_find(contact.begin(), contact.end(), std::greater_equal<>()) == contact.end();
  require(increases && (contact.empty() || (contact.front() >= 0 && contact.back() < pattern.size)),
          "solve.condensed.contact", {{"most", pattern.size - 1}});
  require(Symmetry(pattern).holds(constant.data()), "solve.condensed.symmetric");
}

/// The nonzero part of a matrix, with the diagonal: structural entries that are always zero, such as couplings of two
/// faces, would cause fill.
Pattern nonzero(const Pattern& pattern, const std::vector<double>& values, std::vector<double>& nonzeros) {
  Pattern result{pattern.size, {0}, {}};
  result.starts.reserve(pattern.starts.size());
  result.rows.reserve(pattern.rows.size());
  nonzeros.reserve(pattern.rows.size());
  for (int j = 0; j < pattern.size; ++j) {
    for (int k = pattern.starts[at(j)]; k < pattern.starts[at(j) + 1]; ++k) {
      if (pattern.rows[at(k)] != j && values[at(k)] == 0) continue;
      result.rows.push_back(pattern.rows[at(k)]);
      nonzeros.push_back(values[at(k)]);
    }
    result.starts.push_back(result.entries());
  }
  return result;
}

/// With the contact unknowns c ordered after the interior i and the Schur complement S of K₀, elimination of the
/// interior leaves S + C.
class Condensed final : public LinearSolver {
public:
  Condensed(const Pattern& pattern, const Condensation& condensation, std::unique_ptr<SchurSolver> solver)
      : part_(std::move(solver), SymmetricPart::Border::always) {
    check(pattern, condensation);
    std::vector<double> constant;
    const Pattern filled = nonzero(pattern, condensation.constant, constant);
    part_.watch(condensation.contact);
    regular_ = part_.condense(filled, constant);
    part_.adopt(pattern);
    statistics_ = part_.statistics();
    const double contacts = static_cast<double>(condensation.contact.size());
    statistics_.memory += sizeof(double) * contacts * contacts; // of S, which the solver stores
  }

  bool factor(const double* values) override {
    ++statistics_.factorizations;
    return regular_ && part_.update(values) && part_.pivots().regular();
  }
  bool solve(double* b) override {
    ++statistics_.solutions;
    return part_.solve(b);
  }
  LinearKind kind() const override { return LinearKind::condensed; }
  /// The factors do not depend on the pattern: new entries are zero in K₀, and C is read where it now is.
  bool adopt(const Pattern& pattern) override {
    part_.adopt(pattern);
    return true;
  }
  SolverStatistics statistics() const override { return statistics_; }

private:
  SymmetricPart part_; ///< K₀, with K₀ + C in the block of contact unknowns
  bool regular_;       ///< whether the interior of K₀ is regular
  SolverStatistics statistics_;
};

} // namespace

std::unique_ptr<LinearSolver> make_condensed(const Pattern& pattern, const Condensation& condensation,
                                             std::unique_ptr<SchurSolver> solver) {
  return std::make_unique<Condensed>(pattern, condensation, std::move(solver));
}

} // namespace signorini::solve
