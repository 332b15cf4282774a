#pragma once
// Maps of equal colored cells to PNG, SVG or PDF: numbers with a color bar, or categories with a legend.

#include "base/eigen.hpp"
#include "view/categories.hpp"
#include "view/figure.hpp"

#include <optional>

namespace signorini::view {

/// One map of a figure.
struct Heat {
  std::string title;
  MatrixX values; ///< row j is that of y j (from below), column i that of x i; not finite: a blank cell
  std::vector<std::vector<std::string>> texts = {}; ///< as values, or empty
};

struct HeatmapOptions {
  std::string title, xlabel, ylabel;
  std::string label;                ///< of the color bar
  std::vector<std::string> x, y;    ///< names of columns and rows
  std::vector<Category> categories; ///< where not empty, values are their indices
  std::string colormap = "viridis";
  std::optional<std::array<double, 2>> range; ///< of the colors; the values' own when absent
  bool log = false;                           ///< colors follow the values' logarithm
  std::optional<int> columns;                 ///< maps in a row
  std::array<int, 2> size = {1600, 1000};
};

/// Several maps share names, colors, and bar or legend, which lists the categories that occur. A cell's text is left
/// out where it does not fit. Needs values and texts that match the names, and a range that rises. Throws Error on
/// values ≤ 0 on a logarithmic scale, nothing to draw, or texts that leave no room for cells.
Figure heatmap_figure(const std::vector<Heat>& maps, const HeatmapOptions& options);

} // namespace signorini::view
