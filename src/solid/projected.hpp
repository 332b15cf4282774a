#pragma once
// Force, tangent and deformation of bodies with projected volume change (projection.hpp).

#include "solid/internal.hpp"

namespace signorini::solid {

/// The kernels of its elements, for stress and moduli that projected_force() gives them.
template <int D> Kernels projected_kernels();

/// internal_force() of macro-element m, with `before` only where its volume change is predicted.
template <int D>
std::optional<Inversion> projected_force(const Body<D>& body, int m, const double* displacement,
                                         ElementArrays<D>& arrays, bool tangent, const Memory& memory,
                                         const double* before);

/// visit_points() of macro-element m.
template <int D> bool visit_projected(const Body<D>& body, int m, const double* displacement, const VisitPoint& visit);

} // namespace signorini::solid
