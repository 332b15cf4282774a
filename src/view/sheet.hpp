#pragma once
// Where the states of a sheet, its colour bar and its title go.

#include "view/colorbar.hpp"
#include "view/picture.hpp"

namespace signorini::view {

/// The part of the model that each state shows: xmin, xmax, ymin, ymax.
using ModelBoxes = std::vector<Box>;

struct Sheet {
  std::array<int, 2> size;   ///< pixels, trimmed when asked for
  std::vector<Frame> frames; ///< one per panel
  double panel_title_size;
  BarPlace bar;
  Box whole; ///< of all frames, up to where the title may stand
};

/// `boxes`: what each state needs to show. `range`: of the colour bar; none without colours.
/// Throws Error when the states would be too small to see.
Sheet lay_out_sheet(const std::vector<Panel>& panels, const ModelBoxes& boxes, const PictureOptions& options,
                    const std::optional<std::array<double, 2>>& range, const Style& style);

} // namespace signorini::view
