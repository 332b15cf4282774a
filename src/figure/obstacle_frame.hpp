#pragma once
// Drawings of rigid obstacles that have no form of their own in pictures.

#include "figure/moved_obstacle.hpp"
#include "view/panel.hpp"

namespace signorini::figure {

/// A disc, or a hollow one.
view::Outline circle_of(const contact::Ball<2>& disc, const std::vector<Window>& windows);

/// The connected parts of a moved level set within its box.
std::vector<view::Outline> outlines(const contact::LevelSet<2>& level_set, const Motion<2>& motion);
view::RigidSurface surface_of(const contact::LevelSet<3>& level_set, const Motion<3>& motion);

view::RigidSurface surface_of(const contact::Torus& torus);

} // namespace signorini::figure
