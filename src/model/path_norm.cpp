#include "model/path_norm.hpp"

#include "base/index.hpp"

namespace signorini::model {

template <int D> VectorX path_weights(const Scene<D>& scene, const Unknowns<D>& unknowns) {
  VectorX weights = VectorX::Zero(unknowns.dofs());
  double volume = 0;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const solid::Body<D>& body = *scene.bodies[b].body;
    const int offset = unknowns.offset(static_cast<int>(b));
    for (int a = 0; a < body.functions(); ++a)
      weights.template segment<D>(offset + D * a).setConstant(body.volumes()(a));
    volume += body.volumes().sum();
  }
  weights /= volume;
  for (int i = 0; i < D * static_cast<int>(scene.obstacles.size()); ++i) weights(unknowns.obstacle_offset(0) + i) = 1;
  return weights;
}

template VectorX path_weights<2>(const Scene<2>&, const Unknowns<2>&);
template VectorX path_weights<3>(const Scene<3>&, const Unknowns<3>&);

} // namespace signorini::model
