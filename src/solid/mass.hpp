#pragma once
// The mass of a body by pairs of functions.

#include "solid/body.hpp"

namespace signorini::solid {

/// m_AB = ∫ ρ R_A R_B dV over element e, for the pairs of its functions [theory 2.11]: one block for all components,
/// since each is accelerated by its own displacement only. By the body's Gauss points, which in a body of revolution
/// have the circumference in their weights.
template <int D> MatrixX element_mass(const Body<D>& body, int e);

} // namespace signorini::solid
