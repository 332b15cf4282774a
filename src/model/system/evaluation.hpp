#pragma once
// What one evaluation of residual and tangent reads and writes: states and the tangent, a sparse matrix.

#include "contact/gauss/formulation.hpp"
#include "model/system/state.hpp"
#include "model/system/unknowns.hpp"
#include "solve/pattern.hpp"

#include <limits>
#include <optional>

namespace signorini::model {

/// The tangent of the unknowns.
struct SparseTangent {
  solve::Pattern pattern = {};
  int version = 0;                   ///< incremented whenever the pattern changes
  std::vector<double> values = {};   ///< in the order of the pattern, followed by scratch entries of BulkAssembly
  std::vector<int> on_diagonal = {}; ///< by unknown: position in `values`
  double diagonal_norm = 0;          ///< 2-norm of the diagonal of the last evaluation; 0 before the first
  /// Entries that may differ from the constant tangent of linear bodies; nothing: any.
  std::optional<std::vector<int>> changed = {};

  void set_pattern(solve::Pattern wanted, int scratch_entries);
  VectorX diagonal() const;
  void add_diagonal(const VectorX& shift);
  void find_diagonal_norm();
};

/// Positions in the pattern of the entries of parts, part by part, column by column; −1 without unknown. The pattern
/// contains all entries of a part.
template <int D, class Parts>
std::vector<int> positions_of(const Parts& parts, const Unknowns<D>& unknowns, const solve::Pattern& pattern) {
  std::vector<int> positions;
  for (const auto& part : parts)
    for (const int column : part.dofs)
      for (const int row : part.dofs) {
        const int i = unknowns.unknown(row), j = unknowns.unknown(column);
        positions.push_back(i < 0 || j < 0 ? -1 : pattern.find(i, j));
      }
  return positions;
}

/// Allocated bytes of a list.
template <class T> double bytes_of(const std::vector<T>& list) {
  return static_cast<double>(list.capacity() * sizeof(T));
}

/// A trial state and the accepted state.
template <int D> struct States {
  State<D>& present;
  const State<D>& accepted;
  const std::vector<contact::Controls>& controls; ///< by contact
  const VectorX& loads;                           ///< targets at which the loads act
  const VectorX* before = nullptr; ///< displacement before Newton's last correction, see solid::internal_force(); null:
                                   ///< no correction follows
};

/// Duration of the step.
template <int D> double duration(const States<D>& states) {
  if (states.present.relaxed) return std::numeric_limits<double>::infinity();
  return states.present.time - states.accepted.time;
}

template <int D> struct Evaluation {
  const States<D>& states;
  const VectorX* direction; ///< null: `product` is not computed
  bool tangent;             ///< the tangent is computed
  SparseTangent& matrix;
  VectorX& product; ///< full tangent times `direction`, by degree of freedom
};

} // namespace signorini::model
