#pragma once
// Where the states of a sheet, its colour bar and its title go.

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
  BarPlace bar;
  Box whole; ///< of all frames, up to where the title may stand
};

/// `titles`: of each state. `boxes`: what each state needs to show. `range`: of the colour bar; none without colours.
/// Throws Error when the states would be too small to see.
Sheet lay_out_sheet(const std::vector<std::string>& titles, const ModelBoxes& boxes, const PictureOptions& options,
                    const std::optional<std::array<double, 2>>& range, const Style& style,
                    const std::optional<ArrowRoom>& arrows = {});

/// The title of one state above its frame.
void draw_panel_title(Drawing& drawing, const std::string& title, const Frame& frame, double size, const Style& style);

/// What holds all boxes.
Box hull(const ModelBoxes& boxes);

/// The boxes with the extent that the options ask for.
ModelBoxes widened(ModelBoxes boxes, const PictureOptions& options);

/// Throws Error unless the columns are at least one.
void check_columns(const PictureOptions& options);

} // namespace signorini::view
