#pragma once
// Cholesky's factorisation of the symmetric part of a tangent, as a stand-in for the tangent itself.

#include "solve/linear.hpp"

namespace signorini::solve {

/// L Lᵀ = P (K + Kᵀ)/2 Pᵀ on supernodes, ordered by nested dissection (METIS).
class SymmetricPart {
public:
  SymmetricPart();
  ~SymmetricPart();

  /// `transposed` is Kᵀ, both in the order of the pattern. Returns false when the symmetric part is not positive
  /// definite to working precision. The ordering of an earlier pattern is kept as long as it serves.
  bool factor(const Pattern& pattern, const double* values, const std::vector<double>& transposed);
  /// The next factor() brings a new pattern with the same unknowns.
  void forget_pattern() { analysed_ = false; }
  /// Overwrites b by the symmetric part's inverse times b. Call after a successful factor().
  bool solve(double* b);
  const SolverStatistics& statistics() const { return statistics_; }

private:
  struct Factors;
  void analyse(const Pattern& pattern);

  std::unique_ptr<Factors> factors_;
  std::vector<int> order_;
  double best_ = 0; ///< operations with METIS' last ordering, on the pattern that it was made for
  bool analysed_ = false;
  std::vector<double> values_;
  SolverStatistics statistics_;
};

} // namespace signorini::solve
