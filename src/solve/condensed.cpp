#include "solve/condensed.hpp"

#include "base/error.hpp"
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
  require(is_symmetric(pattern, constant.data()), "solve.condensed.symmetric");
}

/// The nonzero part of a matrix, with the diagonal: structural entries that are always zero, such as couplings of two
/// faces, would cause fill.
Pattern nonzero(const Pattern& pattern, const std::vector<double>& values, std::vector<double>& nonzeros) {
  Pattern result{pattern.size, {0}, std::vector<int>(pattern.rows.size())};
  result.starts.reserve(pattern.starts.size());
  nonzeros.resize(pattern.rows.size());
  std::size_t count = 0;
  for (int j = 0; j < pattern.size; ++j) {
    for (std::size_t k = pattern.starts[j], end = pattern.starts[j + 1]; k < end; ++k) {
      result.rows[count] = pattern.rows[k];
      nonzeros[count] = values[k];
      if (pattern.rows[k] == j || values[k] != 0) ++count; // the next entry replaces others
    }
    result.starts.push_back(static_cast<int>(count));
  }
  result.rows.resize(count);
  nonzeros.resize(count);
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
  bool solve(double* b, bool) override {
    ++statistics_.solutions;
    return part_.solve(b);
  }
  bool proves_definite(const double* values) const override { return regular_ && part_.proves_definite(values); }
  LinearKind kind() const override { return LinearKind::condensed; }
  /// The factors do not depend on the pattern: new entries are zero in K₀, and C is read where it now is.
  bool adopt(const Pattern& pattern) override {
    part_.adopt(pattern);
    return true;
  }
  SolverStatistics statistics() const override { return statistics_; }

private:
  SymmetricPart part_; ///< K₀, with K₀ + C in the block of contact unknowns
  bool regular_;       ///< true if the interior of K₀ is regular
  SolverStatistics statistics_;
};

} // namespace

std::unique_ptr<LinearSolver> make_condensed(const Pattern& pattern, const Condensation& condensation,
                                             std::unique_ptr<SchurSolver> solver) {
  return std::make_unique<Condensed>(pattern, condensation, std::move(solver));
}

} // namespace signorini::solve
