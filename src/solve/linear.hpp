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

/// `automatic` takes KLU up to `klu_limit` unknowns and UMFPACK beyond. Measured on plane frictional ironing with N2
/// (scripts/ironing2d.lua mesh=… labels=N2 linear=…), time of KLU over that of UMFPACK: 0.2 with 134 degrees of
/// freedom, 0.3 with 402, 0.7 with 1370, 1.3 with 5034; small systems gain by the refactorisation, large ones by dense
/// kernels.
std::unique_ptr<LinearSolver> make_solver(LinearKind kind, const Pattern& pattern);
inline constexpr int klu_limit = 2500;

} // namespace signorini::solve
