#pragma once
// Dead loads: forces on a face of a body; size and direction refer to the reference configuration.

#include "solid/body.hpp"

namespace signorini::solid {

/// f_A = ∫ R_A dA e_component over the reference area of a face: the nodal forces of a unit traction. D values per
/// control point of the body; per unit depth in plane strain, over the full circle for a body of revolution. The side
/// may cross layers. Throws Error for a component that is not in 0 … D−1.
template <int D> VectorX traction_load(const Body<D>& body, nurbs::Side side, int component);

/// f_A = −∫ R_A N dA with the outward normal N of the reference configuration: the nodal forces of a unit pressure as a
/// dead load, whose direction does not follow the deformation. Otherwise as traction_load().
template <int D> VectorX pressure_load(const Body<D>& body, nurbs::Side side);

} // namespace signorini::solid
