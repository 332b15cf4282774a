#include "model/stability/rigid_modes.hpp"

#include "base/orthonormal.hpp"
#include "model/system/damping.hpp"
#include "model/system/rigid_motions.hpp"
#include "solve/eigenpairs.hpp"

#include <cmath>

namespace signorini::model {

namespace {

struct RigidMode {
  VectorX motion; ///< by unknown
  Message name;
};

/// The rigid motions of bodies that supports admit.
template <int D> std::vector<RigidMode> rigid_modes(Model<D>& model) {
  System<D>& system = model.system;
  const Unknowns<D>& unknowns = system.unknowns;
  std::vector<RigidMode> list;
  for (const std::vector<int>& group : connected_groups(system.scene)) {
    MatrixX points = reference_points(system.scene, group);
    std::vector<std::string> names;
    Eigen::Index first = 0;
    for (const int b : group) {
      const auto moves = unknowns.of_body(b, model.accepted.displacement);
      points.middleCols(first, moves.cols()) += moves;
      first += moves.cols();
      names.push_back(system.scene.bodies[b].name);
    }
    const std::vector<VectorX> motions = rigid_motions<D>(points, system.scene.kind);
    const int translations = system.scene.kind == solid::Kind::axisymmetric ? 1 : D;
    for (int m = 0; m < std::ssize(motions); ++m) {
      VectorX all = VectorX::Zero(unknowns.dofs());
      first = 0;
      for (const int b : group) {
        const Eigen::Index size = D * system.scene.bodies[b].body->functions();
        all.segment(unknowns.offset(b), size) = motions[m].segment(first, size);
        first += size;
      }
      VectorX motion = VectorX::Zero(unknowns.size());
      for (int dof = 0; dof < unknowns.displacements(); ++dof)
        if (const int i = unknowns.unknown(dof); i >= 0) motion(i) = all(dof);
      constexpr double rounding = 1e-12;
      if ((unknowns.spread(motion) - all).norm() > rounding * all.norm()) continue; // a support prevents it
      const bool turns = m >= translations;
      const int axis = turns && D == 2 ? 2 : turns ? m - translations : D - translations + m;
      list.push_back({std::move(motion), Message(turns ? "model.mode.rotation" : "model.mode.translation",
                                                 {{"bodies", names}, {"axis", component_name(axis)}})});
    }
  }
  return list;
}

} // namespace

template <int D> std::vector<Message> name_rigid_modes(Model<D>& model, const Eigenproblem& problem, MatrixX& neutral) {
  constexpr double contained = 1 - 1e-6; // squared share of a motion in the space of those without stiffness
  std::vector<Message> names;
  const MatrixX modes = neutral, mass_times_modes = times(problem.pattern, problem.mass, modes);
  MatrixX found(modes.cols(), modes.cols()); // by coefficients of modes
  for (const auto& [motion, name] : rigid_modes(model)) {
    const double size = std::sqrt(motion.dot(times(problem.pattern, problem.mass, motion).col(0)));
    const VectorX share = mass_times_modes.transpose() * motion / size;
    const auto count = std::ssize(names);
    if (count == modes.cols() || share.squaredNorm() < contained) continue;
    neutral.col(count) = motion / size;
    found.col(count) = share;
    names.push_back(name);
  }
  // What is left of the space, orthogonal to the rigid motions: the eigenvectors with 1 of its projector
  const auto count = std::ssize(names), rest = modes.cols() - count;
  if (rest == 0) return names;
  const MatrixX q = orthonormal(found.leftCols(count));
  const MatrixX projector = MatrixX::Identity(modes.cols(), modes.cols()) - q * q.transpose();
  neutral.rightCols(rest) = modes * solve::symmetric_eigenpairs(projector).vectors.rightCols(rest);
  names.resize(static_cast<std::size_t>(modes.cols()));
  return names;
}

template std::vector<Message> name_rigid_modes(Model<2>&, const Eigenproblem&, MatrixX&);
template std::vector<Message> name_rigid_modes(Model<3>&, const Eigenproblem&, MatrixX&);

} // namespace signorini::model
