#pragma once
// Dead loads: forces on a body's face whose size and direction follow the reference configuration.

#include "solid/body.hpp"

namespace signorini::solid {

/// f_A = ∫ R_A dA e_component over a face's reference area: the nodal forces of a unit traction. D values per control
/// point of the body; per unit depth in plane strain, over the full circle for a body of revolution.
/// Any side, whether layers cross it or not. Throws Error for a component that is not in 0 … D−1.
template <int D> VectorX traction_load(const Body<D>& body, nurbs::Side side, int component);

/// f_A = −∫ R_A N dA with the reference configuration's outward normal N: the nodal forces of a unit pressure, which
/// keeps its direction (dead load). Otherwise as traction_load().
template <int D> VectorX pressure_load(const Body<D>& body, nurbs::Side side);

} // namespace signorini::solid
