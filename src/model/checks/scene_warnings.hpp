#pragma once
// Warnings about valid but suspicious constants and contacts of a scene.

#include "model/scene/scene.hpp"

namespace signorini::model {

/// A contact's penalty compared with the stiffness of an element behind its faces, E/h of the softest of its bodies.
struct PenaltyRatio {
  double ratio;     ///< ε_N h/E; 0 without penalty
  double stiffness; ///< E/h
  std::string body;
};
template <int D> PenaltyRatio penalty_ratio(const Scene<D>& scene, const Contact<D>& contact, double penalty);

/// Warnings about a coefficient of friction that looks like an angle, and an offset that is large against the bodies.
template <int D>
std::vector<Message> constant_warnings(const Scene<D>& scene, const Contact<D>& contact, double mu, double offset);

/// Warnings about Poisson's ratios that cause locking, coefficients of friction that look like angles, penalty
/// parameters out of range, large offsets, and duplicate contacts between the same points. `contacts` and `histories`
/// are those of the scene at the start.
template <int D>
std::vector<Message> scene_warnings(const Scene<D>& scene, const contact::Formulations<D>& contacts,
                                    const std::vector<contact::History<D>>& histories);

/// The warning about a load whose function varies too much between its Gauss points: the error of its resultant. Empty
/// for small errors. `load`: its name in messages.
Message function_warning(const std::string& load, double error);

} // namespace signorini::model
