#include "model/system/path_norm.hpp"

#include "model/scene/turning.hpp"

namespace signorini::model {

template <int D> VectorX path_weights(const Scene<D>& scene, const Unknowns<D>& unknowns) {
  VectorX weights = VectorX::Zero(unknowns.dofs());
  double volume = 0;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const solid::Body<D>& body = *scene.bodies[b].body;
    const int offset = unknowns.offset(static_cast<int>(b));
    for (int a = 0; a < body.functions(); ++a)
      weights.template segment<D>(offset + D * a).setConstant(body.tables().volumes()(a));
    volume += body.tables().volumes().sum();
  }
  weights /= volume;
  for (int k = 0; k < std::ssize(scene.obstacles); ++k) {
    const int first = unknowns.obstacle_offset(k);
    weights.template segment<D>(first).setOnes();
    // Two markers move by L dθ each, those of a free angle with s = L θ.
    if (const auto turn = turn_of(scene, k)) weights.segment(first + D, D * D).setConstant(turn->free ? 0 : 0.5);
  }
  for (const FreeAngle<D>& angle : unknowns.free_angles()) weights(angle.dof) = 1;
  return weights;
}

template VectorX path_weights<2>(const Scene<2>&, const Unknowns<2>&);
template VectorX path_weights<3>(const Scene<3>&, const Unknowns<3>&);

} // namespace signorini::model
