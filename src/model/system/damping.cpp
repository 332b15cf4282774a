#include "model/system/damping.hpp"

#include "model/constants.hpp"
#include "model/scene/turning.hpp"
#include "model/system/rigid_motions.hpp"
#include "model/system/springs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini::model {

namespace {

/// The smallest |gap| of a contact; 0 if it is closed.
template <int D> double nearest_gap(const contact::Formulation<D>& contact, const contact::History<D>& history) {
  if (resultant(history).active > 0) return 0;
  double distance = std::numeric_limits<double>::infinity();
  for (const double gap : contact::gaps(contact, history)) distance = std::min(distance, std::abs(gap));
  return distance;
}

} // namespace

template <int D> std::vector<std::vector<int>> connected_groups(const Scene<D>& scene) {
  std::vector<std::vector<int>> groups;
  for (int b = 0; b < std::ssize(scene.bodies); ++b) groups.push_back({b});
  const auto group_of = [&](int body) {
    return std::find_if(groups.begin(), groups.end(),
                        [&](const auto& group) { return std::find(group.begin(), group.end(), body) != group.end(); });
  };
  const auto connect = [&](int body, int other) {
    const auto first = group_of(body), second = group_of(other);
    if (first == second) return;
    first->insert(first->end(), second->begin(), second->end());
    groups.erase(second);
  };
  for (const Tie& tie : scene.ties)
    for (const Faces* faces : {&tie.slave, &tie.master})
      for (const FaceReference& face : *faces) connect(tie.slave.front().body, face.body);
  for (const Join& join : scene.joins) connect(join.first.body, join.second.body);
  return groups;
}

template <int D> MatrixX reference_points(const Scene<D>& scene, const std::vector<int>& bodies) {
  MatrixX points(D, 0);
  for (const int b : bodies) {
    const MatrixX own = scene.bodies[b].body->space().points();
    points.conservativeResize(D, points.cols() + own.cols());
    points.rightCols(own.cols()) = own;
  }
  return points;
}

template <int D>
std::vector<UnconstrainedMotion> unconstrained_motions(const Scene<D>& scene, const Unknowns<D>& unknowns) {
  const Springs<D> springs(scene, unknowns);
  std::vector<UnconstrainedMotion> unconstrained;
  for (const std::vector<int>& group : connected_groups(scene)) {
    for (const VectorX& motion : rigid_motions<D>(reference_points(scene, group), scene.kind)) {
      std::vector<UnconstrainedMotion> parts;
      bool free = true;
      for (Eigen::Index first = 0; const int b : group) {
        const VectorX own = motion.segment(first, D * scene.bodies[b].body->functions());
        for (Eigen::Index i = 0; i < own.size() && free; ++i)
          free = std::abs(own(i)) < 1e-12 || unknowns.unknown(unknowns.offset(b) + static_cast<int>(i)) >= 0;
        first += own.size();
        parts.push_back({b, own});
      }
      if (free && !springs.parts().empty()) {
        VectorX whole = VectorX::Zero(unknowns.dofs());
        for (const auto& [body, own] : parts) whole.segment(unknowns.offset(body), own.size()) = own;
        free = !(springs.energy(whole) > 0);
      }
      if (free) unconstrained.insert(unconstrained.end(), parts.begin(), parts.end());
    }
  }
  return unconstrained;
}

template <int D>
VectorX damping(const Scene<D>& scene, const Unknowns<D>& unknowns, const std::vector<UnconstrainedMotion>& motions,
                const VectorX& diagonal, const VectorX& force, const std::vector<double>& stride) {
  std::vector<double> factor(scene.bodies.size(), 0);
  for (const auto& [body, motion] : motions) {
    const int offset = unknowns.offset(body);
    double work = 0, stiffness = 0;
    for (Eigen::Index i = 0; i < motion.size(); ++i)
      if (const int unknown = unknowns.unknown(offset + static_cast<int>(i)); unknown >= 0) {
        work += force(offset + i) * motion(i);
        stiffness += diagonal(unknown) * motion(i) * motion(i);
      }
    factor[body] = std::max({factor[body], least_damping, std::abs(work) / (stride[body] * stiffness)});
  }
  VectorX shift = VectorX::Zero(unknowns.size());
  for (int b = 0; b < std::ssize(factor); ++b)
    for (int i = 0; i < D * scene.bodies[b].body->functions(); ++i)
      if (const int unknown = unknowns.unknown(unknowns.offset(b) + i); unknown >= 0)
        shift(unknown) = factor[b] * diagonal(unknown);
  return shift;
}

