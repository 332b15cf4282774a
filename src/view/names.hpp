#pragma once
// Names on the parts of a shape, and arrows along its directions.

#include "base/eigen.hpp"
#include "view/frame.hpp"

namespace signorini::view {

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
