#pragma once
// A sparse matrix stored by rows, for products on all worker threads.

#include "solve/values.hpp"

namespace signorini::solve {

/// Products with a matrix of structurally symmetric pattern: row i has its entries where column i has them. Results are
/// bitwise identical for any number of threads.
class RowMatrix {
public:
  explicit RowMatrix(const Pattern& pattern);
  /// Copies values in the order of the pattern, column by column.
  void set(const double* values);
  /// y ← K x.
  void multiply(const double* x, double* y) const;
  /// Values of the rows: those of row i at the positions of column i in the pattern.
  const std::vector<double>& values() const { return values_; }
  /// The values set, in the order of the pattern.
  std::vector<double> columns() const;

private:
  void multiply(int first, int last, const double* x, double* y) const;

  Pattern pattern_;
  Symmetry symmetry_;
  std::vector<double> values_;
};

} // namespace signorini::solve
