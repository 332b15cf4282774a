#include "model/scene/turning.hpp"

#include <algorithm>
#include <type_traits>

namespace signorini::model {

namespace {

/// Distance of points from a center, in 3D from the axis through it.
template <int D> double reach_from(const MatrixX& points, const Vec<D>& center, const Vec<D>& axis) {
  MatrixX arms = points.colwise() - center;
  if constexpr (D == 3) arms -= axis * (axis.transpose() * arms).eval();
  return arms.colwise().norm().maxCoeff();
}

template <int D> double arm_of(const Scene<D>& scene, int obstacle, const Vec<D>& center, const Vec<D>& axis) {
  const auto extent = [&](const auto& shape) {
    using Shape = std::decay_t<decltype(shape)>;
    if constexpr (std::is_same_v<Shape, contact::Ball<D>>)
      return reach_from<D>(shape.center, center, axis) + shape.radius;
    else if constexpr (std::is_same_v<Shape, contact::Cylinder>)
      return reach_from<D>(shape.point, center, axis) + shape.radius;
    else if constexpr (std::is_same_v<Shape, contact::Torus>)
      return reach_from<D>(shape.center, center, axis) + shape.ring + shape.radius;
    else if constexpr (std::is_same_v<Shape, nurbs::Patch>)
      return reach_from<D>(shape.points(), center, axis);
    else if constexpr (std::is_same_v<Shape, contact::LevelSet<D>>)
      return reach_from<D>(shape.compiled->mesh.points, center, axis);
    else
      return 0.0;
  };
  if (const double arm = std::visit(extent, scene.obstacles[obstacle]); arm > 0) return arm;
  double largest = 0;
  for (const auto& named : scene.bodies)
    largest = std::max(largest, reach_from<D>(named.body->space().points(), center, axis));
  return largest;
}

} // namespace

template <int D> std::optional<ObstacleTurn<D>> turn_of(const Scene<D>& scene, int obstacle) {
  for (int s = 0; s < std::ssize(scene.supports); ++s) {
    const Support<D>& support = scene.supports[s];
    if (!support.rotates || !support.acts_on(obstacle)) continue;
    const double arm = arm_of(scene, obstacle, support.center, support.axis);
    return ObstacleTurn<D>{s, {support.center, arm}, support.axis, support.free_angle};
  }
  return std::nullopt;
}

template <int D> const Support<D>* holder_of(const Scene<D>& scene, int obstacle, int component) {
  const auto names = [&](const Support<D>& support) {
    return support.acts_on(obstacle) && (support.constraint[component] != Constraint::free || support.freed[component]);
  };
  const auto acts = [&](const Support<D>& support) { return support.acts_on(obstacle); };
  auto found = std::ranges::find_if(scene.supports, names);
  if (found == scene.supports.end()) found = std::ranges::find_if(scene.supports, acts);
  return found == scene.supports.end() ? nullptr : &*found;
}

template <int D> const std::string& support_of(const Scene<D>& scene, int obstacle, const std::string& component) {
  const auto frees = [&](const Support<D>& support) {
    return support.acts_on(obstacle) &&
           (component == "angle" ? support.free_angle : support.freed[component.front() - 'x']);
  };
  return std::ranges::find_if(scene.supports, frees)->name;
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template std::optional<ObstacleTurn<D>> turn_of(const Scene<D>&, int);                                               \
  template const Support<D>* holder_of(const Scene<D>&, int, int);                                                     \
  template const std::string& support_of(const Scene<D>&, int, const std::string&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::model
