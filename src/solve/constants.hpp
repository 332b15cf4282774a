#pragma once
// Numbers that the linear solvers were tuned with, and why. Measurements: share/doc/benchmark.md.

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
/// A body is slender where its band is at most this times √n wide: a square of bilinear elements has √n.
inline constexpr double slender_width = 2;
/// A band so narrow costs less than the overhead of sparse solvers, whatever the body's shape.
inline constexpr double narrow_band = 100;

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

} // namespace signorini::solve