template <int D>
std::vector<double> strides(const Scene<D>& scene, const contact::Formulations<D>& contacts, const State<D>& state,
                            double small) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> nearest(scene.bodies.size(), infinity);
  const auto note = [&](int body, double distance) { nearest[body] = std::min(nearest[body], distance); };
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const double distance = nearest_gap(*contacts[k], state.contacts[k]);
    for (int b = 0; b < std::ssize(scene.bodies); ++b)
      if (acts_on(scene.contacts[k], b)) note(b, distance);
  }
  for (const std::vector<int>& group : connected_groups(scene)) {
    double least = infinity;
    for (const int b : group) least = std::min(least, nearest[b]);
    for (const int b : group) nearest[b] = least;
  }
  for (double& distance : nearest) distance = distance == infinity ? small : std::max(distance, small);
  return nearest;
}

template <int D>
std::vector<UnconstrainedObstacle> unconstrained_obstacles(const Scene<D>& scene, const Unknowns<D>& unknowns) {
  const Springs<D> springs(scene, unknowns);
  const auto held = [&](int dof) {
    return std::ranges::any_of(springs.parts(), [&](const auto& part) { return part.dofs.front() == dof; });
  };
  std::vector<UnconstrainedObstacle> motions;
  for (int k = 0; k < std::ssize(scene.obstacles); ++k)
    for (int dof = unknowns.obstacle_offset(k), end = dof + D; dof < end; ++dof)
      if (unknowns.unknown(dof) >= 0 && !held(dof)) motions.push_back({k, dof});
  for (const FreeAngle<D>& angle : unknowns.free_angles()) motions.push_back({angle.obstacle, angle.dof});
  return motions;
}

template <int D>
const std::string& support_of(const Scene<D>& scene, const Unknowns<D>& unknowns, const UnconstrainedObstacle& motion) {
  const int component = motion.dof - unknowns.obstacle_offset(motion.obstacle);
  return support_of(scene, motion.obstacle, component < D ? component_name(component) : "angle");
}

template <int D>
void damp_obstacles(const Scene<D>& scene, const Unknowns<D>& unknowns,
                    const std::vector<UnconstrainedObstacle>& motions, const VectorX& diagonal, const VectorX& force,
                    const contact::Formulations<D>& contacts, const State<D>& state, double small, VectorX& shift) {
  const double largest = diagonal.cwiseAbs().maxCoeff();
  for (const auto& [obstacle, dof] : motions) {
    double distance = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < contacts.size(); ++k)
      if (scene.contacts[k].master == std::variant<Faces, ObstacleReference>(ObstacleReference{obstacle}))
        distance = std::min(distance, nearest_gap(*contacts[k], state.contacts[k]));
    const double stride = std::isfinite(distance) ? std::max(distance, small) : small;
    shift(unknowns.unknown(dof)) += std::max(least_damping * largest, std::abs(force(dof)) / stride);
  }
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template std::vector<std::vector<int>> connected_groups(const Scene<D>&);                                            \
  template MatrixX reference_points(const Scene<D>&, const std::vector<int>&);                                         \
  template std::vector<UnconstrainedMotion> unconstrained_motions(const Scene<D>&, const Unknowns<D>&);                \
  template VectorX damping(const Scene<D>&, const Unknowns<D>&, const std::vector<UnconstrainedMotion>&,               \
                           const VectorX&, const VectorX&, const std::vector<double>&);                                \
  template std::vector<double> strides(const Scene<D>&, const contact::Formulations<D>&, const State<D>&, double);     \
  template std::vector<UnconstrainedObstacle> unconstrained_obstacles(const Scene<D>&, const Unknowns<D>&);            \
  template const std::string& support_of(const Scene<D>&, const Unknowns<D>&, const UnconstrainedObstacle&);           \
  template void damp_obstacles(const Scene<D>&, const Unknowns<D>&, const std::vector<UnconstrainedObstacle>&,         \
                               const VectorX&, const VectorX&, const contact::Formulations<D>&, const State<D>&,       \
                               double, VectorX&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::model
