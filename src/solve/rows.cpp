#include "solve/rows.hpp"

#include "base/index.hpp"
#include "base/parallel.hpp"

namespace signorini::solve {

RowMatrix::RowMatrix(const Pattern& pattern) : pattern_(pattern), symmetry_(pattern) {}

void RowMatrix::set(const double* values) {
  symmetry_.transpose(values, values_);
}

std::vector<double> RowMatrix::columns() const {
  std::vector<double> values;
  symmetry_.transpose(values_.data(), values);
  return values;
}

void RowMatrix::multiply(int first, int last, const double* x, double* y) const {
  const int *starts = pattern_.starts.data(), *columns = pattern_.rows.data();
  for (int i = first; i < last; ++i) {
    // Four partial sums, so that additions do not wait for each other
    double sums[4] = {};
    int k = starts[i];
    for (const int end = starts[i + 1] - 3; k < end; k += 4)
      for (int lane = 0; lane < 4; ++lane) sums[lane] += values_[at(k + lane)] * x[columns[k + lane]];
    for (; k < starts[i + 1]; ++k) sums[0] += values_[at(k)] * x[columns[k]];
    y[i] = (sums[0] + sums[1]) + (sums[2] + sums[3]);
  }
}

void RowMatrix::multiply(const double* x, double* y) const {
  const int shares = worker_threads(), size = pattern_.size;
  const auto border = [&](int share) { return static_cast<int>(static_cast<long long>(size) * share / shares); };
  parallel(shares, [&](int share) { multiply(border(share), border(share + 1), x, y); });
}

} // namespace signorini::solve
