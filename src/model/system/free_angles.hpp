#pragma once
// Angles of obstacles that are unknowns.

#include "model/system/unknowns.hpp"

namespace signorini::model {

/// The unknown of a free angle θ is the arc s = L θ at the arm L of contact::Turning, and its row of the residual a
/// moment divided by L, so that lengths and forces of all unknowns compare. The markers follow it
/// [theory 6.2],
///     u_i = L (R(s/L) − I) e_i.
///
/// Sets the displacements of the markers.
template <int D> void follow_angles(const Unknowns<D>& unknowns, VectorX& displacement);

/// ∂u/∂s of the markers, by degree of freedom; 1 for all others.
template <int D> VectorX angle_rates(const Unknowns<D>& unknowns, const VectorX& displacement);

/// Adds the forces of the markers to the rows of the angles: f_s += Σ_i f_i·∂u_i/∂s.
template <int D> void add_moments(const Unknowns<D>& unknowns, const VectorX& displacement, VectorX& force);

/// Σ_i f_i·∂²u_i/∂s², the part of an angle's tangent that is due to the path of its markers.
template <int D> double angle_curvature(const FreeAngle<D>& angle, const VectorX& displacement, const VectorX& force);

} // namespace signorini::model
