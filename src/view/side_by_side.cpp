#include "view/side_by_side.hpp"

#include "base/error.hpp"
#include "view/frame.hpp"
#include "view/text.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace signorini::view {
namespace {

int rows_of(int count, int columns) {
  return (count + columns - 1) / columns;
}

/// What each picture may take of the paper; nothing where that is too little for any.
std::optional<std::array<int, 2>> cell_of(int count, int columns, const std::array<int, 2>& paper) {
  const std::array<int, 2> cell = {paper[0] / columns, paper[1] / rows_of(count, columns)};
  if (cell[0] < 160 || cell[1] < 120) return std::nullopt;
  return cell;
}

/// The cell in which the first picture comes out largest, and its columns.
std::pair<int, std::array<int, 2>> best_cell(int count, const PictureOptions& options, const std::array<int, 2>& paper,
                                             const PlateMaker& make) {
  int best = 0;
  std::array<int, 2> cell{};
  double largest = 0;
  std::string reason = "choose a larger size";
  for (int columns = options.columns.value_or(1); columns <= options.columns.value_or(count); ++columns) {
    const auto next = cell_of(count, columns, paper);
    if (!next) continue;
    try {
      const std::array<int, 2> size = make(0, *next).drawing.size;
      const double area = static_cast<double>(size[0]) * size[1];
      if (area > largest * (1 + 1e-9)) best = columns, cell = *next, largest = area;
    } catch (const Error& error) {
      reason = error.what();
    }
  }
  require(best > 0, count, " pictures find no room side by side on ", options.size[0], " × ", options.size[1],
          " pixels: ", reason);
  return {best, cell};
}

/// Where rows or columns of these widths begin.
std::vector<int> begins(const std::vector<int>& widths, int start) {
  std::vector<int> at(widths.size());
  std::exclusive_scan(widths.begin(), widths.end(), at.begin(), start);
  return at;
}

} // namespace

std::string side_by_side(int count, const PictureOptions& options, const PlateMaker& make) {
  const Style style = style_for(options.size);
  const int head = options.title.empty() ? 0 : static_cast<int>(std::ceil(style.margin + 1.3 * style.title_size));
  const auto [columns, cell] = best_cell(count, options, {options.size[0], options.size[1] - head}, make);
  std::vector<PlacedPlate> plates;
  std::vector<int> widths(columns), heights(rows_of(count, columns));
  for (int i = 0; i < count; ++i) {
    plates.push_back({{i % columns, i / columns}, make(i, cell)});
    const std::array<int, 2>& size = plates.back().plate.drawing.size;
    widths[i % columns] = std::max(widths[i % columns], size[0]);
    heights[i / columns] = std::max(heights[i / columns], size[1]);
  }

  const int wide = std::reduce(widths.begin(), widths.end()), high = std::reduce(heights.begin(), heights.end());
  std::array<int, 2> whole = options.size;
  const double title = text_width(options.title, style.title_size) + 2 * style.margin;
  if (options.trim)
    whole = {std::clamp(static_cast<int>(std::ceil(title)), wide, std::max(wide, whole[0])), high + head};
  const std::vector<int> left = begins(widths, (whole[0] - wide) / 2),
                         down = begins(heights, (whole[1] - high - head) / 2 + head);
  for (auto& [at, plate] : plates) {
    const int column = at[0], row = at[1];
    at = {left[column] + (widths[column] - plate.drawing.size[0]) / 2,
          whole[1] - down[row] - (heights[row] + plate.drawing.size[1]) / 2};
  }

  if (!options.title.empty()) {
    // A plate as high as the title, so that it covers no other one.
    Drawing top{{whole[0], head}, {}};
    draw_title(top, options.title, {0.0, static_cast<double>(whole[0]), 0.0, 0.0}, style);
    plates.push_back({{0, whole[1] - head}, {std::move(top)}});
  }
  return png(whole, std::move(plates), options.transparent);
}

} // namespace signorini::view
