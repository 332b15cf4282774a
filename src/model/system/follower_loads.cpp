#include "model/system/follower_loads.hpp"

#include "solid/load.hpp"

#include <Eigen/SparseCore>

#include <cmath>
#include <set>

namespace signorini::model {

template <int D>
FollowerLoads<D>::FollowerLoads(const Scene<D>& scene, const Unknowns<D>& unknowns, const Drives<D>& drives)
    : unknowns_(unknowns) {
  for (const Drive& drive : drives.all()) {
    if (drive.load < 0) continue;
    const Load& load = scene.loads[drive.load];
    if (load.kind != LoadKind::follower_pressure) continue;
    Eigen::Index used = 0; // of a function's values
    for (const FaceReference& face : load.on) {
      const solid::Body<D>& body = *scene.bodies[face.body].body;
      const MatrixX points = body.space().points();
      for (solid::FacePoints<D>& element : solid::face_points(body, face.side)) {
        Part part{std::move(element), {}, {}, drive.first};
        if (!load.values.empty()) {
          VectorX& weights = part.points.weights;
          weights.array() *= Eigen::Map<const VectorX>(load.values.data() + used, weights.size()).array();
          used += weights.size();
        }
        part.reference = points(Eigen::all, part.points.functions);
        for (const int function : part.points.functions)
          for (int c = 0; c < D; ++c) part.dofs.push_back(unknowns.offset(face.body) + D * function + c);
        parts_.push_back(std::move(part));
      }
    }
  }
}

template <int D> MatrixX FollowerLoads<D>::positions(const Part& part, const VectorX& displacement) const {
  MatrixX x = part.reference;
  x.reshaped() += displacement(part.dofs);
  return x;
}

template <int D>
void FollowerLoads<D>::add_force(const VectorX& displacement, const VectorX& targets, VectorX& force) const {
  for (const Part& part : parts_) {
    const MatrixX own = targets(part.target) * solid::follower_load(part.points, positions(part, displacement));
    force(part.dofs) += own.reshaped();
  }
}

template <int D>
MatrixX FollowerLoads<D>::tangent(const Part& part, const VectorX& displacement, const VectorX& targets) const {
  return targets(part.target) * solid::follower_tangent(part.points, positions(part, displacement));
}

template <int D> bool FollowerLoads<D>::conservative() const {
  // Errors of the quadrature of rational faces are below this fraction; a free border contributes a fraction of about
  // the number of its elements over that of the face's.
  constexpr double same = 1e-6;
  double size = 0;
  std::set<int> targets;
  for (const Part& part : parts_) {
    size = std::max(size, part.reference.cwiseAbs().maxCoeff());
    targets.insert(part.target);
  }
  // A state without any symmetry of its own
  VectorX motion(unknowns_.size());
  for (Eigen::Index i = 0; i < motion.size(); ++i) motion(i) = 0.01 * size * std::sin(static_cast<double>(i));
  const VectorX displacement = unknowns_.spread(motion);
  for (const int target : targets) {
    std::vector<Eigen::Triplet<double>> entries;
    for (const Part& part : parts_) {
      if (part.target != target) continue;
      const MatrixX own = solid::follower_tangent(part.points, positions(part, displacement));
      for (std::size_t i = 0; i < part.dofs.size(); ++i)
        for (std::size_t j = 0; j < part.dofs.size(); ++j) {
          const int row = unknowns_.unknown(part.dofs[i]), column = unknowns_.unknown(part.dofs[j]);
          if (row >= 0 && column >= 0) entries.emplace_back(row, column, own(static_cast<int>(i), static_cast<int>(j)));
        }
    }
    Eigen::SparseMatrix<double> tangent(unknowns_.size(), unknowns_.size());
    tangent.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SparseMatrix<double> transposed = tangent.transpose();
    if ((tangent - transposed).norm() > same * tangent.norm()) return false;
  }
  return true;
}

template class FollowerLoads<2>;
template class FollowerLoads<3>;

} // namespace signorini::model
