#pragma once
// Sparse direct solvers behind one face: the symbolic factorisation lives as long as the pattern, the numbers change.

#include "solve/pattern.hpp"

#include <memory>
#include <string>

namespace signorini::solve {

enum class LinearKind { automatic, klu, umfpack };

/// "auto", "klu", "umfpack". Throws Error that lists them.
LinearKind linear_kind(const std::string& name);
std::string name_of(LinearKind kind);

/// Solves K x = b for one unsymmetric K after the other on a fixed pattern.
class LinearSolver {
public:
  virtual ~LinearSolver() = default;
  /// Takes over new values in the order of the pattern; the first call also analyses. Returns false when the matrix is
  /// singular to working precision.
  virtual bool factor(const double* values) = 0;
  /// Overwrites b by K⁻¹ b. Call after a successful factor(), whose values must still be there. Returns false when the
  /// matrix turns out to be singular to working precision.
  virtual bool solve(double* b) = 0;
  virtual LinearKind kind() const = 0;
};

/// `automatic` takes KLU up to `klu_limit` unknowns and UMFPACK beyond: the measured crossing on tangents of plane
/// contact problems (tests/solve/linear_test.cpp prints the times).
std::unique_ptr<LinearSolver> make_solver(LinearKind kind, const Pattern& pattern);
inline constexpr int klu_limit = 20000;

} // namespace signorini::solve
