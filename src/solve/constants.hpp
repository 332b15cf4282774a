#pragma once
// Tuned constants of the linear solvers and Newton's method, and reasons. Measurements: share/doc/develop/benchmark.md.

#include <cstddef>

namespace signorini::solve {

// ── Symmetry, singularity, accuracy ──────────────────────────────────────────────────────────────────────────────────

/// Least ratio of the smallest to the largest pivot. Below it the matrix is singular up to rounding error, as with the
/// pivot of an unconstrained rigid-body mode.
inline constexpr double least_pivot = 1e-14;
/// Least ratio in single precision, whose rounding errors could hide such a mode: a hundred times these.
inline constexpr double least_single_pivot = 1e-5;
/// Largest |a_ij − a_ji| of a symmetric matrix, relative to max|a|: rounding error of long sums, far below any
/// friction.
inline constexpr double symmetry_tolerance = 1e-9;
/// Largest ‖b − K x‖ / ‖b‖ with L D Lᵀ without pivoting whose signs count: growth of rounding errors by 1e8 is far from
/// changing a sign, unless an eigenvalue is zero.
inline constexpr double reliable_factors = 1e-8;
/// Largest ‖b − K x‖ / ‖b‖ with the pivots of an earlier matrix: with its own pivots about 1e-12 is reached, and
/// Newton's corrections need few digits.
inline constexpr double refactored_residual = 1e-8;

// ── Choice of the solver ─────────────────────────────────────────────────────────────────────────────────────────────

/// Ratio of a factorization's operations to the entries that a solution reads, above which it is reused: GMRES needs
/// about ten solutions per system, and its matrix products cost as much again.
inline constexpr double reuse_above = 35;

// ── Reuse of a factorization ─────────────────────────────────────────────────────────────────────────────────────────

/// Most iterations of GMRES: more would need more memory than the factors.
inline constexpr int most_iterations = 40;
/// Iterations per system expected with new factors, when the cost of a new factorization is estimated.
inline constexpr int usual_iterations = 6;
/// Contact unknowns are not ordered last if that multiplies a factorization's operations by more than `most_bordered`,
/// which is found out where the LU of their block takes more than the part `large_block` of these operations. For a
/// strip of 10 rows of elements whose layer follows the peeling front the factor was 3.5, and the run took 1.6 times as
/// long with the block as without.
inline constexpr double large_block = 0.25, most_bordered = 2;
/// Floating-point operations of dense kernels in the time in which one entry of the factors is read from memory.
inline constexpr double operations_per_entry = 10;
/// Cost of ordering and permuting an entry of the matrix, relative to reading one.
inline constexpr double preparation = 50;
/// Entries of a matrix above which the factors of its preconditioner are rounded to single precision: those of smaller
/// ones fit into caches, and the dense block of their contact unknowns is small, so that it saves nothing, and with
/// exact factors the last correction is far below its tolerance.
inline constexpr int single_above = 300000;
/// Largest tolerance of Newton's corrections, relative to the residual. Larger ones cost Newton iterations. An error of
/// a multiplier may change a contact state: at 1e-3 two of seven cases of ironing fail that converge at 1e-4 and below.
inline constexpr double loosest_tolerance = 1e-3, loosest_for_multipliers = 1e-4;
/// Smallest tolerance: a smaller one costs iterations of GMRES without benefit.
inline constexpr double tightest_tolerance = 1e-10;
/// Fewest and most digits gained by a solution when its iterations are compared with those of another.
inline constexpr double least_digits = 0.1, most_digits = 16;

// ── Threads ──────────────────────────────────────────────────────────────────────────────────────────────────────────

/// Entries of a matrix or factor per task: reading them takes ten times as long as starting a thread.
inline constexpr int entries_per_share = 200000;
/// Most tasks of equal size: enough for a few threads, one of which may be slower.
inline constexpr int most_shares = 6;

/// Size of a dense matrix from which its LU is shared by threads, and columns of its panels: narrow enough that the
/// panels, which are not shared, take a tenth of the time, wide enough for products.
inline constexpr int shared_dense_size = 384, panel_width = 96;

// ── Orderings with a border ──────────────────────────────────────────────────────────────────────────────────────────

/// Operations per entry of L above which nested dissection may be better than minimum degree: in the plane it is not,
/// and takes longer than the factorization.
inline constexpr double dissection_above = 500;
/// Growth of the operations at which a dissection is repeated for a new pattern: it takes as long as a few
/// factorizations, and sliding contacts change few entries.
inline constexpr double stale_dissection = 1.2;

// ── Newton's method ──────────────────────────────────────────────────────────────────────────────────────────────────

/// If the predicted residual is below this fraction of the tolerance, it is computed without the tangent, which would
/// not be used.
inline constexpr double surely_below = 0.1;
/// A residual has stagnated if it is within this multiple of its rounding level and decreases by less than the factor:
/// Newton's method would at least halve it.
inline constexpr double near_floor = 10, least_fall = 0.5;
/// Growth of the residual, relative to forces and first residual, from which Newton's method does not recover.
inline constexpr double divergence_growth = 1e12;

// ── Schur complements with an indefinite border ──────────────────────────────────────────────────────────────────────

/// Factors by which the shifts of the border's rows are raised until the shifted matrix is positive definite: relative
/// to the diagonal, once, or to the largest entry of the matrix for multipliers, where soft bodies need large ones. The
/// largest leaves half of the digits.
inline constexpr double raise_step = 100, most_raise = 1e8;

// ── Line search ──────────────────────────────────────────────────────────────────────────────────────────────────────

/// Shortest fraction of a move: seven halvings.
inline constexpr double shortest_part = 1.0 / 128;
/// Required fraction of the decrease predicted by the slope (L. Armijo, 1966), relative to the largest of this many
/// residuals (L. Grippo, F. Lampariello, S. Lucidi, SIAM J. Numer. Anal. 23, 1986).
inline constexpr double least_decrease = 1e-4;
inline constexpr std::size_t residual_memory = 4;
/// The next fraction lies within these multiples of the last one, or this far from the ends of its bracket.
inline constexpr double most_shortened = 0.1, least_shortened = 0.5;
/// The slope along a move has to decrease to this fraction, in so many trials: an exact search is never worth its cost.
inline constexpr double slope_tolerance = 0.5;
inline constexpr int most_slope_trials = 10;

// ── Pseudo-transient continuation ────────────────────────────────────────────────────────────────────────────────────

/// Largest error of an accepted move, relative to the residual; an error below the fraction `small_pseudo_error` of it
/// divides the damping, one above `large_pseudo_error` multiplies it.
inline constexpr double most_pseudo_error = 0.5, small_pseudo_error = 0.2, large_pseudo_error = 0.5;
inline constexpr double damping_fall = 5, damping_growth = 2;
/// Growth of the damping after a rejected move, and its least value then, relative to the diagonal.
inline constexpr double damping_retry = 4, least_pseudo_damping = 1e-5;
/// Damping, relative to the diagonal, above which moves are so short that they pass a jump of the residual, if there is
/// one.
inline constexpr double strong_damping = 10;

} // namespace signorini::solve
