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

/// The first picture in a number of columns.
struct Trial {
  int columns = 0;
  std::array<int, 2> cell{};
  double area = 0;  ///< of the picture, pixels
  double shape = 0; ///< of the whole, width by height
};

/// The columns in which the first picture is largest and the whole no tower, or the broadest one.
Trial best_trial(int count, const PictureOptions& options, const std::array<int, 2>& paper, const FigureMaker& make) {
  std::vector<Trial> trials;
  Message reason("view.pictures.larger");
  const int most = std::min(options.columns.value_or(count), count);
  for (int columns = options.columns ? most : 1; columns <= most; ++columns) {
    const auto cell = cell_of(count, columns, paper);
    const bool ragged = !options.columns && columns > 1 && rows_of(count, columns) == rows_of(count, columns - 1);
    if (!cell || ragged) continue;
    try {
      const std::array<int, 2> size = make(0, *cell).size;
      const double width = size[0], height = size[1];
      trials.push_back({columns, *cell, width * height, columns * width / (rows_of(count, columns) * height)});
    } catch (const Error& error) {
      reason = error.message();
    }
  }
  require(!trials.empty(), "view.pictures.room",
          {{"count", count}, {"width", options.size[0]}, {"height", options.size[1]}, {"reason", reason}});
  constexpr double tower = 1; // higher than wide
  return *std::max_element(trials.begin(), trials.end(), [&](const Trial& a, const Trial& b) {
    const double first = std::min(a.shape, tower), second = std::min(b.shape, tower);
    return first != second ? first < second : a.area < b.area;
  });
}

/// Where rows or columns of these widths begin.
std::vector<int> begins(const std::vector<int>& widths, int start) {
  std::vector<int> at(widths.size());
  std::exclusive_scan(widths.begin(), widths.end(), at.begin(), start);
  return at;
}

} // namespace

Figure side_by_side(int count, const PictureOptions& options, const FigureMaker& make) {
  const Style style = style_of(options);
  const int head = options.title.empty() ? 0 : static_cast<int>(std::ceil(style.margin + 1.3 * style.title_size));
  const Trial best = best_trial(count, options, {options.size[0], options.size[1] - head}, make);
  const int columns = best.columns;
  std::vector<Figure> parts;
  std::vector<int> widths(columns), heights(rows_of(count, columns));
  for (int i = 0; i < count; ++i) {
    parts.push_back(make(i, best.cell));
    const std::array<int, 2>& size = parts.back().size;
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
  Figure figure{whole, {}};
  for (int i = 0; i < count; ++i) {
    const int column = i % columns, row = i / columns;
    const std::array<int, 2>& size = parts[static_cast<std::size_t>(i)].size;
    const int x = left[column] + (widths[column] - size[0]) / 2,
              y = whole[1] - down[row] - (heights[row] + size[1]) / 2;
    for (auto& [at, plate] : parts[static_cast<std::size_t>(i)].plates)
      figure.plates.push_back({{x + at[0], y + at[1]}, std::move(plate)});
  }
  if (!options.title.empty()) {
    // A plate as high as the title, so that it covers no other one.
    Drawing top{{whole[0], head}, {}};
    draw_title(top, options.title, {0.0, static_cast<double>(whole[0]), 0.0, 0.0}, style);
    figure.plates.push_back({{0, whole[1] - head}, {std::move(top)}});
  }
  return figure;
}

Style part_style(const std::array<int, 2>& size, const Style& whole) {
  const Style own = style_for(size);
  const double larger = std::sqrt(std::max(1.0, whole.unit / own.unit));
  return {own.unit * larger, own.tick_size * larger, own.label_size * larger, own.title_size * larger,
          own.margin * larger};
}

} // namespace signorini::view
