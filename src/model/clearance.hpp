#pragma once
// Check of initial penetration: a contact algorithm cannot resolve bodies inside each other or inside an obstacle.

#include "model/scene.hpp"

namespace signorini::model {

/// Throws Error if a contact's slave face penetrates
///  - a deformable master by more than 20 % of the mean thickness of the thinner of the two bodies: the master is the
///    wrong face, or the bodies are misplaced;
///  - an obstacle by more than 1 % of the body's size or 20 % of its thickness;
/// or if a closed obstacle lies inside the slave's body, or the body behind a plane. Returns warnings about bodies that
/// overlap by more than 1 % of the thickness (an interference fit, or a mistake). `contacts` are those of the scene,
/// evaluated in the reference configuration.
template <int D>
std::vector<Message> check_clearance(const Scene<D>& scene, const std::vector<contact::History<D>>& contacts);

} // namespace signorini::model
