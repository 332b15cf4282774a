#pragma once
// Damping of bodies that nothing but contact holds: it keeps the tangent regular and their motion short until they
// touch.

#include "model/scene.hpp"
#include "model/state.hpp"
#include "model/unknowns.hpp"

namespace signorini::model {

/// Rigid motions that no support stops: for each body its translations and rotations (in a body of revolution the
/// translation along the axis) in which no held degree of freedom takes part. Motions of the reference configuration,
/// one unit of length at most.
struct LooseMotion {
  int body;
  VectorX motion; ///< of the body's degrees of freedom
};
template <int D> std::vector<LooseMotion> loose_motions(const Scene<D>& scene, const Unknowns<D>& unknowns);

/// What to add to the diagonal of the tangent, by unknown: α_b K_ii at the unknowns of every body b with loose motions
/// m, so that the force f that they are left with moves none of them farther than `stride`,
///     α_b = max_m |f·m| / (stride Σ K_ii m_i²).
/// It acts on the iteration alone, not on the state that it leads to, and fades as that comes near (proximal point
/// iteration with switched evolution relaxation: C. T. Kelley, D. E. Keyes, SIAM J. Numer. Anal. 35, 1998). `diagonal`
/// is K_ii by unknown, `force` by degree of freedom; `stride` by body.
template <int D>
VectorX damping(const Scene<D>& scene, const Unknowns<D>& unknowns, const std::vector<LooseMotion>& motions,
                const VectorX& diagonal, const VectorX& force, const std::vector<double>& stride);

/// How far each body may go in one iteration: as far as the nearest point of what it may touch while it touches
/// nothing, else `small`.
template <int D>
std::vector<double> strides(const Scene<D>& scene, const contact::Formulations<D>& contacts, const State<D>& state,
                            double small);

} // namespace signorini::model
