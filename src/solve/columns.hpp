#pragma once
// A sparse matrix stored by columns, for products on all worker threads.

#include "base/eigen.hpp"
#include "solve/pattern.hpp"

#include <vector>

namespace signorini::solve {

/// Products with a matrix in which neighboring columns, such as those of a control point's components, often have the
/// same rows, and rows often have consecutive numbers. Results are bitwise identical for any number of threads.
class ColumnMatrix {
public:
  explicit ColumnMatrix(const Pattern& pattern);
  /// Copies values in the order of the pattern.
  void set(const double* values);
  const std::vector<double>& values() const { return values_; }
  /// y ← K x.
  void multiply(const double* x, double* y);

private:
  /// Consecutive rows.
  struct Run {
    int row, length;
  };
  /// Neighboring columns with the same rows.
  struct Group {
    int column, width;
    int position, height; ///< of the first entry; entries per column
    int first_run;
  };
  /// Groups whose product is one task, and the rows that it adds to.
  struct Share {
    int first_group, last_group;
    int first_row, last_row;
  };
  void build_groups(const Pattern& pattern);
  void build_shares(const Pattern& pattern);
  void add(const Share& share, const double* x, double* y) const;

  std::vector<Run> runs_;
  std::vector<Group> groups_; ///< followed by an empty one
  std::vector<Share> shares_;
  std::vector<double> values_;
  MatrixX sums_; ///< of the shares but the first
};

} // namespace signorini::solve
