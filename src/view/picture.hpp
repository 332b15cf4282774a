#pragma once
// Pictures of bodies: coloured, tessellated geometry with mesh lines, drawn off-screen to PNG. Knows arrays, no models.

#include "base/eigen.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace signorini::view {

using Triangles = Eigen::Matrix<int, 3, Eigen::Dynamic>;
using Points = Eigen::Matrix<double, 3, Eigen::Dynamic>;

/// One body ready to be drawn. Plane bodies have z = 0.
struct Body {
  Points points;                             ///< tessellation points
  Triangles triangles;                       ///< indices into points
  VectorX values;                            ///< one per point; empty: drawn in plain grey
  std::vector<Points> mesh_lines;            ///< polylines along element borders, on the true curved geometry
  Points control_points;                     ///< drawn as dots when not empty
  std::vector<std::array<int, 2>> net_lines; ///< control net between control points
};

struct PictureOptions {
  std::string title;
  std::string field_label;                    ///< title of the colour bar, with unit when known
  std::optional<std::array<double, 2>> range; ///< colour range; the values' own when absent
  std::string colormap = "viridis";
  std::array<int, 2> size = {1600, 1000};    ///< pixels
  std::optional<std::array<double, 4>> crop; ///< xmin, xmax, ymin, ymax in model units
};

/// Draws to a PNG file, whole or not at all. The same call gives the same bytes. Throws Error on an unknown colour map,
/// a file that cannot be written, a range that is empty or not finite, or when off-screen rendering is not to be had.
void draw_picture(const std::vector<Body>& bodies, const PictureOptions& options, const std::string& file);

/// Names of the colour maps that draw_picture knows.
std::vector<std::string> colormaps();

} // namespace signorini::view
