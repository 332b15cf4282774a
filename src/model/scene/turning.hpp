#pragma once
// Rotation of rigid obstacles by supports.

#include "contact/point/master.hpp"
#include "model/scene/scene.hpp"

#include <optional>

namespace signorini::model {

/// How a support turns an obstacle: by a driven angle, or by one that is an unknown.
template <int D> struct ObstacleTurn {
  int support; ///< index into Scene::supports
  contact::Turning<D> turning;
  Vec<D> axis; ///< unit vector (3D); unused in 2D
  bool free;
};

/// Empty for an obstacle that does not turn. Its arm is the largest distance of the shape from the axis; for shapes
/// without end that of the bodies.
template <int D> std::optional<ObstacleTurn<D>> turn_of(const Scene<D>& scene, int obstacle);

/// The support that holds or frees a component of an obstacle's translation: the one that names it or, since obstacles
/// are fixed where nothing moves them, the first of the obstacle. Null if it has none.
template <int D> const Support<D>* holder_of(const Scene<D>& scene, int obstacle, int component);

/// Name of the support that frees a component of an obstacle, or its "angle".
template <int D> const std::string& support_of(const Scene<D>& scene, int obstacle, const std::string& component);

} // namespace signorini::model
