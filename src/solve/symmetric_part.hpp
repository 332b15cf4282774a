#pragma once
// Cholesky's factorisation of the symmetric part of a tangent, kept up to date in the unknowns that contacts act on.

#include "base/eigen.hpp"
#include "solve/linear.hpp"

namespace signorini::solve {

/// A stand-in for the tangent K: with the watched unknowns c behind the others i, the blocks
///     M = [ K⁰_ii  K⁰_ic ]    K⁰ the symmetric part of an earlier tangent,
///         [ K⁰_ci  K_cc  ]    K_cc of the present one, unsymmetric as it is.
/// Contacts that open, close or slip change K_cc only, by much; what deformation changes in K⁰ is little.
///     P (K⁰ + D) Pᵀ = L Lᵀ on supernodes,   S = L_cc L_ccᵀ − K⁰_cc − D + K_cc,
/// with a shift D of c's diagonal, so that K⁰_cc need not be definite; M x = b is L z = P b, S x_c = L_cc z_c,
/// Lᵀ x = (z_i, L_ccᵀ x_c).
class SymmetricPart {
public:
  SymmetricPart();
  ~SymmetricPart();

  /// Takes other unknowns for c, increasing, from the next factor() on; without any, M is K⁰.
  void watch(const std::vector<int>& unknowns);
  /// What follows is on another pattern of the same unknowns; the factors stay.
  void adopt(const Pattern& pattern);
  /// Makes K⁰ of present values; `transposed` is Kᵀ, both in the order of the pattern. Returns false when K⁰ + D is not
  /// positive definite to working precision, or S is singular.
  bool factor(const Pattern& pattern, const double* values, const std::vector<double>& transposed);
  /// Makes K_cc of present values. Returns false when S is singular.
  bool update(const double* values);
  /// Overwrites b by M⁻¹ b. Call after a successful factor() or update().
  bool solve(double* b);
  /// An update() is not counted as a factorisation; its operations are update_operations().
  const SolverStatistics& statistics() const { return statistics_; }
  double update_operations() const;

private:
  struct Factors;
  struct Entry {
    int position;    ///< in the pattern
    int row, column; ///< places among c
  };

  bool analyse(const Pattern& pattern, const std::vector<int>& watched);
  void locate(const Pattern& pattern);
  void form_corner();
  int border() const { return static_cast<int>(border_.size()); }

  std::unique_ptr<Factors> factors_;
  std::vector<int> wanted_;     ///< what watch() was told
  std::vector<int> border_;     ///< c of the factors
  std::vector<int> dissection_; ///< METIS' ordering of all unknowns
  double best_ = 0;             ///< operations with it, on the pattern that it was made for
  std::vector<int> order_;      ///< unknown at each place of L
  bool analysed_ = false;
  std::vector<double> values_; ///< K⁰ + D
  std::vector<Entry> entries_;
  MatrixX corner_, constant_; ///< L_cc; L_cc L_ccᵀ − K⁰_cc − D
  MatrixX block_;             ///< the factors of S
  std::vector<int> pivots_;
  VectorX right_, part_;
  SolverStatistics statistics_;
};

} // namespace signorini::solve
