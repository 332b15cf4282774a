#pragma once
// Pictures of bodies: colored, tessellated geometry with mesh lines, drawn off-screen from plain arrays. Solids are
// lit, cut where requested, and shown in parallel projection.

#include "view/camera.hpp"
#include "view/figure.hpp"
#include "view/surface_lines.hpp"

namespace signorini::view {

/// The content of a color bar.
struct Bar {
  std::array<double, 2> range;
  std::string title;
};

struct PictureOptions {
  std::string title;
  std::string field_label;                    ///< title of the color bar, with unit if known
  std::optional<std::array<double, 2>> range; ///< color range; default: that of the values
  std::string colormap = "viridis";
  std::array<int, 2> size = {1600, 1000}; ///< pixels
  bool trim = false;                      ///< `size` is the maximum; the picture is trimmed to its content
  /// Camera for solids, the same for all states; not set for plane models.
  std::optional<Camera> camera;
  /// The part that is shown; z = 0 in the plane. In space the picture is clipped to the projection of the box.
  std::optional<Bounds> crop;
  bool transparent = false; ///< no background; else white
  bool bar = true;          ///< draw the color bar
  /// Minimum part of each state, in model units on paper: gives pictures of a series one scale.
  std::optional<Box> extent;
  std::optional<int> columns;         ///< of a sheet; default: the number that shows the states largest
  std::optional<Style> style;         ///< of texts and lines; default: that of the size
  std::vector<Bar> adjacent_bars;     ///< of adjacent pictures: the space is that of the largest bar
  bool axis_names = true;             ///< next to the numbers, or at the three arrows
  std::vector<std::string> axes = {}; ///< their names; x, y and z when empty
  std::string unit;                   ///< of lengths, in axis names and at the ruler
  bool ruler = true;                  ///< of solids, whose axes have no numbers
  std::optional<Contours> contours = {};
  std::string vectors;       ///< label of the arrows in their key; empty: no arrows
  std::string vector_unit;   ///< follows the number
  double longest_vector = 0; ///< of all states; 0: that of this picture
};

/// States in rows from left to right with one scale, one color range and one color bar. All show the same range of x,
/// those of one row the same range of y. Solids have three axis arrows. Throws Error on an unknown color map.
Plate make_plate(const std::vector<Panel>& panels, const PictureOptions& options);

/// Extent and color range, unless given, and longest vector of several states, so that pictures drawn separately have
/// the same frame, colors and arrow scale.
void align(PictureOptions& options, const std::vector<Panel>& panels);

/// The longest vector of bodies and of additional vectors.
double longest_vector(const std::vector<Panel>& panels);

/// Throws Error on arrays of inconsistent sizes or with non-finite entries.
void check(const std::vector<Panel>& panels);

/// Throws Error unless the requested part shows something of each state; `argument` names the part.
void check_part(const std::vector<Panel>& panels, const PictureOptions& options, const std::string& argument);

/// Throws Error when all states are cut and no cut removes anything.
void check_cuts(const std::vector<Panel>& panels);

/// The style for the options. Throws Error on an invalid size.
Style style_of(const PictureOptions& options);

} // namespace signorini::view
