#pragma once
// Puts the elements' and contacts' contributions into one residual and one tangent of fixed sparse pattern.

#include "contact/pair.hpp"
#include "model/unknowns.hpp"
#include "solid/internal.hpp"
#include "solve/pattern.hpp"

#include <optional>
#include <unordered_map>

namespace signorini::model {

/// Which element of which body turned inside out.
struct BodyInversion {
  int body;
  solid::Inversion inversion;
};

/// Seconds spent, summed over a model's life.
struct Timings {
  double bulk = 0, contact = 0, linear = 0;
};

template <int D> class Assembly {
public:
  Assembly(const Scene<D>& scene, const Unknowns<D>& unknowns);

  /// Residual f_int + f_c of all degrees of freedom and tangent of the unknowns at `displacement` (all degrees of
  /// freedom). The tangent times `increment` (all degrees of freedom, may be null) is added to the residual: how
  /// prescribed displacements enter the first iteration. Returns where an element is inverted; the results are then
  /// meaningless.
  ///
  /// Without `tangent` the residual alone is computed, and values() no longer belong to it; there must be no increment.
  std::optional<BodyInversion> assemble(std::vector<contact::Pair<D>>& pairs, const VectorX& displacement,
                                        const VectorX* increment, bool tangent, Timings& timings);

  const VectorX& residual() const { return residual_; }
  /// Values of the tangent in the order of pattern().
  const std::vector<double>& values() const { return values_; }
  const solve::Pattern& pattern() const { return pattern_; }
  /// Grows by one whenever the pattern is a new one.
  int pattern_version() const { return version_; }
  /// Largest diagonal entry of the last tangent; 0 before the first.
  double largest_diagonal() const { return largest_diagonal_; }

private:
  using Nodes = std::vector<int>;
  void build_bulk();
  /// Degrees of freedom of the nodes of face elements, D per node.
  void append_dofs(const FaceReference& face, const contact::Surface<D>& surface, int element, Nodes& dofs) const;
  Nodes columns(const Contact& contact, const contact::Pair<D>& pair, const contact::Group& group) const;
  void cover(const std::vector<contact::Pair<D>>& pairs);
  bool locate(const std::vector<contact::Pair<D>>& pairs);
  void add_bulk_increment(int body, int e, const solid::ElementArrays<D>& arrays, const VectorX& increment);
  void add_contacts(const std::vector<contact::Pair<D>>& pairs, const VectorX* increment, bool tangent);
  void find_largest_diagonal();

  /// Where a contact group's entries go; found once per pattern.
  struct Placement {
    Nodes rows, columns;        ///< degrees of freedom
    std::vector<int> positions; ///< in values_, row by row
  };

  const Scene<D>& scene_;
  const Unknowns<D>& unknowns_;
  solve::Pattern bulk_pattern_, pattern_;
  std::vector<int> bulk_positions_, positions_;          ///< per element and block entry: in bulk_pattern_, in pattern_
  std::vector<std::vector<std::size_t>> first_position_; ///< [body][element]
  std::vector<std::vector<char>> holds_;                 ///< [body][element]: has prescribed degrees of freedom
  std::vector<std::unordered_map<std::uint64_t, Placement>> placements_; ///< per contact, by the group's elements
  std::vector<solid::ElementArrays<D>> arrays_;                          ///< per body
  std::vector<int> diagonal_;
  std::vector<double> values_; ///< one more than entries: what belongs to prescribed degrees of freedom lands there
  VectorX residual_;
  double largest_diagonal_ = 0;
  int version_ = 0;
};

} // namespace signorini::model
