#pragma once
// The points that supports constrain.

#include "base/groups.hpp"
#include "model/scene/scene.hpp"

namespace signorini::model {

/// By support: the points on which it acts, sorted: control points counted through all bodies, with those that share
/// their unknowns (`shared`: coincident_points()), then obstacles, counted on.
template <int D> std::vector<std::vector<int>> supported_points(const Scene<D>& scene, const Groups& shared);

/// True if a support constrains a component of the points on which it acts, or frees that of obstacles: control points
/// that no support constrains are free, obstacles fixed.
template <int D> bool constrains(const Support<D>& support, int component, bool obstacle);

} // namespace signorini::model
