#include "solve/symmetric_blocks.hpp"

#include "base/eigen.hpp"

#include <algorithm>

namespace signorini::solve {

template <int D>
SymmetricBlocks<D>::SymmetricBlocks(int nodes, const std::vector<std::vector<int>>& groups)
    : starts_{0}, first_runs_{0} {
  const Pattern pattern = couple(nodes, groups);
  columns_.reserve((pattern.rows.size() + nodes) / 2);
  for (int node = 0; node < nodes; ++node) {
    for (int k = pattern.starts[node]; k < pattern.starts[node + 1]; ++k) {
      const int other = pattern.rows[k];
      if (other < node) continue;
      columns_.push_back(other);
      if (other > node && runs_.back().node + runs_.back().count == other)
        ++runs_.back().count;
      else
        runs_.push_back({other, 1});
    }
    starts_.push_back(static_cast<int>(columns_.size()));
    first_runs_.push_back(static_cast<int>(runs_.size()));
  }
  values_.assign(D * D * columns_.size(), 0.0);
}

template <int D> std::span<const typename SymmetricBlocks<D>::Run> SymmetricBlocks<D>::runs_of(int node) const {
  return {runs_.data() + first_runs_[node], runs_.data() + first_runs_[node + 1]};
}

template <int D> int SymmetricBlocks<D>::width(int node) const {
  return starts_[node + 1] - starts_[node];
}

template <int D> const double* SymmetricBlocks<D>::row(int node, int component) const {
  return values_.data() + D * (D * std::ptrdiff_t{starts_[node]} + component * width(node));
}

template <int D> void SymmetricBlocks<D>::add(std::span<const int> nodes, const double* blocks) {
  const std::size_t n = nodes.size();
  const double* block[D][D];
  for (int i = 0; i < D; ++i)
    for (int j = i; j < D; ++j, blocks += n * n) block[i][j] = blocks;
  for (std::size_t a = 0; a < n; ++a) {
    const auto from = columns_.begin() + starts_[nodes[a]], to = columns_.begin() + starts_[nodes[a] + 1];
    double* const rows = values_.data() + D * D * std::ptrdiff_t{starts_[nodes[a]]};
    const std::size_t stride = D * width(nodes[a]);
    int before = -2;
    auto found = from;
    for (std::size_t b = 0; b < n; ++b) {
      if (nodes[b] < nodes[a]) continue;
      found = nodes[b] == before + 1 ? found + 1 : std::lower_bound(from, to, nodes[b]);
      before = nodes[b];
      const double part = a == b ? 0.5 : 1;
      double* const values = rows + D * (found - from);
      for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j)
          values[i * stride + j] += part * (i <= j ? block[i][j][a * n + b] : block[j][i][b * n + a]);
    }
  }
}

template <int D> void SymmetricBlocks<D>::multiply(const double* x, double* y) const {
  using Pair = Eigen::Array2d;
  using Read = Eigen::Map<const Pair>;
  for (int node = 0; node < nodes(); ++node) {
    double own[D];
    const double* rows[D];
    Pair sums[D]; // of (U x)_i
    for (int i = 0; i < D; ++i) {
      own[i] = x[D * node + i];
      rows[i] = row(node, i);
      sums[i].setZero();
    }
    for (const auto& [first, count] : runs_of(node)) {
      const double* const other = x + D * first;
      double* const to = y + D * first;
      int k = 0;
      for (; k + 2 <= D * count; k += 2) {
        const Pair factors = Read(other + k);
        Pair result = Read(to + k);
        for (int i = 0; i < D; ++i) {
          const Pair values = Read(rows[i] + k);
          sums[i] += values * factors;
          result += values * own[i];
        }
        Eigen::Map<Pair>(to + k) = result;
      }
      for (; k < D * count; ++k)
        for (int i = 0; i < D; ++i) {
          sums[i](0) += rows[i][k] * other[k];
          to[k] += rows[i][k] * own[i];
        }
      for (int i = 0; i < D; ++i) rows[i] += D * count;
    }
    for (int i = 0; i < D; ++i) y[D * node + i] += sums[i].sum();
  }
}

template <int D> double SymmetricBlocks<D>::memory() const {
  const auto bytes = [](const auto& list) { return static_cast<double>(list.capacity() * sizeof(list[0])); };
  return bytes(starts_) + bytes(columns_) + bytes(first_runs_) + bytes(runs_) + bytes(values_);
}

template class SymmetricBlocks<2>;
template class SymmetricBlocks<3>;

} // namespace signorini::solve
