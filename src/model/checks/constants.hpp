#pragma once
// Numerical parameters of checks of scenes and states, with the reasons for their values. Apart from
// model/constants.hpp, which every file of the module includes.

namespace signorini::model {

// ── Overlaps that no contact declares ────────────────────────────────────────────────────────────────────────────────

/// Sides whose segments are shorter than this fraction of their coordinates are collapsed up to rounding errors.
inline constexpr double outline_rounding = 1e-12;
/// Distance of a point next to an outline, relative to the length of its pieces: above rounding errors of bodies at 1e6
/// times their size, below the width of crevices in elements of very different sizes.
inline constexpr double beside_outline = 1e-6;
/// Pieces of an outline that are shorter than this fraction of the thickness are left to their neighbors: errors of
/// positions within the tolerance of equilibrium turn their normals.
inline constexpr double shortest_piece = 1e-6;
/// Cosine between normals of a body's outline above which two places are parts of the same bend, not of two layers.
inline constexpr double same_bend = 0.5;
/// Overlaps relative to the thickness above which a warning is given.
inline constexpr double small_overlap = 0.01;
/// Multiple of a body's declared penetrations up to which its other faces may penetrate: faces next to a contact share
/// its edge, where penetrations exceed those at contact points.
inline constexpr double declared_slack = 2;
/// Distance from a curve or surface, relative to a segment's length, up to which the place where the sign of the gap
/// changes along the segment is on it.
inline constexpr double crossing_distance = 0.1;

// ── Overlaps at the start, parts of a body ───────────────────────────────────────────────────────────────────────────

/// Unbalanced forces, relative to those of the run, above which a state is not examined for stability: only a tolerance
/// that the user has loosened accepts them.
inline constexpr double loose_balance = 1e-3;

/// Mean strain that closes an overlap above which a warning is given: it is nearly what yields mild steel (σ/E = 250
/// MPa over 210,000 MPa), a stress that no load explains. Interference fits, which are meant, strain as much or more:
/// they are declared.
inline constexpr double meant_strain = 1e-3;

/// Mean distance of points from the master in mortar contact whose mean gaps are closed, relative to the approach,
/// above which a warning is given. Of scenes that tests/measure/robustness.lua generates, forces at prescribed motions
/// are 5 to 50 % off with 0.15 to 0.5 (four times as many elements), below 3 % with 0.06 to 0.1, where faces are
/// pressed flat.
inline constexpr double uneven_part = 0.1;

/// Displacement along the normal, in a rigid-body mode with a largest component of 1, that parts faces; by less they
/// slide along each other.
inline constexpr double parting = 0.1;

/// Cosine between the outward normals of a slave face and of an obstacle, where they are closest, above which the body
/// lies behind the obstacle: 1 for smooth faces that touch, −1 on the right side, between −0.5 and 0.5 where the slave
/// ends at a wall.
inline constexpr double behind_cosine = 0.5;

/// Part of a body's strain energy in tractions that vary along directions of degree 1 above which a warning is given: a
/// body in pure bending is by 1/(1 − part) too stiff. Strains below `unstrained` are rounding error.
inline constexpr double most_locked = 0.1, unstrained = 1e-8;

} // namespace signorini::model
