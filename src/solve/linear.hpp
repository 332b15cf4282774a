#pragma once
// The solvers of a run behind one face: each solves one system after the other in its own way.

#include "solve/direct.hpp"

#include <string>

namespace signorini::solve {

/// The numbers stand in checkpoints; 3 and 4 were solvers that are gone.
enum class LinearKind { automatic = 0, klu = 1, umfpack = 2, condensed = 5, kept = 6 };

/// "auto", "klu", "umfpack", "condensed", "kept". Throws Error that lists them.
LinearKind linear_kind(const std::string& name);
/// All names that linear_kind() knows, "auto" first.
std::vector<std::string> linear_names();
std::string name_of(LinearKind kind);

/// Solves K x = b for one K after the other on a structurally symmetric pattern.
class LinearSolver {
public:
  virtual ~LinearSolver() = default;
  /// Takes over new values in the order of the pattern; they may go when it returns. Returns false when the matrix is
  /// singular to working precision.
  virtual bool factor(const double* values) = 0;
  /// Overwrites b by K⁻¹ b, or by what comes as close as the solver promises. Call after a successful factor(). Returns
  /// false when the matrix turns out to be singular to working precision. May be called again for other right-hand
  /// sides.
  virtual bool solve(double* b) = 0;
  virtual LinearKind kind() const = 0;
  /// Goes over to another pattern of the same unknowns, as where contacts slide on, keeping what is of use; factor()
  /// comes next. Returns false when a new solver would do as well: then make one.
  virtual bool adopt(const Pattern&) { return false; }
  /// Tells which unknowns (increasing) contacts act on or will soon: what changes between them may change much. A hint;
  /// solutions are the same without.
  virtual void watch(const std::vector<int>&) {}
  virtual SolverStatistics statistics() const = 0;
};

struct Condensation;

/// `klu` and `umfpack` factor every matrix by that direct solver; `kept` reuses factorizations (reused.hpp)
/// of CHOLMOD, or of UMFPACK where the symmetric part is not positive definite; `condensed` condenses the constant part
/// (condensed.hpp) by CHOLMOD and needs the condensation, which the others pass over. `automatic` takes `klu`, but
/// `kept` where that would be worth it. Which is fastest where: share/doc/benchmark.md.
std::unique_ptr<LinearSolver> make_solver(LinearKind kind, const Pattern& pattern,
                                          const Condensation* condensation = nullptr);

/// Whether a factorization costs so many solutions that it should be reused: its operations, and the entries that a
/// solution reads.
bool worth_reusing(double operations, double entries);

} // namespace signorini::solve
