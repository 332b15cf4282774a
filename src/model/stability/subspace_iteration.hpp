#pragma once
// The eigenvalues of K φ = κ M φ next to a shift.

#include "base/eigen.hpp"
#include "solve/linear.hpp"

#include <vector>

namespace signorini::model {

/// K x for each column of x; `values` in the order of the pattern.
MatrixX times(const solve::Pattern& pattern, const std::vector<double>& values, const MatrixX& x);

/// K φ = κ M φ, values in the order of the pattern. M is positive semidefinite: unknowns without mass, such as
/// multipliers, follow the others.
struct Eigenproblem {
  const solve::Pattern& pattern;
  std::vector<double> stiffness, mass;
  bool symmetric = true; ///< of K

  /// The values of K − σ M.
  std::vector<double> shifted(double shift) const;
};

/// Approximate eigenpairs, the nearest to the shift first.
struct RitzPairs {
  Eigen::VectorXcd values; ///< κ; infinite where the start vectors were dependent
  /// φᵀ M φ = 1. Complex values come in pairs, with the real and the imaginary part of φ in their two columns.
  MatrixX vectors;
  /// |(K − σM)⁻¹ M φ − φ/(κ − σ)|_M |κ − σ|: of a symmetric K, an eigenvalue differs from κ by at most this part of its
  /// distance from σ.
  VectorX errors;
};

/// Subspace iteration with (K − σM)⁻¹ M in the inner product of M, and the Rayleigh–Ritz procedure in each round
/// (K.-J. Bathe, Finite Element Procedures, 1996, 11.6): orthogonal to M, so that an unsymmetric K, whose Ritz values
/// are those of the unsymmetric small problem, takes the same way.
class SubspaceIteration {
public:
  /// With `count` vectors without preferred direction.
  SubspaceIteration(solve::LinearKind solver, Eigenproblem problem, int count);

  /// Sets σ. Returns false if K − σM is singular to working precision.
  bool shift(double shift);
  /// One round; call after a successful shift(). Returns false if the factors turn out to be singular.
  bool advance();
  /// Of the last round.
  const RitzPairs& pairs() const { return pairs_; }
  const Eigenproblem& problem() const { return problem_; }
  /// Negative pivots of K − σM, if the solver counts them; otherwise −1.
  int negative() const { return solver_->statistics().negative; }

private:
  void orthonormalize();
  void find_pairs(const MatrixX& y, const MatrixX& mass_times_y);

  Eigenproblem problem_;
  std::unique_ptr<solve::LinearSolver> solver_;
  double shift_ = 0;
  MatrixX x_, mass_times_x_;
  RitzPairs pairs_;
};

} // namespace signorini::model
