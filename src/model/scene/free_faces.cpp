#include "model/scene/free_faces.hpp"

#include "base/dense.hpp"
#include "nurbs/coincident.hpp"
#include "nurbs/constants.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace signorini::model {

namespace {

/// Control points of a face in the reference configuration.
template <int D> MatrixX face_points(const Scene<D>& scene, const FaceReference& face) {
  const nurbs::Discretization& space = scene.bodies[face.body].body->space();
  return space.points()(Eigen::all, space.face_functions(face.side));
}

} // namespace

template <int D> bool is_collapsed(const Scene<D>& scene, const FaceReference& face) {
  const MatrixX all = scene.bodies[face.body].body->space().points(), points = face_points(scene, face);
  const MatrixX arms = points.colwise() - points.rowwise().mean().eval();
  const double size = (all.rowwise().maxCoeff() - all.rowwise().minCoeff()).norm();
  const VectorX squares = dense::symmetric_eigenvalues(arms * arms.transpose());
  return squares(1) <= std::pow(nurbs::same_place * size, 2); // of the D − 1 largest ones the least
}

template <int D> Faces free_faces(const Scene<D>& scene) {
  Faces inside;
  for (const Join& join : scene.joins) inside.insert(inside.end(), {join.first, join.second});
  for (const Tie& tie : scene.ties)
    for (const FaceReference& face : faces_of(tie)) inside.push_back(face);
  Faces faces;
  for (int body = 0; body < std::ssize(scene.bodies); ++body) {
    const nurbs::Discretization& space = scene.bodies[body].body->space();
    const double size = space.points().cwiseAbs().maxCoeff();
    const std::vector<int> closed = nurbs::closed_directions(space);
    for (const nurbs::Side side : nurbs::sides(D)) {
      const FaceReference face{body, side};
      const bool on_axis = scene.kind == solid::Kind::axisymmetric &&
                           face_points(scene, face).row(0).cwiseAbs().maxCoeff() <= nurbs::same_place * size;
      const bool seam = std::ranges::find(closed, side.direction) != closed.end();
      if (!inside.contains(face) && !on_axis && !seam && !is_collapsed(scene, face)) faces.push_back(face);
    }
  }
  return faces;
}

template <int D> Contact<D> with_obstacle(const Scene<D>& scene, Contact<D> set, int obstacle) {
  const auto support = std::ranges::find_if(scene.supports, [&](const auto& one) { return one.acts_on(obstacle); });
  set.name = support == scene.supports.end() ? "obstacle" + std::to_string(obstacle + 1) : support->name;
  set.master = ObstacleReference{obstacle};
  set.method.pass = contact::Pass::full;
  return set;
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template bool is_collapsed(const Scene<D>&, const FaceReference&);                                                   \
  template Faces free_faces(const Scene<D>&);                                                                          \
  template Contact<D> with_obstacle(const Scene<D>&, Contact<D>, int);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::model
