#pragma once
// What a state says: forces, moments, energies.

#include "model/model.hpp"

namespace signorini::model {

/// Present displacement of a body's control points, D × functions.
template <int D>
Eigen::Map<const Eigen::Matrix<double, D, Eigen::Dynamic>> body_displacement(const Model<D>& model, int body);
/// Force that a support exerts on its bodies and obstacles.
template <int D> Vec<D> reaction(const Model<D>& model, int support);
/// Moment that a support that rotates exerts, about its center and conjugate to its angle in radians.
template <int D> double moment(const Model<D>& model, int support);
/// Force of a load.
template <int D> Vec<D> load_resultant(const Model<D>& model, int load);

/// Energies of a state and what led to it. While friction slips at μ t_N and steps are small,
///   work = stored + contact + friction + what acted at the start,
/// but for ∫∫ ε_N g²/2 ȧ, since tractions act per current area.
struct Energies {
  double stored;   ///< in the bodies
  double contact;  ///< in the springs of penalty laws, in adhesion (none far away)
  double friction; ///< dissipated in all accepted steps
  double work;     ///< of supports and loads in all accepted steps, by the trapezoidal rule
};
/// Of the present state, with friction and work up to the accepted one.
template <int D> Energies energies(const Model<D>& model);

/// What may be wrong with the scene and, of linear elastic bodies that are turned inside out, with the present state,
/// those about the scene first.
template <int D> std::vector<Message> warnings(const Model<D>& model);

/// Seconds that the contacts' search has taken, summed over threads; part of Timings::contact where there is one.
template <int D> double search_seconds(const Model<D>& model);
/// Bytes of the bodies' tables and of the tangent with its patterns; the factors are in LinearSolution::statistics().
template <int D> double memory(const Model<D>& model);

} // namespace signorini::model
