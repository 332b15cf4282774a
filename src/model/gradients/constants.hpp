#pragma once
// Numbers of the passes by which neighbors follow a run, and of kinks.

namespace signorini::model {

/// Residual of the derivative of the state, relative to its first value, at which it counts as exact.
inline constexpr double exact_derivative = 1e-8;
/// Relative residual of the linear system of a pass, whose error the next one removes.
inline constexpr double solution_tolerance = 1e-8;
/// What is good enough where it falls slowly, relative also to the forces per size of the parameter; where it rises, a
/// bound on the rounding errors of the residual over ε.
inline constexpr double good_derivative = 3e-8;
/// Even part of the residual, relative to the odd one before the first pass, above which the neighbors are on two sides
/// of a kink: curvature leaves about ε.
inline constexpr double kinked_part = 3e-4;
/// A pass that leaves more than this fraction of the residual gains little: the factors are not those of this state, or
/// rounding errors are reached. So many of these end the passes.
inline constexpr double slow_pass = 0.3;
inline constexpr int most_slow_passes = 3;
/// Passes to go, at the rate of the last one, above which new factors cost less.
inline constexpr double few_passes = 4;
inline constexpr int most_passes = 12;
/// Share of the contact forces at points that change their state, up to which a derivative holds.
inline constexpr double heavy = 0.01;

} // namespace signorini::model
