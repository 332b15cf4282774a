#pragma once
// Patches as pictures show them, before they are bodies of a model.

#include "nurbs/patch.hpp"
#include "view/solid_picture.hpp"

#include <variant>

namespace signorini::bind {

/// How patches shall be shown.
struct PatchShowing {
  bool mesh = true, control_points = false;
  bool names = true;                ///< faces and directions; of several patches their numbers as well
  std::vector<Window> windows = {}; ///< what is shown larger than the whole
};

/// Curves, surfaces and volumes; all in the plane, or all in space.
std::variant<view::Panel, view::SolidPanel> show(const std::vector<nurbs::Patch>& patches, const PatchShowing& showing);

} // namespace signorini::bind
