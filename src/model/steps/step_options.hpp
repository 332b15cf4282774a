#pragma once
// Options of a step: Newton's method, predictor, active set.

#include "solve/linear.hpp"
#include "solve/newton.hpp"

#include <functional>

namespace signorini::model {

/// First guess of a step at new targets.
enum class Predictor {
  tangent,  ///< the accepted state; the first solution includes the prescribed displacements, by its tangent
  constant, ///< the accepted state with prescribed displacements imposed
  linear,   ///< extrapolation of the last step with prescribed displacements imposed, if the path is straight and the
            ///< last two steps have similar rates; otherwise as `tangent`
  quadratic ///< extrapolation of the last two steps, where the last step was close to its own; otherwise as `linear`,
            ///< but as `tangent` where the path turns back
};

/// Treatment of points whose state (open, stick, slip) changes repeatedly (set cycling).
struct ActiveSetOptions {
  /// ε_acts: the active set of the accepted state is frozen until |f·Δu| is below this fraction of its first value
  /// (thesis 4.5.2); 0: no freeze.
  double freeze = 0;
  /// A point whose state has changed more often than this in a step is fixed until the others have converged, then
  /// freed; 0: points are not fixed.
  int changes = 0;
};

struct StepOptions {
  solve::NewtonOptions newton = {};
  solve::LinearKind linear = solve::LinearKind::automatic;
  solve::MumpsOptions mumps = {}; ///< of linear = `mumps`
  Predictor predictor = Predictor::tangent;
  ActiveSetOptions active_set = {};
  bool damping = false; ///< of unconstrained bodies, see damping.hpp
  /// Pseudo-transient continuation (solve/pseudo_time.hpp), with up to 40 times newton.iterations moves; not combined
  /// with line search.
  bool pseudo_transient = false;
};

/// Called after each iteration of a step, to report it.
using AfterIteration = std::function<void()>;

} // namespace signorini::model
