#pragma once
// The volume change that the last Newton correction predicts, for the tangent of nearly incompressible bodies.

#include "solid/body.hpp"

namespace signorini::solid {

/// True if the tangent of a body takes the predicted volume change: Poisson's ratio is above 0.4, and its law neither
/// linear nor that of plane stress, whose volume is free.
template <int D> bool predicts_volume(const Body<D>& body);

/// Writes what was predicted for ln J at the Gauss points of element e, less ln J: tr G − ln det(I + G) with
/// G = F₀⁻¹ (F − F₀), where F and F₀ are those of `displacement` and `before`, of the whole body [theory 2.10].
/// `moves`: work array of 2 D values per function.
template <int D>
void write_predicted(const Body<D>& body, int e, const double* displacement, const double* before,
                     std::vector<double>& moves, double* predicted);

} // namespace signorini::solid
