#include "model/stability/displacement_stiffness.hpp"

#include "model/constants.hpp"
#include "solve/dense_factors.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::model {

namespace {

/// The entries of a tangent that couple a multiplier with unknowns of lower number: of its column, and of its row.
struct Couplings {
  struct Entry {
    int unknown;
    double value;
  };
  std::vector<Entry> column, row;
};

/// Consecutive multipliers that no entry of K_χχ couples with others, in either direction.
struct MultiplierGroup {
  std::vector<int> unknowns;    ///< on which they act, increasing
  MatrixX columns, inner, rows; ///< K_uχ, K_χχ − E, K_χu
};

class Elimination {
public:
  Elimination(const solve::Pattern& pattern, const std::vector<double>& values, int displacements,
              const std::vector<int>& sizes)
      : pattern_(pattern), values_(values), displacements_(displacements), sizes_(sizes) {
    couplings_.resize(pattern.size - displacements);
    for (int j = 0; j < displacements; ++j)
      each_entry(j, [&](int i, double value) {
        if (i >= displacements_) couplings_[i - displacements_].row.push_back({j, value});
      });
    for (int j = displacements; j < pattern.size; ++j)
      each_entry(j, [&](int i, double value) {
        if (i < displacements_) couplings_[j - displacements_].column.push_back({i, value});
      });
    for (int first = displacements; first < pattern.size;) first = add_group(first);
  }

  Stiffness eliminated() const {
    solve::Pattern of_displacements{displacements_, {0}, {}};
    std::vector<double> values;
    of_displacements.rows.reserve(pattern_.rows.size());
    values.reserve(pattern_.rows.size());
    for (int j = 0; j < displacements_; ++j) {
      for (int k = pattern_.starts[j]; k < pattern_.starts[j + 1]; ++k)
        if (const int i = pattern_.rows[k]; i < displacements_ && acts(k, i, j)) {
          of_displacements.rows.push_back(i);
          values.push_back(values_[k]);
        }
      of_displacements.starts.push_back(of_displacements.entries());
    }
    if (groups_.empty()) return {std::move(of_displacements), std::move(values)};
    std::vector<std::vector<int>> coupled;
    for (const MultiplierGroup& group : groups_) coupled.push_back(group.unknowns);
    std::vector<int> moved;
    Stiffness result{solve::extend(of_displacements, coupled, moved), {}};
    result.values.assign(result.pattern.entries(), 0.0);
    for (std::size_t k = 0; k < values.size(); ++k) result.values[moved[k]] = values[k];
    for (const MultiplierGroup& group : groups_) add(group, result);
    return result;
  }

private:
  /// True if entry k of row i and column j, or the transposed one, is not zero: the pattern stays symmetric.
  bool acts(int k, int i, int j) const { return i == j || values_[k] != 0 || values_[pattern_.find(j, i)] != 0; }

  template <class Visit> void each_entry(int column, const Visit& visit) const {
    for (int k = pattern_.starts[column]; k < pattern_.starts[column + 1]; ++k)
      if (values_[k] != 0) visit(pattern_.rows[k], values_[k]);
  }

  /// Adds the group that begins with a multiplier, if it constrains displacements; returns the first one after it.
  int add_group(int first) {
    const int lumped = sizes_.empty() ? 0 : sizes_[first - displacements_];
    int end = first + std::max(1, lumped);
    for (int j = first; j < end && lumped == 0; ++j)
      for (int k = pattern_.starts[j]; k < pattern_.starts[j + 1]; ++k)
        if (const int i = pattern_.rows[k]; i >= displacements_ && acts(k, i, j)) end = std::max(end, i + 1);
    MultiplierGroup group;
    bool constrains = false;
    for (int j = first; j < end; ++j) {
      const Couplings& own = couplings_[j - displacements_];
      constrains = constrains || !own.row.empty();
      for (const auto* list : {&own.column, &own.row})
        for (const auto& [unknown, value] : *list) group.unknowns.push_back(unknown);
    }
    if (!constrains) return end;
    std::sort(group.unknowns.begin(), group.unknowns.end());
    group.unknowns.erase(std::unique(group.unknowns.begin(), group.unknowns.end()), group.unknowns.end());
    fill(first, end, group);
    groups_.push_back(std::move(group));
    return end;
  }

  void fill(int first, int end, MultiplierGroup& group) const {
    const int size = end - first, width = std::ssize(group.unknowns);
    group.columns.setZero(width, size);
    group.inner.setZero(size, size);
    group.rows.setZero(size, width);
    const auto place = [&](int unknown) {
      return std::lower_bound(group.unknowns.begin(), group.unknowns.end(), unknown) - group.unknowns.begin();
    };
    for (int j = 0; j < size; ++j) {
      const Couplings& own = couplings_[first + j - displacements_];
      double column = 0, row = 0, stiffest = 0;
      for (const auto& [unknown, value] : own.column) {
        group.columns(place(unknown), j) = value;
        column = std::max(column, std::abs(value));
      }
      for (const auto& [unknown, value] : own.row) {
        group.rows(j, place(unknown)) = value;
        row = std::max(row, std::abs(value));
        stiffest = std::max(stiffest, std::abs(values_[pattern_.find(unknown, unknown)]));
      }
      each_entry(first + j, [&](int i, double value) {
        // Of a lumped multiplier i is the same component of another one.
        if (i >= displacements_) group.inner(((i - first) % size + size) % size, j) += value;
      });
      if (stiffest > 0) group.inner(j, j) -= column * row / (constraint_stiffness * stiffest);
    }
  }

  /// Adds −K_uχ (K_χχ − E)⁻¹ K_χu.
  static void add(const MultiplierGroup& group, Stiffness& to) {
    MatrixX factors = group.inner;
    std::vector<int> exchanges;
    if (!solve::factor_dense<double>(factors, exchanges)) return;
    for (int j = 0; j < group.rows.cols(); ++j) {
      VectorX part = group.rows.col(j);
      solve::solve_dense<double>(factors, exchanges, part);
      const VectorX product = group.columns * part;
      // Both lists of rows increase.
      int k = to.pattern.starts[group.unknowns[j]];
      for (int i = 0; i < product.size(); ++i) {
        while (to.pattern.rows[k] < group.unknowns[i]) ++k;
        to.values[k] -= product(i);
      }
    }
  }

  const solve::Pattern& pattern_;
  const std::vector<double>& values_;
  int displacements_;
  const std::vector<int>& sizes_;
  std::vector<Couplings> couplings_;
  std::vector<MultiplierGroup> groups_;
};

} // namespace

Stiffness displacement_stiffness(const solve::Pattern& pattern, const std::vector<double>& values, int displacements,
                                 const std::vector<int>& sizes) {
  return Elimination(pattern, values, displacements, sizes).eliminated();
}

} // namespace signorini::model
