#pragma once
// Numbers that steps, active sets and warnings were tuned with, and why.

#include <cstddef>

namespace signorini::model {

// ── First guesses of a step ──────────────────────────────────────────────────────────────────────────────────────────

/// Gaps nearer to 0 than this part of the largest position are what rounding error makes of 0.
inline constexpr double gap_rounding = 1e-12;
/// How far a path may turn, relative to the step, and count as straight: rounding error of targets that a script has
/// added up, and room to spare.
inline constexpr double straight = 1e-6;
/// Most that the last two steps' rates may differ by for a linear prediction, see Way::bend. Ironing and Hertz: 0.1 to
/// 0.5 make no difference; with 1 steps fail where bodies have just touched first.
inline constexpr double most_bent = 0.3;

// ── Bodies that only contact holds ───────────────────────────────────────────────────────────────────────────────────

/// How far a body that touches may go in one damped iteration, in parts of the bodies' extent.
inline constexpr double small_stride = 1e-3;
/// Least damping in parts of the diagonal: keeps motions regular that no force works on, such as sliding without
/// friction.
inline constexpr double least_damping = 1e-10;
/// A fall has come to an end where |f·Δu| is below this part of its largest value.
inline constexpr double landed = 1e-2;

// ── Pseudo-transient continuation ────────────────────────────────────────────────────────────────────────────────────

/// It makes many small moves: how many times the iterations of a step it may take.
inline constexpr int most_moves_per_iteration = 40;
/// In parts of the bodies' extent: what has moved on from there is held by nothing.
inline constexpr double most_way = 0.5;
/// Damped strongly enough any move is accepted; what is left are tangents that cannot be factored.
inline constexpr int most_trials = 30;

// ── States of contact points ─────────────────────────────────────────────────────────────────────────────────────────

/// Relative difference of residuals that have come back: far below what a state leaves, far above rounding error.
inline constexpr double same_residual = 1e-9;
/// Evaluations that are remembered: three rounds of the longest period that is looked for; and those in which points
/// that change their state are looked for.
inline constexpr std::size_t remembered_evaluations = 24, recent_evaluations = 8;
/// How often points that change too often may be held, freed, and held again.
inline constexpr int most_rounds = 5;

// ── Bodies that overlap at the start ─────────────────────────────────────────────────────────────────────────────────

/// An overlap is worth a warning above the first part of the thinner body's thickness, and an error above the second:
/// interference fits are below a hundredth.
inline constexpr double meant_overlap = 0.01, mistaken_overlap = 0.2;
/// Of the thickness of the master's body: a slave that is so deep in it looks at the body's back.
inline constexpr double whole_depth = 0.9;
/// Overlap with a rigid obstacle, as a part of the body's size, that rounding and drawing leave.
inline constexpr double obstacle_overlap = 0.01;

// ── Diagnosis ────────────────────────────────────────────────────────────────────────────────────────────────────────

/// Places that a diagnosis names at most.
inline constexpr std::size_t most_places = 5;
/// A direction belongs to a body that has more than the first part of it, and moves it as a whole where less than the
/// second part deforms it.
inline constexpr double own_part = 0.5, deformed_part = 0.01;
/// A body slides on a face where less than this part of its motion leads across.
inline constexpr double across_part = 0.1;

// ── Threads ──────────────────────────────────────────────────────────────────────────────────────────────────────────

/// Shares of a body at most: more than cores, since contacts are shared out as well.
inline constexpr int most_shares = 4;
/// Elements in a share: 30 µs of work, several times what it takes to wake a thread.
template <int D> inline constexpr int worth_sharing = D == 2 ? 64 : 8;

// ── Warnings ─────────────────────────────────────────────────────────────────────────────────────────────────────────

/// Poisson's ratio from which elements of degree 1 lock, and beyond which those of any degree do:
/// share/doc/stability.md.
inline constexpr double locking_linear = 0.45, locking_any = 0.499;
/// Largest coefficient of friction that is not taken for an angle: rubber on dry concrete is at 1.
inline constexpr double most_friction = 3;
/// ε_N h/E from which steps need cutting ("10 to 1000 times E/h" is usual), and from which the body's own stiffness is
/// lost in the rounding error of the contact's.
inline constexpr double stiff_penalty = 1e4, beyond_rounding = 1e8;

} // namespace signorini::model
