#pragma once
// Maps of equal coloured cells to PNG, SVG or PDF: numbers with a colour bar, or categories with a legend.

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
  std::string label;                ///< of the colour bar
  std::vector<std::string> x, y;    ///< names of columns and rows
  std::vector<Category> categories; ///< where not empty, values are their indices
  std::string colormap = "viridis";
  std::optional<std::array<double, 2>> range; ///< of the colours; the values' own when absent
  bool log = false;                           ///< colours follow the values' logarithm
  std::optional<int> columns;                 ///< maps in a row
  std::array<int, 2> size = {1600, 1000};
};

/// Draws to .png, .svg or .pdf (by the ending), whole or not at all; several maps share names, colours, and bar or
/// legend, which lists the categories that occur. The same call gives the same bytes. A cell's text is left out where
/// it does not fit. Throws Error on values that do not match the names, are ≤ 0 on a logarithmic scale or no
/// category; on nothing to draw, a range that does not rise, an unknown colour map, texts that leave no room for cells,
/// an unknown ending, or a file that cannot be written.
void draw_heatmap(const std::vector<Heat>& maps, const HeatmapOptions& options, const std::string& file);

/// The same before it is a file.
Figure heatmap_figure(const std::vector<Heat>& maps, const HeatmapOptions& options);

} // namespace signorini::view
