#pragma once
// The symmetric part of a tangent, factored and kept up to date in the unknowns that contacts act on.

#include "solve/schur.hpp"

namespace signorini::solve {

/// A stand-in for the tangent K: with the watched unknowns c behind the others i, the blocks
///     M = [ K⁰_ii  K⁰_ic ]    K⁰ the symmetric part of an earlier tangent,
///         [ K⁰_ci  K_cc  ]    K_cc of the present one, unsymmetric as it is.
/// Contacts that open, close or slip change K_cc only, by much; what deformation changes in K⁰ is little. What is left
/// of M after the interior is S − K⁰_cc + K_cc with the Schur complement S of K⁰.
class SymmetricPart {
public:
  /// Whether the watched unknowns are kept behind the interior always, or only where the LU of their block takes fewer
  /// operations than the factorization that it saves; c is empty otherwise.
  enum class Border { always, where_cheap };

  explicit SymmetricPart(std::unique_ptr<SchurSolver> solver, Border kept = Border::where_cheap)
      : solver_(std::move(solver)), kept_(kept) {}

  /// Takes other unknowns for c, increasing, from the next factor() on; without any, M is K⁰.
  void watch(const std::vector<int>& unknowns);
  /// What follows is on another pattern of the same unknowns; the factors stay.
  void adopt(const Pattern& pattern);
  /// Makes K⁰ of present values; `transposed` is Kᵀ, both in the order of the pattern. Returns false when the solver
  /// cannot factor K⁰_ii, or M is singular.
  bool factor(const Pattern& pattern, const double* values, const std::vector<double>& transposed);
  /// Makes K⁰ of symmetric values in the order of the pattern; update() comes next. Returns false when the solver
  /// cannot factor K⁰_ii.
  bool condense(const Pattern& pattern, const std::vector<double>& values);
  /// Makes K_cc of present values. Returns false when M is singular.
  bool update(const double* values);
  /// Overwrites b by M⁻¹ b. Call after a successful factor() or update().
  bool solve(double* b);
  /// Of K⁰_ii, and of the block of c at the last update().
  PivotRange pivots() const;
  /// An update() is not counted as a factorization.
  SolverStatistics statistics() const;

private:
  struct Entry {
    int position;    ///< in the pattern
    int row, column; ///< places among c
  };

  void analyze(const Pattern& pattern);
  void locate(const Pattern& pattern);
  int border() const { return static_cast<int>(solver_->border().size()); }

  std::unique_ptr<SchurSolver> solver_;
  Border kept_;
  std::vector<int> watched_;
  bool analyzed_ = false;
  std::vector<Entry> entries_; ///< those between unknowns of c
  MatrixX constant_;           ///< S − K⁰_cc
  MatrixX block_;              ///< the factors of S − K⁰_cc + K_cc
  std::vector<int> exchanges_; ///< of rows, by LAPACK's numbers
  PivotRange block_pivots_;
};

} // namespace signorini::solve
