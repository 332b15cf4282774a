#pragma once
// Markers on pictures: rings with crosses at places worth a look, and a few words beside each.

#include "base/eigen.hpp"
#include "view/frame.hpp"

namespace signorini::view {

struct PointMark {
  Vec<3> at; ///< in model units; z = 0 in the plane
  std::string text;
};

/// A mark in pixels of the picture.
struct PlacedMark {
  Vec2 at;
  std::string text;
  Vec2 beyond = {0, 0}; ///< from `at` to the true place where that is outside the picture
};

/// Those within the box; `all`: those beyond come to its rim, with an arrow to where they belong.
std::vector<PlacedMark> within(std::vector<PlacedMark> marks, const Box& box, bool all, const Style& style);

/// Draws the marks on top of all that is there, the texts within the box. Texts give way to markers and to those of
/// earlier marks; a line then leads to their place. One for which no room is left near its place is left out; where
/// rings would lie on each other the later ones are dots.
void draw_marks(Drawing& drawing, const std::vector<PlacedMark>& marks, const Box& box, const Style& style);

} // namespace signorini::view
