#pragma once
// Check of initial penetration: a contact algorithm cannot resolve bodies inside each other or inside an obstacle.

#include "model/system/system.hpp"

namespace signorini::model {

/// Throws Error if a contact's slave face penetrates
///  - a deformable master by more than 20 % of the mean thickness of the thinner of the two bodies: the master is the
///    wrong face, or the bodies are misplaced;
///  - an obstacle by more than 1 % of the body's size or 20 % of its thickness;
///  - either one by more than 90 % of the thickness, if the contact is an interference fit;
/// or if a closed obstacle lies inside the slave's body, or the body behind a plane, or behind a curve or surface where
/// it is closest to it. Returns warnings about overlaps whose closing strains a body by more than `meant_strain`
/// unless a body is free to move out. Contacts that are not active at the start are not checked, and the gap by a
/// negative offset is not an overlap. The histories are those of the scene's contacts, evaluated in the reference
/// configuration.
template <int D>
std::vector<Message> check_clearance(System<D>& system, const std::vector<contact::History<D>>& histories);

} // namespace signorini::model
