#pragma once
// Constants and contacts of a scene that are legal but hardly meant.

#include "model/scene.hpp"

namespace signorini::model {

/// A contact's penalty compared with the stiffness of an element behind its faces, E/h of the softest of its bodies.
struct PenaltyRatio {
  double ratio;     ///< ε_N h/E; 0 where there is no penalty
  double stiffness; ///< E/h
  std::string body;
};
template <int D>
PenaltyRatio penalty_ratio(const Scene<D>& scene, const Contact<D>& contact,
                           const contact::Formulation<D>& formulation);

/// Warnings of Poisson's ratios that lock, coefficients of friction that look like angles, penalties that are out
/// of range, and contacts that act twice between the same points. `contacts` are the scene's.
template <int D> std::vector<Message> scene_warnings(const Scene<D>& scene, const contact::Formulations<D>& contacts);

} // namespace signorini::model
