#pragma once
// How a model follows its path by arc length.

#include "model/model.hpp"

namespace signorini::model {

/// Solves for a state at a given distance from the accepted one along the path that leads to the present targets, the
/// fraction λ of the way being an unknown of its own: it may turn back, so limit points in λ can be passed. The
/// constraint is t·(u − u₀) = length in the inner product of path_norm.hpp, t the unit tangent of the solution curve
/// at the accepted state, in the sense of the last accepted step (pseudo-arclength: E. Riks, J. Appl. Mech. 39, 1972;
/// H. B. Keller, 1977). Afterwards the targets are those reached, and λ is Step::fraction. Does not accept.
template <int D> solve::NewtonReport solve_arc(Model<D>& model, const StepOptions& options, double length);

/// Length of the last accepted step in the norm of path_norm.hpp, the scale for arc lengths.
template <int D> double last_length(Model<D>& model);

} // namespace signorini::model
