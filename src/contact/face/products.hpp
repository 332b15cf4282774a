#pragma once
// Tangent of many contact points of one block as products of tall matrices.

#include <vector>

namespace signorini::contact {

/// Sums rank-one terms of contact points into a dense block,
///   K_(a,i),c += left_a ∂T_i,c               for all row nodes a (−R_A of the slave, R̄_A of the master),
///   K_(m,i),c += (T_i R̄_m,α) ∂ξ̄^α_c          for the master's nodes m,
/// as matrix products over all points: most of the work of contact in 3D.
class Products {
public:
  /// Starts a block with 3 rows per row node (the master's nodes, if it has rows, are the last ones) and `columns`
  /// columns.
  void start(int nodes, int master_nodes, int columns, double* block);
  /// Memory for the factors of another point: `nodes` values left; 3 × `columns` values ∂T_i; 2 × 3 × `master_nodes`
  /// values T_i R̄_m,α, α slowest, i fastest; 2 × `columns` values ∂ξ̄^α. The arrays with columns have room for one more
  /// value at their end.
  struct Factors {
    double *left, *traction, *rates, *shift;
  };
  Factors add();
  /// Adds the collected products to the block.
  void finish();

private:
  int nodes_ = 0, master_nodes_ = 0, columns_ = 0, points_ = 0;
  double* block_ = nullptr;
  std::vector<double> left_, traction_, rates_, shift_;
};

} // namespace signorini::contact
