#pragma once
// Numerical parameters of steps, active sets and warnings, with the reasons for their values.

#include <cstddef>

namespace signorini::model {

// ── First guesses of a step ──────────────────────────────────────────────────────────────────────────────────────────

/// Initial contact tolerance: |gaps| below this fraction of the largest position are rounding error.
inline constexpr double gap_rounding = 1e-12;
/// Largest deviation from a straight path, relative to the step: well above the rounding error of targets that a script
/// sums up.
inline constexpr double straight = 1e-6;
/// Deviation of the last step from its linear extrapolation up to which the next one is used. In ironing and Hertz
/// contact 0.1 to 0.5 give the same steps; with 1 steps after the first contact of bodies fail.
inline constexpr double most_linear_error = 0.3;
/// Deviation of the last step from its quadratic extrapolation up to which the quadratic one is used in any case;
/// above, only if the linear one deviated more.
inline constexpr double small_quadratic_error = 0.1;
/// Stands for both deviations where rates have a jump: above all others, and finite as archives ask.
inline constexpr double across_kink = 1e300;

// ── Forces of a run ──────────────────────────────────────────────────────────────────────────────────────────────────

/// Forces of supports and loads below this fraction of those of contact leave bodies in balance that only press on each
/// other, as in an interference fit: residuals then compare with the contact forces. Where supports or loads press the
/// bodies together, they are of the same magnitude.
inline constexpr double self_balanced = 1e-3;
/// Mean strain, by its energy, above which the bodies of a run are deformed. A rigid motion by 1e6 times the size of an
/// element leaves 2e-10, by the rounding of positions.
inline constexpr double deformed_strain = 1e-6;
/// Pressure relative to Young's modulus above which a contact acts: above the pressure of gaps of `gap_rounding` under
/// a stiff penalty, below strains of interest.
inline constexpr double noticeable_strain = 1e-9;

// ── Linear bodies ────────────────────────────────────────────────────────────────────────────────────────────────────

/// Operations per entry of the tangent that dense factors of all unknowns on contact faces may cost in every iteration:
/// as few as the elements' forces. Meshes in the plane are below it unless they are flat, in space only small ones.
inline constexpr double whole_faces = 100;

/// Limit of the known positions of contact blocks in the tangent, as a multiple of the number of blocks.
inline constexpr std::size_t most_placements = 16;

// ── Unconstrained bodies ─────────────────────────────────────────────────────────────────────────────────────────────

/// Largest motion of a body in contact in one damped iteration, relative to the bodies' extent.
inline constexpr double small_stride = 1e-3;
/// Largest motion of an obstacle, which does not deform where it penetrates: a tool sinks by a tenth of the bodies'
/// extent in ten iterations.
inline constexpr double obstacle_stride = 1e-2;
/// Smallest damping relative to the diagonal: keeps the tangent regular for motions without work, such as frictionless
/// sliding.
inline constexpr double least_damping = 1e-10;
/// Displacement relative to the model's size, beyond the prescribed ones, that only unconstrained bodies reach.
inline constexpr double far_away = 1e3;
/// A body has come into contact when |f·Δu| is below this fraction of its largest value.
inline constexpr double closed_energy = 1e-2;

// ── Pseudo-transient continuation ────────────────────────────────────────────────────────────────────────────────────

/// Limit of moves as a multiple of the limit of iterations, because moves are small.
inline constexpr int most_moves_per_iteration = 40;
/// Largest displacement relative to the bodies' extent; bodies that move farther are unconstrained.
inline constexpr double most_way = 0.5;
/// Limit of trials per move. Sufficient damping makes any move acceptable, unless the tangent cannot be factored.
inline constexpr int most_trials = 30;

// ── States of contact points ─────────────────────────────────────────────────────────────────────────────────────────

/// Relative difference below which residuals repeat: far below the effect of a change of state, far above rounding
/// error.
inline constexpr double same_residual = 1e-9;
/// Number of recorded evaluations, three times the longest period detected; and of those searched for cycling points.
inline constexpr std::size_t remembered_evaluations = 24, recent_evaluations = 8;
/// Hysteresis of penalties: fraction of the closed constraints that must open at once, and error of a linearized gap
/// relative to its change. In 2D ironing with a penalty of 500 E/L 0.1, 0.2, 0.3 of the closed ones take 6.5, 6.9, 7.8
/// iterations per step instead of 8.9, with 100 E/L 3.4 each as without, where hysteresis at any number takes 3.8.
inline constexpr double many_opened = 0.2, linearization_error = 0.3;
/// Evaluations over which the number of closed constraints is summed to see whether it shrinks, a multiple of most
/// periods of cycles; and limit of iterations in units of the usual one while it does.
inline constexpr std::size_t trend = 12;
inline constexpr int most_extension = 4;
/// Limit of rounds in which points that change too often are fixed and freed.
inline constexpr int most_rounds = 5;

// ── Bodies that overlap at the start ─────────────────────────────────────────────────────────────────────────────────

/// Overlap relative to the thinner body's thickness above which an error is given; the limit of warnings is in
/// checks/constants.hpp.
inline constexpr double mistaken_overlap = 0.2;
/// Offset relative to the thinner body's thickness above which a warning is given.
inline constexpr double large_offset = 0.2;
/// Depth of wear above which a warning is given, relative to the thickness of the slave's body, and to the radius of
/// the master: in ironing mortar contact takes three times the iterations from 0.05 on, as with an offset of this
/// depth.
inline constexpr double much_wear = 0.1, much_curved_wear = 0.05;
/// Penetration relative to the thickness of the master's body above which the opposite face is suggested.
inline constexpr double whole_depth = 0.9;
/// Overlap with a rigid obstacle relative to the body's size that is due to rounding error and inexact geometry.
inline constexpr double obstacle_overlap = 0.01;

// ── Quadrature ───────────────────────────────────────────────────────────────────────────────────────────────────────

/// Ratio of weights up to which a body's volume is not examined (those of arcs differ by a factor of 2 up to 120°), and
/// the relative error of volumes and areas above which a warning is given.
inline constexpr double usual_weights = 4, most_quadrature_error = 0.01;

// ── Ties ─────────────────────────────────────────────────────────────────────────────────────────────────────────────

/// Multipliers of ties are divided by this multiple of E/h, and the proximal term η on their diagonal, see TieTerms.
inline constexpr double tie_scale = 10, tie_proximal = 1e-8;
/// Largest distance of tied faces relative to an element's length: chords of arcs of 45° are 0.1 of their length away
/// from them.
inline constexpr double most_seam_distance = 0.1;
/// Faces of the patches of a body that coincide have normals that are opposite at least by this cosine; sides of
/// patches that meet at an edge, under 45° in round shapes, do not.
inline constexpr double coincident_facing = -0.9;
/// Fraction from which a face counts as tied as a whole.
inline constexpr double least_whole = 1 - 1e-6;
/// Relative residual up to which rigid-body modes depend on each other at prescribed control points.
inline constexpr double dependent_modes = 1e-8;

// ── Diagnosis ────────────────────────────────────────────────────────────────────────────────────────────────────────

/// Limit of places in a diagnosis, and the least share of a control point in a vector that it names.
inline constexpr std::size_t most_places = 5;
inline constexpr double least_share = 1e-6;
/// A direction belongs to a body with more than the first fraction of its norm, and is a rigid-body mode if the
/// fraction that deforms the body is below the second.
inline constexpr double own_part = 0.5, deformed_part = 0.01;
/// A body slides on a face if the normal fraction of its motion is below this.
inline constexpr double across_part = 0.1;

// ── Contacts ─────────────────────────────────────────────────────────────────────────────────────────────────────────

/// ε h/E of contacts with multipliers, whose results hardly depend on the penalty ε, with E and h of the softer body.
/// In 2D ironing with dies of 9 to 36 elements on a slab of 24 (N2-N2.2) 3.2 to 3.9 iterations per step; with h of a
/// stiff slave, up to 5.2.
inline constexpr double default_penalty_ratio = 10;
/// ε h/E of contacts that are enforced by the penalty alone. In Hertz's line and point contact over 5 elements (N2)
/// penetration is 0.4 and 1.0 % of the approach with 30 (forces 0.4 and 1.5 % too small), 1.2 and 2.7 % with 10, 0.1
/// and 0.3 % with 100, which doubles the width from which peaks are right (scripts/studies/contact_width.lua).
inline constexpr double default_penalty_alone = 30;
/// Least widths of a zone of contact from which peaks are within 10 % of Hertz's, in functions of the slave face:
/// elements times p − k for degree p and continuity k (scripts/studies/contact_width.lua). At Gauss points with penalty
/// ratio c peak_functions √(c/30), since a high penalty over-constrains, of degree 1 in proportion to c; of mortar
/// contact with multipliers "equal" and "reduced" at any penalty.
inline constexpr double peak_functions = 7, peak_functions_linear = 13;
inline constexpr double peak_functions_mortar = 8, peak_functions_reduced = 6;
/// The error of peaks at these widths, and the number of elements from which the mean over one is about as exact.
inline constexpr double peak_error = 0.1, mean_elements = 4;
/// Penetration or elastic slip relative to the approach from which a warning is given, and which the penalty that it
/// suggests leaves; and pressure relative to Young's modulus, or penetration relative to an element, that is rounding
/// error.
inline constexpr double noticeable_part = 0.05, small_part = 0.01, contact_rounding = 1e-10;
/// Under a penalty below this multiple of E/h pressures below this fraction of E strain bodies so little that their
/// energy is rounding error: the springs take up all of the approach.
inline constexpr double far_too_soft = 1e-3, lost_strain = 1e-8;
/// Ratio of Young's moduli above which a slave is stiff compared with its master, for a warning about its multipliers.
inline constexpr double stiff_slave = 3;

/// Least number of elements in the cohesive zone, below which a warning is given (A. Turon et al., Eng. Fract. Mech.
/// 74, 2007). In share/doc/evidence/debonding.md forces of the bilinear law oscillate by 2 % with 3.4, by 6 % with 2.3.
inline constexpr int zone_elements = 3;
/// Traction relative to the strength above which the report of a failed step counts a bond.
inline constexpr double high_traction = 0.5;

// ── Threads ──────────────────────────────────────────────────────────────────────────────────────────────────────────

/// Limit of shares of a body; the parts of contacts are further parallel tasks.
inline constexpr int most_shares = 4;
/// Least number of elements per share: 30 µs of work, several times the time to wake a thread.
template <int D> inline constexpr int worth_sharing = D == 2 ? 64 : 8;

// ── Warnings ─────────────────────────────────────────────────────────────────────────────────────────────────────────

/// Poisson's ratios from which elements of degree 1 lock, above which those of degree 2 and those of higher degree do:
/// locking adds 2, 1 and less than 1 % to the error of a force there (share/doc/decide/locking.md).
inline constexpr double locking_linear = 0.45, locking_quadratic = 0.497, locking_higher = 0.499;
/// Coefficient of friction above which an angle in degrees is suspected; rubber on dry concrete has about 1.
inline constexpr double most_friction = 3;
/// ε_N h/E from which steps need cutting (10 to 100 times E/h is accurate), and from which the rounding error of the
/// contact stiffness exceeds the stiffness of the body.
inline constexpr double stiff_penalty = 1e4, beyond_rounding = 1e8;
/// Rotation, in radians, and principal strain, each in the mean over an element, from which a warning about Hooke's law
/// of small strains is given: it takes a rotation by 10° for a compression of 1.5 % in every direction, and the terms
/// of second order that it omits at a strain of 5 % are some 5 % of the stress.
inline constexpr double most_small_rotation = 0.17453292519943295, most_small_strain = 0.05;
/// Stability of a state: stiffness relative to the tangent's diagonal that is rounding error. Buckling loads of slender
/// bodies change it by more: by 1e-8 at a slenderness of 100. And the stiffness of closed conditions of multipliers
/// relative to that of the displacements that they constrain: softer by 1e-4 than in the limit, and with rounding
/// errors below those of the first.
inline constexpr double neutral_stiffness = 1e-13, constraint_stiffness = 1e4;
/// A last correction below this part of the displacements changes the stiffness that loads cause by about as much.
inline constexpr double small_correction = 1e-3;
/// A motion is rigid from this share of it on, and its stiffness is due to the discretization of the contacts below
/// this part of their force per extent.
inline constexpr double rigid_share = 0.9, neutral_share = 0.1;
/// Relative error of a prescribed shape's projection above which the supports follow another function than the user's.
inline constexpr double most_shape_error = 0.01;

} // namespace signorini::model
