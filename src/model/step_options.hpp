#pragma once
// How a step is solved: Newton's tests, where it starts, what it does about changing contacts.

#include "solve/linear.hpp"
#include "solve/newton.hpp"

namespace signorini::model {

/// The first guess of a step at new targets.
enum class Predictor {
  tangent,  ///< the accepted state; the first solve takes prescribed displacements along, by its tangent
  constant, ///< the accepted state, prescribed displacements imposed
  linear ///< goes on as the last step did, prescribed displacements imposed, where the last two went alike and the path
         ///< goes straight on; elsewhere as `tangent`
};

/// What Newton's iteration does about points whose state (open, stick, slip) keeps changing.
struct ActiveSetOptions {
  /// ε_acts: the points that touch are those of the accepted state until |f·Δu| has fallen below this part of its first
  /// value (thesis 4.5.2); 0: never held.
  double freeze = 0;
  /// A point whose state has changed more often than this in a step is held until the others have converged, then
  /// freed; 0: never held.
  int changes = 0;
};

/// Augmented Lagrangian contact: pressures are augmented (Uzawa) until penetrations are small.
struct AugmentationOptions {
  double penetration = 0; ///< largest that may remain, as a part of the bodies' size; 0: plain penalty
  int loops = 100;        ///< most augmentations in a step
};

struct StepOptions {
  solve::NewtonOptions newton = {};
  solve::LinearKind linear = solve::LinearKind::automatic;
  Predictor predictor = Predictor::tangent;
  ActiveSetOptions active_set = {};
  AugmentationOptions augmented = {};
  bool damping = false; ///< of bodies that only contact holds, see damping.hpp
  /// Moves damped by pseudo-transient continuation (solve/pseudo_time.hpp), with up to 40 times newton.iterations; no
  /// line search next to it.
  bool pseudo_transient = false;
};

} // namespace signorini::model
