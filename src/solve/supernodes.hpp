#pragma once
// Triangular solves with the supernodes of a Cholesky factor, in single or double precision, on all worker threads.

#include "base/eigen.hpp"
#include "solve/cholmod.hpp"

#include <vector>

namespace signorini::solve {

/// The columns of a lower triangular factor L that belong to the interior, stored by supernodes (groups of columns with
/// the same rows, as dense panels). Subtrees of the elimination tree are solved in parallel, and large panels above
/// them by shares; the partition depends on L alone, so results are bitwise identical for any number of threads.
template <class Real> class Supernodes {
public:
  using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

  /// Sets the structure to that of a supernodal factor, of which the first `interior` columns are used.
  void analyze(const cholmod_factor& factor, int interior);
  /// With values of the factor, x_i ← L_ii⁻¹ x_i and x_c ← x_c − L_ci x_i for the remaining rows c.
  void solve_lower(const Real* values, Vector& x);
  /// x_i ← L_ii⁻ᵀ (x_i − L_ciᵀ x_c).
  void solve_upper(const Real* values, Vector& x);

private:
  struct Supernode {
    int column, columns; ///< the first column, their number
    int height;          ///< rows of the panel, whose first ones are the supernode's columns
    std::ptrdiff_t values;
    std::ptrdiff_t rows; ///< place of its rows below those columns, in rows_
  };
  /// Supernodes of which every one is below the last, in increasing order.
  struct Subtree {
    std::vector<int> supernodes;
    int end; ///< rows from here on lie above the subtree
    Vector above = {}, work = {};
  };
  void build_subtrees(int size);
  void solve_lower(const Real* values, const Supernode& supernode, Vector& x, int end, bool shared, Vector& above,
                   Vector& work) const;
  void solve_upper(const Real* values, const Supernode& supernode, Vector& x, bool shared, Vector& work) const;

  std::vector<Supernode> supernodes_;
  std::vector<int> rows_;
  std::vector<Subtree> subtrees_;
  std::vector<int> top_; ///< supernodes above all subtrees
  Vector work_;
};

} // namespace signorini::solve
