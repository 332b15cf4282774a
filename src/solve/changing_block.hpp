#pragma once
// A dense symmetric matrix, some rows and columns of which change from one solution to the next.

#include "base/eigen.hpp"
#include "solve/values.hpp"

#include <vector>

namespace signorini::solve {

/// Solves (S + C) x = b with a constant S. Of the unknowns, a are those that C may touch; with the others n in front,
///     S_nn = L Lᵀ,   W = S_an L⁻ᵀ,   T = S_aa − W Wᵀ
/// is done once for many C, and only T + C is factored for each.
class ChangingBlock {
public:
  /// An entry of C.
  struct Change {
    int row, column;
    double value;
  };

  ChangingBlock() = default;
  /// S, symmetric, of which the lower triangle is read; condense() comes next.
  explicit ChangingBlock(MatrixX constant);

  /// Whether the last condense() lets C touch all unknowns that are marked.
  bool covers(const std::vector<char>& touched) const;
  /// Lets C touch the marked unknowns. Where S is singular with these held, n is empty.
  void condense(const std::vector<char>& touched);
  /// Takes over C and adds the pivots to `pivots`; these tell whether S + C is regular.
  void factor(const std::vector<Change>& changes, PivotRange& pivots);
  /// Overwrites b by (S + C)⁻¹ b.
  void solve(double* b);

private:
  int size() const { return static_cast<int>(constant_.rows()); }
  bool eliminate();

  MatrixX constant_; ///< S
  std::vector<char> allowed_;
  std::vector<int> order_, place_; ///< n before a, and back
  int untouched_ = 0;              ///< how many n are
  PivotRange untouched_pivots_;
  MatrixX lower_;   ///< L, and W below it
  MatrixX reduced_; ///< T
  MatrixX factors_; ///< of T + C
  std::vector<int> pivots_;
  VectorX work_;
};

} // namespace signorini::solve
