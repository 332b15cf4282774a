#pragma once
// Maps of equal colored cells as PNG, SVG or PDF: numbers with a color bar, or categories with a legend.

#include "base/eigen.hpp"
#include "view/categories.hpp"
#include "view/figure.hpp"
#include "view/spot.hpp"

#include <optional>

namespace signorini::view {

/// One map of a figure.
struct Heat {
  std::string title;
  MatrixX values; ///< row j belongs to y j (from below), column i to x i; not finite: a blank cell
  std::vector<std::vector<std::string>> texts = {}; ///< same shape as values, or empty
};

struct HeatmapOptions {
  std::string title, xlabel, ylabel;
  std::string label;                ///< of the color bar
  std::vector<std::string> x, y;    ///< names of columns and rows
  std::vector<Category> categories; ///< if not empty, values are indices into it
  std::string colormap = "viridis";
  std::optional<std::array<double, 2>> range; ///< of the colors; default: that of the values
  bool log = false;                           ///< logarithmic colors
  std::optional<int> columns;                 ///< maps per row
  std::array<int, 2> size = {1600, 1000};
};

/// Several maps share names, colors, and bar or legend, which lists the categories that occur. Texts that do not fit
/// their cell are omitted. Requires values and texts that match the names, and an ascending range. Throws Error on
/// values ≤ 0 on a logarithmic scale, no finite values, or texts that leave no space for cells.
Figure heatmap_figure(const std::vector<Heat>& maps, const HeatmapOptions& options);

/// The cells of the same figure that are not blank, map by map and row by row. Throws like heatmap_figure().
std::vector<Spot> heatmap_spots(const std::vector<Heat>& maps, const HeatmapOptions& options);

} // namespace signorini::view
