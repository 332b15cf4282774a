#pragma once
// The linear solver of a path: chosen for the first tangent, reused as long as it suits the following ones, otherwise
// replaced.

#include "model/system/system.hpp"
#include "solve/linear.hpp"

#include <memory>

namespace signorini::model {

/// Properties of a scene that decide the automatic choice.
struct LinearFacts {
  bool constant_bulk; ///< all bodies are linear elastic, no load follows, and there are contacts or ties: only the
                      ///< contacts' part changes
  bool multipliers;   ///< contacts have Lagrange multipliers as unknowns
  bool potential;     ///< the tangent is symmetric: all contacts and loads have a potential
};
template <int D> LinearFacts linear_facts(const System<D>& system);

/// The first solver of a path; `automatic`: see solve::make_solver. `damps`: see LinearRequest.
solve::LinearKind first_choice(const LinearFacts& facts, bool damps);

/// References to the parts of an assembled tangent (see Assembly).
struct Tangent {
  const std::vector<double>& values; ///< in the order of the pattern; unused values may follow
  const solve::Pattern& pattern;
  int pattern_version;
  const std::vector<double>& constant; ///< values without contact if all bodies are linear elastic, otherwise empty
  const std::vector<int>& contact_unknowns;
  int contact_version;
};

/// How a tangent is to be factored.
struct LinearRequest {
  solve::LinearKind kind = solve::LinearKind::automatic; ///< the user's choice
  bool damps = false;                                    ///< damping has changed the tangent of bodies
  solve::MumpsOptions mumps = {};
};

class LinearSolution {
public:
  explicit LinearSolution(const LinearFacts& facts) : facts_(facts) {}

  /// Factors a tangent, which need not outlive the call. Returns false if it is singular to working precision. Throws
  /// Error if the request is `condensed` but the bodies' part of the tangent changes.
  bool factor(const Tangent& tangent, const LinearRequest& request);
  /// Overwrites b by K⁻¹ b; requires factor(). Returns false if the tangent is singular. `fully`: see
  /// solve::LinearSolver.
  bool solve(VectorX& b, bool fully = false);
  /// True if there are factors.
  bool is_ready() const { return solver_ != nullptr; }
  /// Overwrites b by K⁻¹ b to a relative residual, without an effect on later solutions; requires is_ready().
  bool solve_aside(VectorX& b, double tolerance) { return b.size() == 0 || solver_->solve_aside(b.data(), tolerance); }
  /// Overwrites b by K⁻¹ b for a tangent that differs little from that of the factors, by iterative refinement,
  /// likewise without an effect on later solutions; false, with b unchanged, if it does not converge.
  bool solve_near(const Tangent& tangent, VectorX& b);
  /// True if the present factors show that the symmetric part of a tangent is positive definite.
  bool proves_definite(const Tangent& tangent) const;
  /// Drops the solver, but keeps its statistics and its choice.
  void forget();

  /// Kind of the current or last solver; `automatic` before the first.
  solve::LinearKind kind() const { return solver_ ? solver_->kind() : past_kind_; }
  /// Statistics of all solvers so far; memory and costs are those of the current one.
  solve::SolverStatistics statistics() const;

  /// Kind with which an automatic choice starts: a reused factorization if it had been chosen before.
  solve::LinearKind beginning() const { return beginning_; }
  void begin_with(solve::LinearKind kind) { beginning_ = kind; }
  /// Continues the statistics and the choice of another path's solver, for other unknowns.
  void continue_from(const LinearSolution& other) {
    past_ = other.statistics();
    past_kind_ = other.kind();
    beginning_ = other.beginning_;
  }

private:
  solve::LinearSolver& solver(const Tangent& tangent, const LinearRequest& request);

  LinearFacts facts_;
  std::unique_ptr<solve::LinearSolver> solver_;
  solve::SolverStatistics past_;                               ///< of the solvers before solver_
  solve::LinearKind past_kind_ = solve::LinearKind::automatic; ///< of the last of these
  solve::LinearKind beginning_ = solve::LinearKind::automatic;
  LinearRequest last_; ///< of the last tangent
  int pattern_version_ = 0, contact_version_ = 0;
};

} // namespace signorini::model
