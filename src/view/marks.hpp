#pragma once
// What stands on top of pictures: markers, that is rings with crosses, at places worth a look with a few words beside
// each; names on the parts of a shape, and arrows along its directions.

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

/// A short text on a light ground.
struct Label {
  Vec<3> at = Vec<3>::Zero(); ///< in model units; z = 0 in the plane
  std::string text;
  Vec<3> shift = Vec<3>::Zero();  ///< the way that the text stands off its place on paper, of any length
  Vec<3> normal = Vec<3>::Zero(); ///< of a side: it is named where it faces the eye only; zero: everywhere
};

/// An arrow along one of several lines: along that which begins nearest to the eye.
struct Arrow {
  std::vector<Eigen::Matrix<double, 3, Eigen::Dynamic>> lines;
  std::string text; ///< at its head
};

struct Names {
  std::vector<Label> labels;
  std::vector<Arrow> arrows;
};

/// Draws them on top of all that is there, as far as their places are within the frame. `axes`: the picture's own, as
/// rows.
void draw_names(Drawing& drawing, const Names& names, const Mat<3>& axes, const Frame& frame, const Style& style);

} // namespace signorini::view
