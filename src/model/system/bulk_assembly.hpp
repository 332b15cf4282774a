#pragma once
// Internal force and tangent of the bodies.

#include "model/system/evaluation.hpp"
#include "model/system/partition.hpp"
#include "model/system/tie_terms.hpp"
#include "solid/internal.hpp"
#include "solve/symmetric_blocks.hpp"

namespace signorini::model {

/// An inverted element of a body.
struct BodyInversion {
  int body;
  solid::Inversion inversion;
};

/// If all bodies are linear elastic, forces are products with constant matrices, and no element is evaluated after
/// construction. Otherwise the elements of all bodies are, in parallel shares (partition.hpp). Entries of prescribed
/// degrees of freedom are added to scratch entries behind the tangent's, D for each share.
template <int D> class BulkAssembly {
public:
  BulkAssembly(const Scene<D>& scene, const Unknowns<D>& unknowns, const TieTerms& ties);

  /// Entries of the tangents of bodies and ties.
  const solve::Pattern& pattern() const { return pattern_; }
  /// The stiffness of all degrees of freedom of each body, if all are linear elastic; otherwise empty.
  const std::vector<solve::SymmetricBlocks<D>>& stiffness() const { return stiffness_; }
  int scratch_entries() const;
  /// Sets the positions in a tangent in which entry k of pattern(), or behind them scratch entry, is at moved[k].
  void locate(const std::vector<int>& moved);

  /// A share of a body, or a linear body.
  struct Task {
    std::size_t body, share;
    solid::ElementArrays<D> arrays;
    double seconds = 0;
    std::optional<BodyInversion> inverted = {};
  };
  /// Tasks of the evaluation since start().
  const std::vector<Task>& tasks() const { return tasks_; }
  void start();
  /// Adds the part of a task that may run in parallel to all other tasks.
  void add_head(std::size_t task, const Evaluation<D>& evaluation);
  /// Adds all other parts.
  void add_tails(const Evaluation<D>& evaluation);
  /// Energies of a body at a displacement and internal variables of all, see solid::account(), and of all.
  solid::Account account(int body, const VectorX& displacement, const std::vector<std::vector<double>>& internal) const;
  solid::Account account(const VectorX& displacement, const std::vector<std::vector<double>>& internal) const;
  /// Bytes of patterns, positions and matrices.
  double memory() const;

private:
  /// An element in the tangent.
  struct Element {
    bool supported;             ///< it has degrees of freedom of supports
    bool whole;                 ///< see whole_nodes()
    std::size_t first_position; ///< in positions_
  };
  struct KnownAccount {
    VectorX displacement;
    std::vector<double> internal;
    solid::Account account;
  };
  void find_positions(const std::vector<std::vector<int>>& groups);
  void add_elements(const std::vector<int>& elements, const Evaluation<D>& evaluation, Task& task);
  void add_element(int e, const Evaluation<D>& evaluation, Task& task);

  const Scene<D>& scene_;
  const Unknowns<D>& unknowns_;
  std::vector<solve::SymmetricBlocks<D>> stiffness_;
  std::vector<Partition> partitions_; ///< by body
  std::vector<Task> tasks_;
  solve::Pattern pattern_;
  std::vector<std::vector<Element>> elements_; ///< [body][element]
  std::vector<int> own_positions_, positions_; ///< see scatter(): in pattern(), in the tangent
  /// By nonlinear body: the last energies. At the end of a stage they are used twice.
  mutable std::vector<KnownAccount> accounts_;
};

} // namespace signorini::model
