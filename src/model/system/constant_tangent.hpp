#pragma once
// The part of the tangent that does not depend on displacements: of linear bodies, ties and springs.

#include "model/system/bulk_assembly.hpp"
#include "model/system/springs.hpp"

namespace signorini::model {

template <int D> class ConstantTangent {
public:
  ConstantTangent(const Unknowns<D>& unknowns, const TieTerms& ties, const Springs<D>& springs,
                  const BulkAssembly<D>& bulk)
      : unknowns_(unknowns), ties_(ties), springs_(springs), bulk_(bulk) {}

  /// Follows a new pattern, in which entry k of the bodies' pattern is at moved[k].
  void locate(const SparseTangent& tangent, std::vector<int> moved);
  /// Sets a tangent to its constant part.
  void copy_to(SparseTangent& tangent) const;
  /// The constant part by entry of the tangent if all bodies are linear elastic; otherwise empty.
  const std::vector<double>& values() const { return values_; }
  double memory() const;

private:
  void build(const SparseTangent& tangent);
  void add_ties_and_springs(const SparseTangent& tangent, double* values) const;

  const Unknowns<D>& unknowns_;
  const TieTerms& ties_;
  const Springs<D>& springs_;
  const BulkAssembly<D>& bulk_;
  std::vector<int> tie_positions_, spring_positions_; ///< in the tangent; −1 without unknown
  std::vector<double> values_;
  std::vector<int> positions_; ///< in values_, of the entries of the bodies' pattern
};

} // namespace signorini::model
