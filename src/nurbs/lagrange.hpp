#pragma once
// C⁰ Lagrange elements of a patch [theory 4.8]: the geometry is interpolated, hence approximate where it is curved.

#include "nurbs/patch.hpp"

#include <vector>

namespace signorini::nurbs {

/// The C⁰ piecewise polynomial patch (weights 1, interior knots repeated degree times) that takes the patch's values at
/// degree+1 equidistant parameters per span in every direction, ends included. `breaks` are the distinct knots per
/// direction. Spans the same space as Lagrange elements; control points are Bernstein coefficients.
Patch interpolate_lagrange(const Patch& patch, const std::vector<int>& degrees,
                           const std::vector<std::vector<double>>& breaks);

} // namespace signorini::nurbs
