#pragma once
// Numerical parameters of search, projection and contact, with the reasons for their values. Lengths along a face are
// fractions of an element's length unless noted otherwise.

namespace signorini::contact {

// ── Closest points ───────────────────────────────────────────────────────────────────────────────────────────────────

/// Newton's method uses f'' where it exceeds this fraction of τ·τ, that is unless the distance to the point is close to
/// or above the face's radius of curvature; there it uses τ·τ (Gauss–Newton), which always gives a descent direction.
inline constexpr double trusted_curvature = 0.1;
/// Shorter steps use f'' in any case: near the minimum only Newton's method converges quadratically.
inline constexpr double short_step = 0.01;
/// The step after one of this length reaches rounding error, because each step squares the error.
inline constexpr double last_step = 1e-8;
/// Largest last step of a search that counts as converged. The error of gaps is then of the order of its square.
inline constexpr double foot_tolerance = 1e-6;
/// Iterations within one element: bisection, the safeguard of the search on curves, needs 53 to reach rounding error.
inline constexpr int most_foot_iterations = 60;
/// Largest number of halvings of one step on a surface, which leads far below `last_step`; and the fraction of the
/// linearly predicted decrease that a step must achieve (Armijo's rule; L. Armijo, 1966).
inline constexpr int most_halvings = 40;
inline constexpr double sufficient_decrease = 1e-4;
/// Relative rounding error of a squared distance.
inline constexpr double distance_rounding = 1e-14;
/// Squared distances with a smaller relative difference are the same minimum, reached from both sides of a border.
inline constexpr double same_distance = 1e-12;
/// Coordinates within this fraction of an element's length of its border are on it.
inline constexpr double border_slack = 1e-14;
/// The last step of a search on a curve, if it is shorter than this fraction of the element, shifts position and
/// tangent to first order: its square is below rounding error.
inline constexpr double exact_shift = 1e-12;
/// Added to the metric of a surface, relative to its trace: next to a pole the metric is singular, and its inverse
/// would consist of rounding error.
inline constexpr double pole_metric = 1e-12;
/// Sine of the angle between the tangents of a surface below which they have no normal, and the fractions of the way to
/// the middle of the element at which a normal is then looked for: rounding error is far below the first.
inline constexpr double least_sine = 1e-9;
inline constexpr double inward_probes[] = {0, 1e-6, 1e-3};
/// Maximum number of moves to another element without a reduction of the distance: around a corner of four elements.
inline constexpr int most_level_moves = 4;

// ── Geometric tolerances against rounding error ──────────────────────────────────────────────────────────────────────

/// Relative tolerance below which points coincide and normals are parallel.
inline constexpr double same_place = 1e-10;
/// A border is collapsed if its points at these fractions coincide: an end, and an inner point off any symmetry.
inline constexpr double border_probes[] = {0.37, 1.0};

/// Largest relative difference of weights on the border of two faces of a list, apart from a constant factor: as for
/// joins, whose control points may come from files.
inline constexpr double same_weights = 1e-6;

// ── Level sets ───────────────────────────────────────────────────────────────────────────────────────────────────────

/// Rounding error of quotients of lengths, by which a number of cells must not grow.
inline constexpr double cell_rounding = 1e-12;
/// Change of the parameter along an edge of the lattice below which the zero on it is found to rounding error, and the
/// largest number of iterations: bisection alone needs 53.
inline constexpr double edge_tolerance = 1e-14;
inline constexpr int most_edge_iterations = 100;
/// Largest |f| at such a zero, relative to its values at the ends of the edge: a continuous f is at rounding error
/// there, at a jump it is not small.
inline constexpr double jump_value = 1e-6;
/// Least |∇f| at such a zero, relative to those values over the spacing: below it normals are rounding error.
inline constexpr double least_gradient = 1e-8;

// ── Ends of masters ──────────────────────────────────────────────────────────────────────────────────────────────────

/// A face is extended beyond an open end by this fraction of its last element or, where these are smaller, of the
/// slave's elements; over the extension tractions fade to zero. Values from 0.2 to 0.4 are compared in
/// share/doc/evidence/stability.md.
inline constexpr double end_extension = 0.3;
/// Where the length of the last elements is sampled along each element of a border, from 0 to 1.
inline constexpr double border_samples[] = {0, 0.5, 1};

// ── Sets of faces ────────────────────────────────────────────────────────────────────────────────────────────────────

/// A foot on the own body counts if the angle of the normals of point and foot is at least this, 60° in radians: a
/// smooth piece that turns by less has no contact with itself [theory 8.4].
inline constexpr double least_facing = 1.0471975511965976;
inline constexpr double least_facing_cosine = 0.5;
/// Depth up to which a foot counts, of the thickness behind it and, of the own body, of the distance in the reference
/// configuration: beyond the first a point belongs to the other side, beyond the second to the corner that it comes
/// from.
inline constexpr double deepest_part = 0.5;
inline constexpr double deepest_own = 0.25;
/// How far a point looks for feet on its own body, in elements, unless its motion may have led it farther.
inline constexpr double near_elements = 3;
/// Turning of normals in a step, 10° in radians, with which elements that see each other are still found.
inline constexpr double turning_margin = 0.17453292519943295;
/// Elements that share control points and differ in direction by `least_facing` lie across a convex edge if neither is
/// in front of the tangent planes of the other by more than this angle, as sine.
inline constexpr double flat_sine = 0.1;

// ── Points per element ───────────────────────────────────────────────────────────────────────────────────────────────

/// A closed element has its full rule while its least pressure is below this fraction of its largest: the border of the
/// contact, where the pressure is zero, is then about an element away.
inline constexpr double border_pressure = 0.2;
/// An open element has its full rule while its distance from contact is below this multiple of the last step's motion,
/// or below this fraction of its diagonal: the next step may be longer, and points far from contact cost little.
inline constexpr double border_motion = 2, border_distance = 0.5;
/// Factor on both limits for elements that have their full rule.
inline constexpr double rule_hysteresis = 2;

// ── Slip points ──────────────────────────────────────────────────────────────────────────────────────────────────────

/// Least length of an axis of friction on the slave face, relative to its length in space.
inline constexpr double least_axis = 1e-6;
/// Largest distance of a slip point from Coulomb's cone, relative to its trial distance.
inline constexpr double slip_tolerance = 1e-6;
/// Iterations for the slip at which a formula of friction is met: bisection, the safeguard, needs 53.
inline constexpr int most_slip_iterations = 60;
/// Relative error of a slip point's distance to the foot point that counts as rounding error.
inline constexpr double slip_rounding = 1e-15;
/// Relative error of such a distance where positions are rounded, whose error is relative to coordinates.
inline constexpr double position_rounding = 1e-8;

// ── First touch ──────────────────────────────────────────────────────────────────────────────────────────────────────

/// Rounding error of the forecast distance where a point touches, relative to that at the start of the step, and the
/// number of projections for it: not a tolerance, which rounding error would decide. The forecast itself is worse.
inline constexpr double touch_tolerance = 1e-12;
inline constexpr int most_touch_trials = 8;

// ── Points that pass through a master ────────────────────────────────────────────────────────────────────────────────

/// Cosine between the outward normals of two faces above which they point in the same direction.
inline constexpr double back_to_back = 0.5;
/// Largest number of samples along a point's path through the master; bounds the cost where the gap is tiny compared
/// with the path.
inline constexpr int crossing_pieces = 256;
/// Depth, in thicknesses, from which on a point of a set may have passed through a part.
inline constexpr double crossing_depth = 0.25;

// ── Bonds ────────────────────────────────────────────────────────────────────────────────────────────────────────────

/// A point is bonded if its distance from the master is at most this fraction of the opening at the largest traction:
/// the bonds then start with less than 0.3 % of their strength.
inline constexpr double bond_distance = 1e-3;
/// Opening of an exponential bond, as a multiple of that at the largest traction, beyond which it transmits nothing:
/// the traction is below 1e-15 of the strength.
inline constexpr double broken_opening = 40;
/// Fraction of its energy of separation beyond which a bond counts as broken: an exponential law never reaches all.
inline constexpr double broken_energy = 0.99;

// ── Multipliers that are unknowns ────────────────────────────────────────────────────────────────────────────────────

/// Proximal term on a multiplier's diagonal, as a fraction of scale times area. It is of the order of the compliance of
/// a penalty by 1e8 times the bodies' stiffness: Newton's method leaves less than that fraction of the error to the
/// next iteration, while pivots remain far above rounding error.
inline constexpr double proximal = 1e-8;
/// The same of contacts, whose multipliers overlap: their diagonal alone is regular.
inline constexpr double proximal_contact = 1e-9;
/// Projections by which a slip point on a curved master is found; each reduces the error by the square of slip over
/// radius of curvature.
inline constexpr int slip_corrections = 3;

// ── Threads and caches ───────────────────────────────────────────────────────────────────────────────────────────────

/// Pieces in which a contact is evaluated: enough for many threads in 3D; in 2D evaluating a piece takes less time
/// than starting a thread.
template <int D> inline constexpr int contact_pieces = D == 2 ? 1 : 32;
/// Multiplications up to which products of a block are collected: their factors fit into the cache, and OpenBLAS,
/// which starts threads above 2^18, does not compete with the threads of the assembly.
inline constexpr int most_multiplications = 200'000;

} // namespace signorini::contact
