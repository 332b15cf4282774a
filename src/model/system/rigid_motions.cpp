#include "model/system/rigid_motions.hpp"

namespace signorini::model {

template <int D> std::vector<VectorX> rigid_motions(const MatrixX& points, solid::Kind kind) {
  const Eigen::Index n = points.cols();
  std::vector<VectorX> motions;
  for (int c = kind == solid::Kind::axisymmetric ? 1 : 0; c < D; ++c) {
    VectorX motion = VectorX::Zero(D * n);
    for (Eigen::Index a = 0; a < n; ++a) motion(D * a + c) = 1;
    motions.push_back(std::move(motion));
  }
  if (kind == solid::Kind::axisymmetric) return motions;
  const VectorX middle = points.rowwise().mean();
  for (int axis = D == 2 ? 2 : 0; axis < 3; ++axis) {
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    VectorX motion = VectorX::Zero(D * n);
    for (Eigen::Index a = 0; a < n; ++a) {
      motion(D * a + i) = -(points(j, a) - middle(j));
      motion(D * a + j) = points(i, a) - middle(i);
    }
    motions.push_back(motion / motion.cwiseAbs().maxCoeff());
  }
  return motions;
}

template std::vector<VectorX> rigid_motions<2>(const MatrixX&, solid::Kind);
template std::vector<VectorX> rigid_motions<3>(const MatrixX&, solid::Kind);

} // namespace signorini::model
