#pragma once
// The symmetric part of a tangent, factored, with an up-to-date block of the unknowns on which contacts act.

#include "solve/dense_factors.hpp"
#include "solve/schur.hpp"

#include <variant>

namespace signorini::solve {

/// The block S − K⁰_cc + K_cc of the watched unknowns, see SymmetricPart, and its LU.
class WatchedBlock {
public:
  /// `precision`: of the factors; full precision where single does not show whether the block is singular.
  explicit WatchedBlock(Precision precision) : precision_(precision) {}

  /// Finds the entries between the watched unknowns, given in the order of the rows of S.
  void locate(const Pattern& pattern, const std::vector<int>& border);
  /// Sets S and K⁰_cc.
  void set_constant(const MatrixX& complement, const double* values);
  /// Sets and factors K_cc from the current values. Returns false if the block is singular.
  bool update(const double* values);
  /// Overwrites b by the solution; call after a successful update().
  void solve(double* b);
  bool is_positive_definite(const double* values) const;
  int size() const { return std::ssize(places_); }
  /// At the last update().
  PivotRange pivots() const { return pivots_; }

private:
  /// Entries of a column of K_cc in consecutive rows.
  struct Run {
    int position;            ///< of the first in the pattern
    int row, column, length; ///< indices in c
  };
  template <class Real> void set(const double* values, DenseMatrix<Real>& block) const;
  template <class Real> bool factor(const double* values);

  Precision precision_;
  std::vector<int> places_; ///< per row of S: the index in c, which increases with the number of the unknown
  std::vector<Run> runs_;   ///< the entries between unknowns of c
  MatrixX constant_;        ///< S − K⁰_cc
  std::variant<DenseMatrix<double>, DenseMatrix<float>> factors_;
  std::vector<int> exchanges_; ///< row exchanges in LAPACK's numbering
  PivotRange pivots_;
};

/// An approximation of the tangent K as preconditioner: with the watched unknowns c ordered after the others i, the
/// blocks
///     M = [ K⁰_ii  K⁰_ic ]    K⁰ the symmetric part of an earlier tangent,
///         [ K⁰_ci  K_cc  ]    K_cc of the current one, possibly unsymmetric.
/// Opening, closing and slipping contacts change only K_cc, by much; deformation changes K⁰ by little. Elimination of
/// the interior from M leaves S − K⁰_cc + K_cc with the Schur complement S of K⁰ [theory 10.5].
class SymmetricPart {
public:
  /// The watched unknowns form the border always, or only if the LU of their block needs fewer operations than
  /// the factorization that it saves, and the border does not make that much more expensive; otherwise c is empty.
  enum class Border { always, where_cheap };

  /// `precision`: of the factors of the block of c; full precision where single does not show whether it is singular.
  explicit SymmetricPart(std::unique_ptr<SchurSolver> solver, Border policy = Border::where_cheap,
                         Precision precision = Precision::full);

  /// Sets the unknowns c, increasing, from the next factor() on; without any, M is K⁰.
  void watch(const std::vector<int>& unknowns);
  /// The following matrices have another pattern of the same unknowns; the factors are reused.
  void adopt(const Pattern& pattern);
  /// Sets K⁰ from the current values, in the order of the pattern. Returns false if the solver cannot factor K⁰_ii, or
  /// M is singular.
  bool factor(const Pattern& pattern, const std::vector<double>& values);
  /// Sets K⁰ to symmetric values in the order of the pattern; call update() next. Returns false if the solver cannot
  /// factor K⁰_ii.
  bool condense(const Pattern& pattern, const std::vector<double>& values);
  /// Sets K_cc from the current values. Returns false if M is singular.
  bool update(const double* values);
  /// Overwrites b by M⁻¹ b. Call after a successful factor() or update().
  bool solve(double* b);
  /// True if the factors of K⁰_ii show that M with K_cc from other values has a positive definite symmetric part.
  bool proves_definite(const double* values) const;
  /// Pivots of K⁰_ii, and of the block of c at the last update().
  PivotRange pivots() const;
  /// An update() is not counted as a factorization.
  SolverStatistics statistics() const;

private:
  void analyze(const Pattern& pattern);

  std::unique_ptr<SchurSolver> solver_;
  Border policy_;
  std::vector<int> watched_;
  bool analyzed_ = false;
  WatchedBlock block_;
};

} // namespace signorini::solve
