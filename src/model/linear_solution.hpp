#pragma once
// The linear solver of a path: chosen, kept while it fits the tangents that come, replaced where it does not.

#include "base/eigen.hpp"
#include "model/linear_choice.hpp"

#include <memory>

namespace signorini::model {

/// An assembled tangent, by references to its parts (see Assembly).
struct Tangent {
  const std::vector<double>& values; ///< in the order of the pattern, others may follow
  const solve::Pattern& pattern;
  int pattern_version;
  const std::vector<double>& constant; ///< of bodies that are all linear elastic, values() without contact
  const std::vector<int>& contact_unknowns;
  int contact_version;
};

/// How a tangent is to be factored.
struct LinearRequest {
  solve::LinearKind kind; ///< asked for by the user
  bool damps;             ///< loose bodies are damped
};

class LinearSolution {
public:
  explicit LinearSolution(const LinearFacts& facts) : facts_(facts) {}

  /// Takes over a tangent, which may go afterwards. Returns false when it is singular to working
  /// precision. Throws Error when `condensed` is asked for where the bodies' part of the tangent changes.
  bool factor(const Tangent& tangent, const LinearRequest& request);
  /// Overwrites b by K⁻¹ b; call it after factor(). Returns false when the tangent turns out to be singular.
  bool solve(VectorX& b);
  /// Drops the solver, and keeps what it has done and come to.
  void forget();

  /// Of the present solver, or the last one; `automatic` before the first.
  solve::LinearKind kind() const { return solver_ ? solver_->kind() : past_kind_; }
  /// Of all solvers so far; memory and costs are those of the present one.
  solve::SolverStatistics statistics() const;

  /// What an automatic choice begins with: a kept factorization where it had come to one before.
  solve::LinearKind beginning() const { return beginning_; }
  void begin_with(solve::LinearKind kind) { beginning_ = kind; }

private:
  solve::LinearSolver& solver(const Tangent& tangent, const LinearRequest& request);

  LinearFacts facts_;
  std::unique_ptr<solve::LinearSolver> solver_;
  solve::SolverStatistics past_;                               ///< what those before solver_ did
  solve::LinearKind past_kind_ = solve::LinearKind::automatic; ///< of the last of them
  solve::LinearKind beginning_ = solve::LinearKind::automatic;
  solve::LinearKind asked_ = solve::LinearKind::automatic;
  int pattern_version_ = 0, contact_version_ = 0;
};

} // namespace signorini::model
