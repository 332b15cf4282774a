#pragma once
// Arc-length continuation of a model's path.

#include "model/steps/model.hpp"

namespace signorini::model {

struct ArcReport : solve::NewtonReport {
  double fraction; ///< λ of the path: 0 at the accepted state, 1 at the targets
};

/// Solves one arc-length increment: a state at distance `length` from the accepted one on the path towards the current
/// targets. The fraction λ of the path is an additional unknown and may decrease, so limit points in λ can be passed.
/// The constraint is t·(u − u₀) = length in the inner product of path_norm.hpp, t the unit tangent of the solution
/// curve at the accepted state, in the sense of the last accepted step (pseudo-arclength: E. Riks, J. Appl. Mech. 39,
/// 1972; H. B. Keller, 1977). Sets the targets to those reached. Calls `after` after each iteration, if given. Does not
/// accept. Throws Error if no target changes, or `length` is not positive.
template <int D>
ArcReport solve_arc(Model<D>& model, const StepOptions& options, double length, const AfterIteration& after = {});

/// Length of the last accepted step in the norm of path_norm.hpp, a scale for increments.
template <int D> double last_length(Model<D>& model);

} // namespace signorini::model
