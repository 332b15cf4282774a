#pragma once
// Where the states of a sheet, its color bar and its title go.

#include "view/colorbar.hpp"
#include "view/picture.hpp"

namespace signorini::view {

/// The part of the model that each state shows: xmin, xmax, ymin, ymax.
using ModelBoxes = std::vector<Box>;

/// Pixels at the bottom left that stand in for numbers along the axes: three arrows for solids.
struct ArrowRoom {
  double width, height;
};

struct Sheet {
  std::array<int, 2> size;   ///< pixels, trimmed when asked for
  std::vector<Frame> frames; ///< one per panel
  double panel_title_size;   ///< one for all, at which the longest fits its frame
  Vec2 arrows;               ///< bottom left corner of the arrows' room
  Vec2 key;                  ///< bottom left corner of that of the vectors' key
  BarPlace bar;
  Box whole; ///< of all frames, up to where the title may stand
};

/// `titles`: of each state. `boxes`: what each state needs to show. `range`: of the color bar; none without colors.
/// Throws Error when the states would be too small to see.
Sheet lay_out_sheet(const std::vector<std::string>& titles, const ModelBoxes& boxes, const PictureOptions& options,
                    const std::optional<std::array<double, 2>>& range, const Style& style,
                    const std::optional<ArrowRoom>& arrows = {});

/// A sheet while its states are drawn.
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

/// A sheet laid out by lay_out_sheet(); `values`: what is colored; `longest`: of the vectors.
Canvas make_canvas(const std::vector<std::string>& titles, const ModelBoxes& boxes,
                   const std::vector<const VectorX*>& values, double longest, const PictureOptions& options,
                   const std::optional<ArrowRoom>& arrows = {});

/// Between the points of the grid that vectors are drawn at, pixels.
double vector_step(const Style& style);

/// The canvas with color bar, vectors' key and title.
Plate finished(Canvas canvas, const PictureOptions& options);

/// The options' own range, or that of the values; with a warning where it leaves out outliers.
std::array<double, 2> color_range(const ColoredValues& values, const PictureOptions& options);

/// What an axis is called: by the options, or by its letter and the unit.
std::string axis_name(const PictureOptions& options, int axis, const std::string& unit = "");

/// What holds all boxes.
Box hull(const ModelBoxes& boxes);

} // namespace signorini::view
