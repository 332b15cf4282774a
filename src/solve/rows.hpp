#pragma once
// A sparse matrix row by row, for products on all worker threads.

#include "solve/values.hpp"

namespace signorini::solve {

/// Products with a matrix of structurally symmetric pattern: row i has its entries where column i has them. The same
/// bits for any number of threads.
class RowMatrix {
public:
  explicit RowMatrix(const Pattern& pattern);
  /// Takes over values in the order of the pattern, column by column.
  void set(const double* values);
  /// y ← K x.
  void multiply(const double* x, double* y) const;
  /// Row i's values at the places where the pattern has column i's.
  const std::vector<double>& values() const { return values_; }
  /// The values that it has taken over, in the order of the pattern.
  std::vector<double> columns() const;

private:
  void multiply(int first, int last, const double* x, double* y) const;

  Pattern pattern_;
  Symmetry symmetry_;
  std::vector<double> values_;
};

} // namespace signorini::solve
