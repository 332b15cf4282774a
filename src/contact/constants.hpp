#pragma once
// Numbers that search, projection and contact were tuned with, and why. Lengths along a face are in parts of an element
// unless said otherwise.

namespace signorini::contact {

// ── Closest points ───────────────────────────────────────────────────────────────────────────────────────────────────

/// Newton's method is trusted where f'' is above this part of τ·τ, that is where the face is far from curving as much
/// as the distance to the point; elsewhere τ·τ takes its place, which always leads downhill.
inline constexpr double trusted_curvature = 0.1;
/// Steps shorter than this are Newton's all the same: near the minimum nothing else converges quadratically.
inline constexpr double short_step = 0.01;
/// The step after one of this length leads to rounding error, since each squares the error.
inline constexpr double last_step = 1e-8;
/// Largest last step of a search that counts as converged. Gaps are then right to its square.
inline constexpr double foot_tolerance = 1e-6;
/// Iterations within one element: bisection, which guards the curve's search, halves an element to rounding in 53.
inline constexpr int most_foot_iterations = 60;
/// Halvings of one step on a surface, to far below the last step; and the part of the decrease that the slope promises
/// that a step has to bring (L. Armijo, 1966).
inline constexpr int most_halvings = 40;
inline constexpr double sufficient_decrease = 1e-4;
/// A foot whose squared distance is below this part of the element's squared diagonal is the only one on it: 1/16 of
/// the length, and no face folds that sharply within one element.
inline constexpr double near_foot = 1.0 / 256;
/// Two squared distances that differ by less are the same minimum, reached from both sides of a border.
inline constexpr double same_distance = 1e-12;

// ── Shape of a face, by which rounding error is told from what is meant ──────────────────────────────────────────────

/// Points are one, and normals parallel, to this part of the size that they are measured by.
inline constexpr double same_place = 1e-10;
/// A border is one point where these places on it are: an end, and a place in between that symmetry does not favor.
inline constexpr double border_probes[] = {0.37, 1.0};

// ── Ends of masters ──────────────────────────────────────────────────────────────────────────────────────────────────

/// A face goes on beyond an open end by this part of its last element, over which tractions fade. Where 0.2 to 0.4
/// lead: share/doc/stability.md.
inline constexpr double end_extension = 0.3;

// ── Slip points ──────────────────────────────────────────────────────────────────────────────────────────────────────

/// How far a slip point may be off Coulomb's cone, in parts of its trial distance.
inline constexpr double slip_tolerance = 1e-6;
/// Where a slip point's distance to the foot is right to this part, rounding error is all that is left.
inline constexpr double slip_rounding = 1e-15;

// ── Points that pass through a master ────────────────────────────────────────────────────────────────────────────────

/// Cosine between the normals of two faces above which they stand back to back.
inline constexpr double back_to_back = 0.5;
/// Pieces that the way through is looked at in, at most: bounds the cost where a gap is tiny next to the way.
inline constexpr int crossing_pieces = 256;

// ── Threads and caches ───────────────────────────────────────────────────────────────────────────────────────────────

/// Pieces that a contact is evaluated in: enough for many threads in space; in the plane one takes less than a thread's
/// start.
template <int D> inline constexpr int contact_pieces = D == 2 ? 1 : 32;
/// Multiplications up to which products of a block are put off: they stay within the cache, and OpenBLAS, which calls
/// threads of its own above 2^18, leaves those of the assembly alone.
inline constexpr int most_multiplications = 200'000;

} // namespace signorini::contact
