#pragma once
// Layout of a sheet: states, color bar and title.

#include "view/colorbar.hpp"
#include "view/picture.hpp"

namespace signorini::view {

/// The part of the model that each state shows: xmin, xmax, ymin, ymax.
using ModelBoxes = std::vector<Box>;

/// Pixels at the bottom left in the place of numbers along axes: three arrows for solids.
struct ArrowRoom {
  double width, height;
};

struct Sheet {
  std::array<int, 2> size;   ///< pixels, trimmed if requested
  std::vector<Frame> frames; ///< one per panel
  double panel_title_size;   ///< the same for all, at which the longest fits its frame
  Vec2 arrows;               ///< bottom left corner of the axis arrows
  Vec2 key;                  ///< bottom left corner of the key of the vectors
  BarPlace bar;
  Box whole; ///< of all frames, up to the title
};

/// `titles`: of each state. `boxes`: the region that each state shows. `range`: of the color bar; empty without colors.
/// Throws Error when the states would be too small.
Sheet lay_out_sheet(const std::vector<std::string>& titles, const ModelBoxes& boxes, const PictureOptions& options,
                    const std::optional<std::array<double, 2>>& range, const Style& style,
                    const std::optional<ArrowRoom>& arrows = {});

/// A sheet during drawing.
struct Canvas {
  Style style;
  std::vector<Rgb> colors;
  std::optional<ColoredValues> values;
  std::array<double, 2> range; ///< of the colors
  std::vector<double> levels;  ///< of contour lines
  double vector_scale;         ///< pixels per unit of vectors
  Sheet sheet;
  Plate plate;
};

/// A sheet laid out by lay_out_sheet(); `values`: the colored ones; `longest`: longest vector.
Canvas make_canvas(const std::vector<std::string>& titles, const ModelBoxes& boxes,
                   const std::vector<const VectorX*>& values, double longest, const PictureOptions& options,
                   const std::optional<ArrowRoom>& arrows = {});

/// Grid spacing of vectors, pixels.
double vector_step(const Style& style);

/// The canvas with color bar, key of the vectors and title.
Plate finished(Canvas canvas, const PictureOptions& options);

/// The given range, or that of the values; warns of outliers that it excludes.
std::array<double, 2> color_range(const ColoredValues& values, const PictureOptions& options);

/// The name of an axis: that of the options, or its letter and the unit.
std::string axis_name(const PictureOptions& options, int axis, const std::string& unit = "");

/// The bounding box of all boxes.
Box hull(const ModelBoxes& boxes);

} // namespace signorini::view
