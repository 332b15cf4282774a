#include "solve/columns.hpp"

#include "os/parallel.hpp"
#include "solve/constants.hpp"

#include <algorithm>

namespace signorini::solve {

namespace {

constexpr int widest_group = 3;

/// y ← y + A x for columns of A with the rows of these runs; `height` is the distance of its columns in memory.
template <int Width, class Run>
void add_columns(const Run* run, const Run* end, const double* a, std::ptrdiff_t height, const double* x, double* y) {
  double factors[Width];
  std::copy_n(x, Width, factors);
  for (; run < end; a += run->length, ++run) {
    double* __restrict const sum = y + run->row; // y is not part of A
    for (int i = 0, length = run->length; i < length; ++i)
      for (int c = 0; c < Width; ++c) sum[i] += a[i + c * height] * factors[c];
  }
}

} // namespace

ColumnMatrix::ColumnMatrix(const Pattern& pattern) {
  build_groups(pattern);
  build_shares(pattern);
  values_.resize(pattern.rows.size());
  sums_.resize(pattern.size, static_cast<int>(shares_.size()) - 1);
}

void ColumnMatrix::build_groups(const Pattern& pattern) {
  const auto rows = [&](int column) { return pattern.rows.begin() + pattern.starts[column]; };
  const auto same_rows = [&](int left, int right) {
    return std::equal(rows(left), rows(left + 1), rows(right), rows(right + 1));
  };
  for (int column = 0; column < pattern.size;) {
    Group group{column, 1, pattern.starts[column], 0, static_cast<int>(runs_.size())};
    group.height = pattern.starts[column + 1] - group.position;
    while (group.width < widest_group && column + group.width < pattern.size && same_rows(column, column + group.width))
      ++group.width;
    for (auto row = rows(column); row != rows(column + 1); ++row)
      if (static_cast<int>(runs_.size()) > group.first_run && runs_.back().row + runs_.back().length == *row)
        ++runs_.back().length;
      else
        runs_.push_back({*row, 1});
    groups_.push_back(group);
    column += group.width;
  }
  groups_.push_back({pattern.size, 0, pattern.entries(), 0, static_cast<int>(runs_.size())});
}

void ColumnMatrix::build_shares(const Pattern& pattern) {
  const int count = std::clamp(pattern.entries() / entries_per_share, 1, most_shares), groups = std::ssize(groups_) - 1;
  for (int share = 0, group = 0; share < count; ++share) {
    Share next{group, group, pattern.size, 0};
    const auto end = static_cast<long long>(pattern.entries()) * (share + 1) / count;
    for (; group < groups && groups_[group].position < end; ++group)
      for (int k = groups_[group].first_run; k < groups_[group + 1].first_run; ++k) {
        next.first_row = std::min(next.first_row, runs_[k].row);
        next.last_row = std::max(next.last_row, runs_[k].row + runs_[k].length);
      }
    next.last_group = group;
    next.first_row = std::min(next.first_row, next.last_row);
    shares_.push_back(next);
  }
}

void ColumnMatrix::set(const double* values) {
  std::copy_n(values, values_.size(), values_.begin());
}

void ColumnMatrix::add(const Share& share, const double* x, double* y) const {
  for (int g = share.first_group; g < share.last_group; ++g) {
    const Group& group = groups_[g];
    const Run *run = runs_.data() + group.first_run, *end = runs_.data() + groups_[g + 1].first_run;
    const double *a = values_.data() + group.position, *part = x + group.column;
    switch (group.width) {
    case 1:
      add_columns<1>(run, end, a, group.height, part, y);
      break;
    case 2:
      add_columns<2>(run, end, a, group.height, part, y);
      break;
    default:
      add_columns<3>(run, end, a, group.height, part, y);
    }
  }
}

void ColumnMatrix::multiply(const double* x, double* y) {
  std::fill_n(y, sums_.rows(), 0.0);
  parallel(std::ssize(shares_), [&](int k) {
    const Share& share = shares_[k];
    double* const sum = k == 0 ? y : sums_.col(k - 1).data();
    if (k > 0) std::fill(sum + share.first_row, sum + share.last_row, 0.0);
    add(share, x, sum);
  });
  for (std::size_t k = 1; k < shares_.size(); ++k)
    for (int i = shares_[k].first_row; i < shares_[k].last_row; ++i) y[i] += sums_(i, static_cast<int>(k) - 1);
}

} // namespace signorini::solve
