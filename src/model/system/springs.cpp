#include "model/system/springs.hpp"

#include "solid/face_points.hpp"

namespace signorini::model {

template <int D> Springs<D>::Springs(const Scene<D>& scene, const Unknowns<D>& unknowns) {
  for (std::size_t s = 0; s < scene.supports.size(); ++s) {
    const Support<D>& support = scene.supports[s];
    for (const int obstacle : support.obstacles)
      for (int c = 0; c < D; ++c)
        if (const double k = support.obstacle_spring(c); k > 0)
          parts_.push_back({static_cast<int>(s), {unknowns.obstacle_offset(obstacle) + c}, MatrixX::Constant(1, 1, k)});
    for (const FaceReference& face : support.spring_faces) {
      const solid::Body<D>& body = *scene.bodies[face.body].body;
      const MatrixX points = body.space().points();
      for (const solid::FacePoints<D>& element : solid::face_points(body, face.side)) {
        const MatrixX x = points(Eigen::all, element.functions);
        const auto n = static_cast<Eigen::Index>(element.functions.size());
        MatrixX mass = MatrixX::Zero(n, n);
        for (int q = 0; q < element.weights.size(); ++q)
          mass += element.weight(x, q) * element.area_vector(x, q).norm() * element.values.col(q) *
                  element.values.col(q).transpose();
        for (int c = 0; c < D; ++c) {
          if (support.spring(c) == 0) continue;
          Part part{static_cast<int>(s), {}, support.spring(c) * mass};
          for (const int function : element.functions)
            part.dofs.push_back(unknowns.offset(face.body) + D * function + c);
          parts_.push_back(std::move(part));
        }
      }
    }
  }
}

template <int D> void Springs<D>::multiply(const VectorX& displacement, VectorX& force, int support) const {
  for (const Part& part : parts_)
    if (support < 0 || part.support == support) force(part.dofs) += part.stiffness * displacement(part.dofs);
}

template <int D> double Springs<D>::energy(const VectorX& displacement) const {
  double sum = 0;
  for (const Part& part : parts_) {
    const VectorX own = displacement(part.dofs);
    sum += 0.5 * own.dot(part.stiffness * own);
  }
  return sum;
}

template class Springs<2>;
template class Springs<3>;

} // namespace signorini::model
