#pragma once
// Annotations on top of pictures: markers (rings with crosses) with a short text, names of the parts of a shape, and
// arrows along its directions.

#include "base/eigen.hpp"
#include "view/frame.hpp"

namespace signorini::view {

struct PointMark {
  Vec<3> at; ///< in model units; z = 0 in the plane
  std::string text;
};

/// A mark in pixels.
struct PlacedMark {
  Vec2 at;
  std::string text;
  Vec2 beyond = {0, 0}; ///< from `at` to the true position if that is outside the picture
};

/// The marks within the box; `all`: those outside are moved to its edge, with an arrow to their position.
std::vector<PlacedMark> within(std::vector<PlacedMark> marks, const Box& box, bool all, const Style& style);

/// Draws marks on top of everything else, with texts within the box. Texts avoid markers and texts of earlier marks; a
/// line leads to their position. Texts without space nearby are omitted; later rings that would overlap an earlier one
/// become dots.
void draw_marks(Drawing& drawing, const std::vector<PlacedMark>& marks, const Box& box, const Style& style);

/// A short text on a light background.
struct Label {
  Vec<3> at = Vec<3>::Zero(); ///< in model units; z = 0 in the plane
  std::string text;
  Vec<3> shift = Vec<3>::Zero();  ///< direction on paper in which the text is shifted, of any length
  Vec<3> normal = Vec<3>::Zero(); ///< of a side, which is named only if it faces the eye; zero: always
};

/// An arrow along the one of several lines that starts nearest to the eye.
struct Arrow {
  std::vector<Eigen::Matrix<double, 3, Eigen::Dynamic>> lines;
  std::string text; ///< at its head
};

struct Names {
  std::vector<Label> labels;
  std::vector<Arrow> arrows;
};

/// Draws names on top of everything else if their positions are within the frame. `axes`: the picture's axes as rows.
void draw_names(Drawing& drawing, const Names& names, const Mat<3>& axes, const Frame& frame, const Style& style);

} // namespace signorini::view
