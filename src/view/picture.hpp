#pragma once
// Pictures of bodies: colored, tessellated geometry with mesh lines, drawn off-screen. Knows arrays, no models. Solids
// are lit, cut open where asked, and seen in parallel projection.

#include "view/camera.hpp"
#include "view/figure.hpp"
#include "view/surface_lines.hpp"

namespace signorini::view {

/// What a color bar shows.
struct Bar {
  std::array<double, 2> range;
  std::string title;
};

struct PictureOptions {
  std::string title;
  std::string field_label;                    ///< title of the color bar, with unit when known
  std::optional<std::array<double, 2>> range; ///< color range; the values' own when absent
  std::string colormap = "viridis";
  std::array<int, 2> size = {1600, 1000}; ///< pixels
  bool trim = false;                      ///< `size` is the most; the picture is cut down to what is drawn
  /// Where solids are seen from, all states alike; plane models when absent.
  std::optional<Camera> camera;
  /// The part that is shown; z = 0 in the plane. In space the picture ends where the box seen from the camera ends.
  std::optional<Bounds> crop;
  bool transparent = false; ///< no ground; else white
  bool bar = true;          ///< draw the color bar
  /// Shown of each state at least, in model units on paper: pictures of a series get one scale.
  std::optional<Box> extent;
  std::optional<int> columns;         ///< of a sheet; the number that shows the states largest when absent
  std::optional<Style> style;         ///< of texts and lines; that of the size when absent
  std::vector<Bar> bars_beside;       ///< of pictures that stand beside this one: each has room for the largest bar
  bool axis_names = true;             ///< beside the numbers, or the three arrows
  std::vector<std::string> axes = {}; ///< their names; x, y and z when empty
  std::string unit;                   ///< of lengths, behind the axes' names and at the ruler
  bool ruler = true;                  ///< of solids, whose axes have no numbers
  std::optional<Contours> contours = {};
  std::string vectors;       ///< what arrows stand for, in their key; empty: no arrows
  std::string vector_unit;   ///< behind its number
  double longest_vector = 0; ///< of all states; that of this picture's when 0
};

/// States in rows from left to right: all on one scale, with one color range and one color bar. All show the same
/// part of x, those of one row the same part of y. The axes of solids are shown by three arrows. Throws Error on an
/// unknown color map.
Plate make_plate(const std::vector<Panel>& panels, const PictureOptions& options);

/// What gives the pictures of several states one frame and one meaning of colors and arrows, each drawn alone: extent
/// and range, unless they are given, and the longest vector.
void align(PictureOptions& options, const std::vector<Panel>& panels);

/// Of the panels' bodies and beside them.
double longest_vector(const std::vector<Panel>& panels);

/// Throws Error on arrays that do not fit together or are not finite.
void check(const std::vector<Panel>& panels);

/// Throws Error unless the part that the options ask for shows something of a state; `argument` names it.
void check_part(const std::vector<Panel>& panels, const PictureOptions& options, const std::string& argument);

/// Throws Error when all states are cut and nothing is taken away from any.
void check_cuts(const std::vector<Panel>& panels);

/// The style that the options ask for. Throws Error on a size that no figure may have.
Style style_of(const PictureOptions& options);

} // namespace signorini::view
