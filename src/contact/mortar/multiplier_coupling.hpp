#pragma once
// Coupling of all unknowns below multipliers that are eliminated [theory 8.1].

#include "contact/mortar/mortar_law.hpp"
#include "contact/mortar/multiplier_rows.hpp"

#include <utility>

namespace signorini::contact {

/// A multiplier in an evaluation.
template <int D> struct WeightedMultiplier {
  MultiplierSums<D> sums;
  double fraction = 0;          ///< s*_A of a forecast, otherwise 0
  MultiplierTangent<D> tangent; ///< if it is eliminated
};

/// Working space of a thread.
struct CouplingSpace {
  std::vector<std::pair<const Strip*, std::size_t>> strips; ///< of a group, with an offset into `numbers`
  std::vector<int> numbers;                                 ///< in the block, of the strips' nodes
  MatrixX rows, left, right;
  VectorX shares;
};

template <int D> class MultiplierCoupling {
public:
  /// Keeps references to the first two.
  MultiplierCoupling(const Faces<D>& faces, const MultiplierFunctions<D>& functions, Pass pass, std::size_t threads)
      : faces_(faces), functions_(functions), pass_(pass), strips_(faces.slave.elements()), spaces_(threads) {}

  /// Keeps references to the strips of all parts.
  void collect(const std::vector<MultiplierRows<D>>& parts);
  /// Fills the block of a group: Σ ∂f/∂z_A δz_A + ∂f/∂t_A δt_A over its members that are not open, with rows for the
  /// slave only in a half pass. Threads with different numbers may fill blocks at the same time.
  void fill(const std::vector<WeightedMultiplier<D>>& multipliers, bool frictional, int thread, Block& block);

private:
  const Faces<D>& faces_;
  const MultiplierFunctions<D>& functions_;
  Pass pass_;
  std::vector<std::vector<const Strip*>> strips_; ///< per slave element
  std::vector<CouplingSpace> spaces_;
};

} // namespace signorini::contact
