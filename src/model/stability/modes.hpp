#pragma once
// Free vibration modes and stability of the accepted state.

#include "model/steps/model.hpp"

#include <complex>

namespace signorini::model {

/// A mode φ with κ of K φ = κ M φ: motions φ e^(st) with s² = −κ about the state.
struct Mode {
  std::complex<double> value;
  VectorX shape; ///< displacements by unknown, of multipliers 0; the longest of a control point is 1
  Message rigid; ///< which rigid motion without stiffness it is, κ = 0 up to rounding error; without a code if none
};

struct Modes {
  std::vector<Mode> list; ///< by the real part of κ, increasing
  bool symmetric;         ///< the tangent is
  /// No mode below the last one is missing, by the number of negative eigenvalues of K − σM; nothing: undecided.
  std::optional<bool> complete;
  /// No motion without inertia of its own grows: all κ > 0 but those of rigid motions; of an unsymmetric K those of its
  /// symmetric part (R. Hill, J. Mech. Phys. Solids 6, 1958). False if a motion grows; nothing: undecided.
  std::optional<bool> stable;
  std::vector<Message> warnings;
};

/// The `count` modes with the lowest κ [theory 10.9]. K is the tangent of the accepted state, in which touching points
/// count as closed and points with friction stick. The model must be settled, and does not change. Throws Error if a
/// step is pending, if nothing can move, and if an obstacle, which has no mass, is unstable by itself.
template <int D> Modes free_modes(Model<D>& model, int count);

} // namespace signorini::model
