#pragma once
// Results of a state: forces, moments, energies.

#include "model/steps/model.hpp"

namespace signorini::model {

/// Present displacement of a body's control points, D × functions.
template <int D>
Eigen::Map<const Eigen::Matrix<double, D, Eigen::Dynamic>> body_displacement(const Model<D>& model, int body);
/// Force that a support exerts on its bodies and obstacles.
template <int D> Vec<D> reaction(const Model<D>& model, int support);
/// Moment of a rotating support about its center, conjugate to its angle in radians.
template <int D> double moment(const Model<D>& model, int support);
/// Unknown motions of a support's obstacles: components of their translations, by name, and their angle in degrees.
template <int D> std::vector<std::pair<std::string, double>> free_motion(const Model<D>& model, int support);
/// Force of a load.
template <int D> Vec<D> load_resultant(const Model<D>& model, int load);

/// Energies of a state and of the path to it. In the limit of small steps, with friction and a little penetration,
///   work + growth = stored + contact + friction + debonding − initial energy.
struct Energies {
  double stored;        ///< in the bodies, and in the springs of supports
  double contact;       ///< in penalty springs and bonds, and in adhesion (zero at infinite distance)
  double friction;      ///< dissipated in all accepted steps
  double work;          ///< of supports, loads and offsets in all accepted steps, by the trapezoidal rule
  double debonding = 0; ///< dissipated by bonds in all accepted steps
  double growth = 0; ///< ∫∫ φ dA in all accepted steps, see contact::History; zero if tractions act per reference area
  double viscous = 0; ///< work of the stresses that relax, in all accepted steps
  double wear = 0;    ///< energy that wear has taken along in all accepted steps
};
/// Energies of the present state, with friction and work up to the accepted one.
template <int D> Energies energies(const Model<D>& model);

/// ‖f + f₂‖ / max(‖f‖, ‖f₂‖) of the forces of a half pass and of the other one, 0 without forces: by how much action
/// and reaction differ.
template <int D> double imbalance(const Model<D>& model, int pass);

/// Seconds of the contacts' search, summed over threads; with one thread a part of Timings::contact.
template <int D> double search_seconds(const Model<D>& model);
/// Bytes of the bodies' tables and of the tangent with its patterns; for factors see LinearSolution::statistics().
template <int D> double memory(const Model<D>& model);

} // namespace signorini::model
