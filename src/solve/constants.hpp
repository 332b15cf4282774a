#pragma once
// Numbers that the linear solvers and Newton's method were tuned with, and why. Measurements: share/doc/benchmark.md.

#include <cstddef>

namespace signorini::solve {

// ── When a matrix counts as symmetric, singular, solved ──────────────────────────────────────────────────────────────

/// Least ratio of the smallest to the largest pivot. Below, rounding alone keeps the matrix from being singular: the
/// pivot of a rigid motion that nothing holds.
inline constexpr double least_pivot = 1e-14;
/// Largest |a_ij − a_ji| of a symmetric matrix, relative to max|a|: rounding of long sums, far below any friction.
inline constexpr double symmetry_tolerance = 1e-9;
/// Largest ‖b − K x‖ / ‖b‖ with pivots of an earlier matrix: pivots of its own leave some 1e-12, and Newton's
/// corrections need few digits.
inline constexpr double refactored_residual = 1e-8;

// ── Which solver ─────────────────────────────────────────────────────────────────────────────────────────────────────

/// Operations of a factorization for each entry that a solution reads, above which it is reused: GMRES takes some ten
/// solutions for a system, and its products cost as much again.
inline constexpr double reuse_above = 70;

// ── Reuse of a factorization ─────────────────────────────────────────────────────────────────────────────────────────

/// Most iterations of GMRES: more would cost more memory than the factors.
inline constexpr int most_iterations = 40;
/// Iterations that a system takes with new factors: what follows a new factorization, when it is weighed.
inline constexpr int usual_iterations = 6;
/// Operations that dense kernels do while one entry of the factors is read from memory.
inline constexpr double operations_per_entry = 10;
/// Price of an entry of K, which comes with its index, in entries of the factors, which come in blocks.
inline constexpr double indexed_entry = 1.5;
/// Weight of the last solution in the running mean of their price: a step asks for few digits at first and many in the
/// end, so single solutions say little.
inline constexpr double latest_weight = 0.25;

// ── Orderings with a border ──────────────────────────────────────────────────────────────────────────────────────────

/// Operations per entry of L above which nested dissection may order better than minimum degree: in the plane it does
/// not, and takes longer than the factorization.
inline constexpr double dissection_above = 500;
/// Growth of the operations at which a dissection is made again for a new pattern: it takes as long as a few
/// factorizations, and contacts that slide on change few entries.
inline constexpr double stale_dissection = 1.2;

// ── Newton's method ──────────────────────────────────────────────────────────────────────────────────────────────────

/// Where the residual is promised to fall below this part of what is asked, it is computed alone: the tangent would not
/// be used.
inline constexpr double surely_enough = 0.1;
/// Residuals within this many times what rounding leaves of them, which fall by less than the factor, have stagnated:
/// Newton's method would halve them at least.
inline constexpr double near_floor = 10, least_fall = 0.5;
/// Growth of the residual, relative to forces and first residual, that no Newton iteration recovers from.
inline constexpr double hopeless = 1e12;

// ── Line search ──────────────────────────────────────────────────────────────────────────────────────────────────────

/// Least part of a move: seven halvings.
inline constexpr double shortest_part = 1.0 / 128;
/// Part of the decrease that the slope promises that a move has to bring (L. Armijo, 1966), below the largest of this
/// many residuals (L. Grippo, F. Lampariello, S. Lucidi, SIAM J. Numer. Anal. 23, 1986).
inline constexpr double least_decrease = 1e-4;
inline constexpr std::size_t residual_memory = 4;
/// A guess is kept within these parts of the last one, or this far from the ends of its bracket.
inline constexpr double most_shortened = 0.1, least_shortened = 0.5;
/// The slope along a move has to fall to this part, in so many trials: an exact search pays nowhere.
inline constexpr double enough_slope = 0.5;
inline constexpr int most_slope_trials = 10;

// ── Pseudo-transient continuation ────────────────────────────────────────────────────────────────────────────────────

/// Largest error of an accepted move, relative to the residual; below the first part of it damping falls by the
/// divisor, above the second it grows by the factor.
inline constexpr double most_pseudo_error = 0.5, small_pseudo_error = 0.2, large_pseudo_error = 0.5;
inline constexpr double damping_fall = 5, damping_growth = 2;
/// Growth of the damping after a move that is refused, and its least value then, relative to the diagonal.
inline constexpr double damping_retry = 4, least_pseudo_damping = 1e-5;
/// Damping, relative to the diagonal, from which a move is so short that it goes over a jump of the residual if there
/// is one.
inline constexpr double strong_damping = 10;

} // namespace signorini::solve
