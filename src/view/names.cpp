#include "view/marks.hpp"

#include "view/text.hpp"

#include <algorithm>

namespace signorini::view {
namespace {

constexpr Rgb background = {255, 255, 240}, arrow_color = {40, 84, 164};

struct Paper {
  const Mat<3>& axes;
  const Frame& frame;

  Vec<2> operator()(const Vec<3>& point) const {
    const Vec<3> seen = axes * point;
    return {frame.x(seen[0]), frame.y(seen[1])};
  }
};

/// Draws the text centered at a position, moved into the frame.
void add_text(Drawing& drawing, Vec<2> at, const std::string& string, const Rgb& color, const Box& frame,
              const Style& style) {
  const double size = 0.85 * style.tick_size, half = 0.5 * text_width(string, size) + 0.25 * size, high = 0.62 * size;
  at[0] = std::clamp(at[0], frame[0] + half, std::max(frame[0] + half, frame[1] - half));
  at[1] = std::clamp(at[1], frame[2] + high, std::max(frame[2] + high, frame[3] - high));
  fill_box(drawing, {at[0] - half, at[0] + half, at[1] - high, at[1] + high}, background);
  drawing.marks.push_back(Text{{at[0], at[1] - 0.34 * size}, string, size, Align::center, color});
}

void draw_label(Drawing& drawing, const Label& label, const Paper& paper, const Style& style) {
  constexpr double least_facing = 0.1;
  if (label.normal.norm() > 0 && (paper.axes * label.normal.normalized())[2] < least_facing) return;
  Vec<2> at = paper(label.at);
  if (!holds(paper.frame.box, {at[0], at[1]})) return;
  const Vec<2> shift = (paper.axes * label.shift).head<2>();
  if (shift.norm() > 0) {
    const double size = 0.85 * style.tick_size, half = 0.5 * text_width(label.text, size) + 0.6 * size;
    const Vec<2> way = shift.normalized();
    at += way * (std::abs(way[0]) * half + std::abs(way[1]) * size);
  }
  add_text(drawing, at, label.text, ink, paper.frame.box, style);
}

void draw_direction(Drawing& drawing, const Arrow& arrow, const Paper& paper, const Style& style) {
  if (arrow.lines.empty()) return;
  const auto depth = [&](const auto& line) { return (paper.axes * line.col(0))[2]; };
  const auto& line = *std::max_element(arrow.lines.begin(), arrow.lines.end(),
                                       [&](const auto& a, const auto& b) { return depth(a) < depth(b) - 1e-9; });
  std::vector<Vec2> points;
  for (Eigen::Index i = 0; i < line.cols(); ++i) {
    const Vec<2> at = paper(line.col(i));
    points.push_back({at[0], at[1]});
  }
  if (!holds(paper.frame.box, points.front()) || !holds(paper.frame.box, points.back())) return;
  const double head = 0.6 * style.tick_size;
  const Vec<2> tip = paper(line.col(line.cols() - 1));
  Eigen::Index back = line.cols() - 2;
  while (back > 0 && (tip - paper(line.col(back))).norm() < head) --back;
  const Vec<2> along = (tip - paper(line.col(back))).stableNormalized();
  draw_arrow(drawing, std::move(points), head, 4 * style.unit, arrow_color);
  add_text(drawing, tip + 0.8 * style.tick_size * along, arrow.text, arrow_color, paper.frame.box, style);
}

} // namespace

void draw_names(Drawing& drawing, const Names& names, const Mat<3>& axes, const Frame& frame, const Style& style) {
  const Paper paper{axes, frame};
  for (const Arrow& arrow : names.arrows) draw_direction(drawing, arrow, paper, style);
  for (const Label& label : names.labels) draw_label(drawing, label, paper, style);
}

} // namespace signorini::view
