#pragma once
// A symmetric matrix of small blocks, such as the stiffness of a body by pairs of control points.

#include "solve/pattern.hpp"

#include <span>
#include <vector>

namespace signorini::solve {

/// A symmetric matrix K of D×D blocks, one for each pair of coupled nodes. Only the upper blocks are stored, those of
/// the diagonal halved: K = U + Uᵀ.
template <int D> class SymmetricBlocks {
public:
  /// Zero, with blocks for all pairs of nodes of a group.
  SymmetricBlocks(int nodes, const std::vector<std::vector<int>>& groups);

  /// Adds a symmetric matrix of n different nodes of one group; `blocks`: for each pair of components i ≤ j in the
  /// order (0,0), (0,1), …, (1,1), … an n×n matrix of the entries (D A + i, D B + j), A slowest.
  void add(std::span<const int> nodes, const double* blocks);
  /// y ← y + K x, with D values per node, in an order that depends on the pattern alone.
  void multiply(const double* x, double* y) const;
  /// Calls visit(row, column, count, values) for all entries of U in pieces of a row: `count` consecutive columns.
  template <class Visit> void visit_upper(const Visit& visit) const {
    for (int node = 0; node < nodes(); ++node)
      for (int i = 0; i < D; ++i) {
        const double* values = row(node, i);
        for (const Run& run : runs_of(node)) {
          visit(D * node + i, D * run.node, D * run.count, values);
          values += D * run.count;
        }
      }
  }
  /// Bytes of the matrix.
  double memory() const;

private:
  /// Nodes with consecutive numbers.
  struct Run {
    int node, count;
  };
  int nodes() const { return std::ssize(starts_) - 1; }
  std::span<const Run> runs_of(int node) const;
  /// Number of blocks in a node's rows.
  int width(int node) const;
  const double* row(int node, int component) const;

  std::vector<int> starts_;     ///< of each node's blocks
  std::vector<int> columns_;    ///< the second node of each block, from the first node on, increasing
  std::vector<int> first_runs_; ///< of each node
  std::vector<Run> runs_;       ///< the same columns
  std::vector<double> values_;  ///< of U, row by row
};

} // namespace signorini::solve
