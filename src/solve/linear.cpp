#include "solve/linear.hpp"

#include "base/error.hpp"
#include "solve/condensed.hpp"
#include "solve/mumps.hpp"
#include "solve/reused.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace signorini::solve {

namespace {

struct Kind {
  LinearKind kind;
  const char* name;
  std::unique_ptr<DirectSolver> (*make)() = nullptr; ///< factors every matrix; null: see make_solver()
};

constexpr Kind kinds[] = {
    {LinearKind::automatic, "auto", make_klu},
    {LinearKind::klu, "klu", make_klu},
    {LinearKind::umfpack, "umfpack", make_umfpack},
    {LinearKind::condensed, "condensed"},
    {LinearKind::reuse, "reuse"},
    {LinearKind::mumps, "mumps"},
};

const Kind& row_of(LinearKind kind) {
  const auto row = std::find_if(std::begin(kinds), std::end(kinds), [&](const Kind& one) { return one.kind == kind; });
  return row == std::end(kinds) ? kinds[0] : *row; // the number of a removed solver
}

/// Factors every matrix.
class Direct final : public LinearSolver {
public:
  /// `solver` has analyzed the pattern.
  Direct(LinearKind kind, std::unique_ptr<DirectSolver> solver) : kind_(kind), solver_(std::move(solver)) {}

  bool factor(const double* values) override { return solver_->factor(values); }
  bool solve(double* b, bool) override { return solver_->solve(b); }
  LinearKind kind() const override { return kind_; }
  SolverStatistics statistics() const override { return solver_->statistics(); }

private:
  LinearKind kind_;
  std::unique_ptr<DirectSolver> solver_;
};

} // namespace

std::vector<std::string> linear_names() {
  std::vector<std::string> all;
  for (const Kind& row : kinds) all.emplace_back(row.name);
  return all;
}

LinearKind linear_kind(const std::string& name) {
  for (const Kind& row : kinds)
    if (name == row.name) return row.kind;
  fail("solve.linear.unknown", {{"name", name}, {"known", linear_names()}});
}

std::string name_of(LinearKind kind) {
  return row_of(kind).name;
}

bool worth_reusing(double operations, double entries) {
  return operations > reuse_above * entries;
}

std::unique_ptr<LinearSolver> make_solver(LinearKind kind, const Pattern& pattern, const SolverOptions& options) {
  if (kind == LinearKind::condensed) {
    require(options.condensation != nullptr, "solve.linear.condensed");
    return make_condensed(pattern, *options.condensation, make_schur_cholesky(dissection_above));
  }
  const double loosest = options.multipliers ? loosest_for_multipliers : loosest_tolerance;
  // Nested dissection from the start, as is best for solids
  if (kind == LinearKind::reuse) {
    const bool rounds = !options.multipliers && pattern.entries() > single_above;
    const Precision precision = rounds ? Precision::single : Precision::full;
    return make_reused(pattern, make_umfpack,
                       std::make_unique<SymmetricPart>(make_schur_cholesky(0, precision),
                                                       SymmetricPart::Border::where_cheap, precision),
                       loosest);
  }
  const MumpsSettings& settings = options.mumps.settings;
  const bool approximate = settings.low_rank > 0 || settings.single;
  if (kind == LinearKind::mumps && (options.mumps.reuse || approximate)) {
    const MakeDirect make = [settings] { return make_mumps(settings); };
    return make_reused(pattern, make, nullptr, loosest, kind);
  }
  std::unique_ptr<DirectSolver> direct = kind == LinearKind::mumps ? make_mumps(settings) : row_of(kind).make();
  direct->analyze(pattern);
  const SolverStatistics expected = direct->statistics();
  if (kind == LinearKind::automatic && worth_reusing(expected.operations, expected.entries))
    return make_solver(LinearKind::reuse, pattern, options);
  return std::make_unique<Direct>(kind == LinearKind::automatic ? LinearKind::klu : kind, std::move(direct));
}

} // namespace signorini::solve
