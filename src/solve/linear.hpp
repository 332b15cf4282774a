#pragma once
// The linear solvers of a run behind one interface, with different strategies for sequences of systems.

#include "solve/direct.hpp"
#include "solve/mumps_module.hpp"

#include <string>

namespace signorini::solve {

/// The numbers are stored in checkpoints; 3 and 4 belonged to removed solvers.
enum class LinearKind { automatic = 0, klu = 1, umfpack = 2, condensed = 5, reuse = 6, mumps = 7 };

/// "auto", "klu", "umfpack", "condensed", "reuse", "mumps". Throws Error that lists them.
LinearKind linear_kind(const std::string& name);
/// All names that linear_kind() accepts, "auto" first.
std::vector<std::string> linear_names();
std::string name_of(LinearKind kind);

/// Solves K x = b for a sequence of matrices K with a structurally symmetric pattern.
class LinearSolver {
public:
  virtual ~LinearSolver() = default;
  /// Copies new values, in the order of the pattern. Returns false if the matrix is singular to working precision.
  virtual bool factor(const double* values) = 0;
  /// Overwrites b by K⁻¹ b, for Newton's method: its error is so small that the next correction removes it; `fully`: as
  /// accurate as the solver can, where that is not so. Call after a successful factor(), for any number of right-hand
  /// sides. Returns false if the matrix turns out to be singular to working precision.
  virtual bool solve(double* b, bool fully = false) = 0;
  /// Does so to a relative residual, by the factors at hand and without an effect on what the solver does later.
  virtual bool solve_aside(double* b, double /*tolerance*/) { return solve(b, true); }
  /// True if factors at hand show that the symmetric part of other values is positive definite; false if they do not.
  virtual bool proves_definite(const double*) const { return false; }
  virtual LinearKind kind() const = 0;
  /// Changes to another pattern of the same unknowns, for example in sliding contact, and keeps what can be reused;
  /// call factor() next. Returns false if a new solver would be as good: then construct one.
  virtual bool adopt(const Pattern&) { return false; }
  /// Sets the unknowns (increasing) on which contacts act or may soon act: entries between them may change much. A hint
  /// that does not affect solutions.
  virtual void watch(const std::vector<int>&) {}
  virtual SolverStatistics statistics() const = 0;
};

struct Condensation;

/// Options of `mumps`.
struct MumpsOptions {
  MumpsSettings settings = {};
  bool reuse = false; ///< factorizations precondition GMRES on later matrices, as approximate ones always do

  bool operator==(const MumpsOptions&) const = default;
};

/// What some solvers need to know of the systems.
struct SolverOptions {
  const Condensation* condensation = nullptr; ///< for `condensed`
  bool multipliers = false; ///< true if unknowns are Lagrange multipliers with states: for reused factorizations
  MumpsOptions mumps = {};
};

/// `klu` and `umfpack` factor every matrix by that direct solver; `reuse` reuses factorizations (reused.hpp) of
/// CHOLMOD, or of UMFPACK if the symmetric part is not positive definite; `condensed` condenses the constant part
/// (condensed.hpp) by CHOLMOD; `mumps` factors every matrix by MUMPS, or reuses its factorizations if its options say
/// so. `automatic` selects `reuse` if reuse is worthwhile, otherwise `klu`. Which is fastest:
/// share/doc/develop/benchmark.md.
std::unique_ptr<LinearSolver> make_solver(LinearKind kind, const Pattern& pattern, const SolverOptions& options = {});

/// True if a factorization costs so many solutions that it should be reused: its operations, and the entries that a
/// solution reads.
bool worth_reusing(double operations, double entries);

} // namespace signorini::solve
