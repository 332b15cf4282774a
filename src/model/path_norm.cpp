#include "model/path_norm.hpp"

#include "base/index.hpp"

namespace signorini::model {

template <int D> VectorX path_weights(const Scene<D>& scene, const Unknowns<D>& unknowns) {
  VectorX weights = VectorX::Zero(unknowns.dofs());
  double volume = 0;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const solid::Body<D>& body = *scene.bodies[b].body;
    const int offset = unknowns.offset(static_cast<int>(b));
    for (int e = 0; e < body.elements(); ++e) {
      const MatrixX points = solid::element_quadrature(body.space(), e).points;
      for (int q = 0; q < points.cols(); ++q) {
        const nurbs::ElementBasis basis = body.space().basis(e, points.col(q));
        const double share = body.weights_of(e)[q];
        volume += share;
        for (std::size_t a = 0; a < basis.functions.size(); ++a)
          weights.template segment<D>(offset + D * basis.functions[a]).array() +=
              share * basis.values(static_cast<int>(a));
      }
    }
  }
  weights /= volume;
  for (int i = 0; i < D * static_cast<int>(scene.obstacles.size()); ++i) weights(unknowns.obstacle_offset(0) + i) = 1;
  return weights;
}

template VectorX path_weights<2>(const Scene<2>&, const Unknowns<2>&);
template VectorX path_weights<3>(const Scene<3>&, const Unknowns<3>&);

} // namespace signorini::model
