#pragma once
// The mass of all bodies.

#include "model/scene/scene.hpp"
#include "model/system/unknowns.hpp"
#include "solve/pattern.hpp"

namespace signorini::model {

/// The mass matrix of the unknowns, in the order of a tangent's pattern. Control points that share an unknown (joins,
/// seams, poles, rotating supports) add theirs. Multipliers and obstacles have none.
template <int D>
std::vector<double> mass_matrix(const Scene<D>& scene, const Unknowns<D>& unknowns, const solve::Pattern& pattern);

} // namespace signorini::model
