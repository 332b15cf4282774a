#pragma once
// Force, tangent and energy of bodies with projected volume change (projection.hpp).

#include "solid/internal.hpp"

namespace signorini::solid {

/// The kernels of its elements, for stress and moduli that projected_force() gives them.
template <int D> Kernels projected_kernels();

/// internal_force() of macro-element m, with `before` only where its volume change is predicted.
template <int D>
std::optional<Inversion> projected_force(const Body<D>& body, int m, const double* displacement,
                                         ElementArrays<D>& arrays, bool tangent, std::span<const double> committed,
                                         std::span<double> trial, const double* before);

/// stored_energy() of macro-element m.
template <int D>
double projected_energy(const Body<D>& body, int m, const double* displacement, std::span<const double> committed);

} // namespace signorini::solid
