#pragma once
// Damping of unconstrained bodies and obstacles, which are supported by contact only: keeps the tangent regular and
// limits their motion until they touch.

#include "model/scene/scene.hpp"
#include "model/system/state.hpp"
#include "model/system/unknowns.hpp"

namespace signorini::model {

/// The bodies of a scene, those together that joins or ties connect.
template <int D> std::vector<std::vector<int>> connected_groups(const Scene<D>& scene);

/// The control points of some bodies before the first step, one body after the other.
template <int D> MatrixX reference_points(const Scene<D>& scene, const std::vector<int>& bodies);

/// A rigid-body mode that no support prevents: a translation or rotation of the reference configuration (of a body of
/// revolution the translation along the axis) without prescribed degrees of freedom; the largest component is at
/// most 1. Tied bodies move as one, and each has its part of the motion.
struct UnconstrainedMotion {
  int body;
  VectorX motion; ///< of the body's degrees of freedom
};
template <int D>
std::vector<UnconstrainedMotion> unconstrained_motions(const Scene<D>& scene, const Unknowns<D>& unknowns);

/// Shift of the tangent's diagonal, by unknown: α_b K_ii at the unknowns of every body b with unconstrained rigid-body
/// modes m, so that the residual force f moves none of them farther than `stride`,
///     α_b = max_m |f·m| / (stride Σ K_ii m_i²).
/// It changes the iteration, not the converged state, and vanishes on convergence (proximal point iteration with
/// switched evolution relaxation: C. T. Kelley, D. E. Keyes, SIAM J. Numer. Anal. 35, 1998). `diagonal` is K_ii by
/// unknown, `force` by degree of freedom, `stride` by body.
template <int D>
VectorX damping(const Scene<D>& scene, const Unknowns<D>& unknowns, const std::vector<UnconstrainedMotion>& motions,
                const VectorX& diagonal, const VectorX& force, const std::vector<double>& stride);

/// Largest motion of each body in one iteration: the smallest gap of the contacts of its tied bodies, at least `small`;
/// `small` if any of them is closed.
template <int D>
std::vector<double> strides(const Scene<D>& scene, const contact::Formulations<D>& contacts, const State<D>& state,
                            double small);

/// A component of an obstacle's translation, or its angle, that is an unknown without a spring.
struct UnconstrainedObstacle {
  int obstacle;
  int dof;
};
template <int D>
std::vector<UnconstrainedObstacle> unconstrained_obstacles(const Scene<D>& scene, const Unknowns<D>& unknowns);
/// Name of the support that frees it.
template <int D>
const std::string& support_of(const Scene<D>& scene, const Unknowns<D>& unknowns, const UnconstrainedObstacle& motion);

/// Adds the shift of the diagonal at their unknowns, by which the residual force moves none of them farther than the
/// smallest gap of its contacts, or `small`, as for bodies: |f| / stride.
template <int D>
void damp_obstacles(const Scene<D>& scene, const Unknowns<D>& unknowns,
                    const std::vector<UnconstrainedObstacle>& motions, const VectorX& diagonal, const VectorX& force,
                    const contact::Formulations<D>& contacts, const State<D>& state, double small, VectorX& shift);

} // namespace signorini::model
