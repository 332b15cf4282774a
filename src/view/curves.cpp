#include "view/curves.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace signorini::view {
namespace {

// The colors of Okabe and Ito, which color-blind readers can distinguish; their yellow is too pale on white and is
// replaced by brown.
const std::vector<Rgb> palette = {{0, 114, 178},  {213, 94, 0},  {0, 158, 115}, {204, 121, 167},
                                  {86, 180, 233}, {230, 159, 0}, {60, 60, 60},  {135, 75, 30}};
const int palette_size = std::ssize(palette);
constexpr double marker_radius = 8; // in a chart of 1600 × 1000

/// The unbroken sections of a series in pixels; points closer than 0.2 pixels to the last one are skipped.
Lines stretches(const Series& s, const Frame& frame) {
  Lines parts;
  bool open = false;
  for (std::size_t i = 0; i < s.x.size(); ++i) {
    if (!drawn(s, i)) {
      open = false;
      continue;
    }
    const Vec2 point = {frame.x(s.x[i]), frame.y(s.y[i])};
    if (!open) parts.emplace_back();
    open = true;
    auto& part = parts.back();
    if (part.empty() || distance(point, part.back()) > 0.2) part.push_back(point);
  }
  return parts;
}

bool has_band(const Series& s, std::size_t point) {
  return drawn(s, point) && std::isfinite(s.error[point]);
}

/// The outlines of the bands of a series in pixels, inside the frame: one per unbroken section, cut where x turns back,
/// because a band that overlaps itself would have holes. That of an isolated point is as wide as a marker.
Lines bands(const Series& s, const Frame& frame, const Style& style) {
  Lines outlines;
  std::vector<Vec2> upper, lower;
  const auto finish = [&] {
    if (upper.size() == 1) {
      const Vec2 half = {marker_radius * style.unit, 0};
      upper = {upper[0] - half, upper[0] + half};
      lower = {lower[0] - half, lower[0] + half};
    }
    upper.insert(upper.end(), lower.rbegin(), lower.rend());
    auto outline = clip_polygon(std::move(upper), frame.box);
    if (!outline.empty()) outlines.push_back(std::move(outline));
    upper.clear(), lower.clear();
  };
  constexpr double far = 1e9; // pixels; clipping would lose the digits of more distant points
  const auto on_paper = [&](double x, double y) {
    return Vec2{std::clamp(frame.x(x), -far, far), std::clamp(frame.y(y), -far, far)};
  };
  for (std::size_t i = 0; i < s.error.size(); ++i) {
    if (!has_band(s, i)) {
      finish();
      continue;
    }
    const double y = s.y[i], least = y - s.error[i];
    const Vec2 top = on_paper(s.x[i], y + s.error[i]),
               bottom = on_paper(s.x[i], frame.y.log ? std::max(least, std::min(y, frame.y.low)) : least);
    if (!upper.empty() && (top[0] - upper.back()[0]) * (upper.back()[0] - upper.front()[0]) < 0) {
      const Vec2 last_top = upper.back(), last_bottom = lower.back();
      finish();
      upper = {last_top}, lower = {last_bottom};
    }
    upper.push_back(top), lower.push_back(bottom);
  }
  finish();
  return outlines;
}

/// The greatest error that the y axis shows whole, so that a greater one does not hide the curves.
double greatest_error(const Range& curves) {
  const double span = curves.high - curves.low, size = std::max(std::abs(curves.low), std::abs(curves.high));
  return span > 1e-9 * size ? span : size > 0 ? size : std::numeric_limits<double>::infinity();
}

/// The lower (side −1) or the upper edge (1) of a band as a curve, for the range of the y axis.
Series band_edge(Series s, int side, double most, bool log) {
  s.line = true;
  for (std::size_t i = 0; i < s.y.size(); ++i) {
    const double y = s.y[i], end = y + side * std::min(s.error[i], most);
    s.y[i] = !has_band(s, i) ? std::nan("") : log ? std::max(end, 0.1 * y) : end;
  }
  return s;
}

bool within(const Vec2& p, const Box& box) {
  return p[0] >= box[0] - 0.5 && p[0] <= box[1] + 0.5 && p[1] >= box[2] - 0.5 && p[1] <= box[3] + 0.5;
}

struct CurvePlace {
  Vec2 at;
  int marker;
};

/// All points, or about ten spread along the line, shifted from series to series to avoid overlaps.
std::vector<CurvePlace> marker_places(const std::vector<Series>& series, std::size_t index, const Frame& frame,
                                      const Style& style) {
  const Series& s = series[index];
  const int own = look_of(series, index, style).marker;
  if (own == no_marker && s.marks.empty()) return {};
  std::vector<CurvePlace> places;
  for (std::size_t i = 0; i < s.x.size(); ++i)
    if (drawn(s, i)) places.push_back({{frame.x(s.x[i]), frame.y(s.y[i])}, s.marks.empty() ? own : s.marks[i]});
  std::erase_if(places, [&](const CurvePlace& p) { return !within(p.at, frame.box); });
  constexpr std::size_t few = 10;
  if (s.markers.value_or(false) || !s.marks.empty() || places.size() <= 2 * few) return places;
  std::vector<CurvePlace> chosen;
  const double stride = static_cast<double>(places.size()) / few;
  for (std::size_t k = 0; k < few; ++k)
    chosen.push_back(places[static_cast<std::size_t>(stride * (k + (index + 0.5) / series.size()))]);
  return chosen;
}

/// Dash patterns of curves 1 to 8, 9 to 16 and so on, in units of the style; for solid and for dashed series.
const std::vector<std::vector<double>> line_dashes = {{}, {18, 7, 4, 7}, {4, 6}, {30, 10}, {18, 6, 4, 6, 4, 6}};
const std::vector<std::vector<double>> dashed_dashes = {{14, 9}, {24, 8, 6, 8}, {7, 7}, {36, 12}, {24, 7, 6, 7, 6, 7}};

std::vector<double> dash_of(const Series& s, int number, double unit) {
  const auto& styles = s.dashed ? dashed_dashes : line_dashes;
  std::vector<double> dash = styles[static_cast<std::size_t>(std::max(number, 0) / palette_size) % styles.size()];
  for (double& length : dash) length *= unit;
  return dash;
}

/// Sections of one point, which show no line.
std::vector<Vec2> lone_points(const Series& s, const Frame& frame) {
  std::vector<Vec2> points;
  for (const auto& stretch : stretches(s, frame))
    if (stretch.size() == 1 && within(stretch.front(), frame.box)) points.push_back(stretch.front());
  return points;
}

/// Regular polygons of about equal area, or crosses (0 corners).
struct Shape {
  const char* name;
  int corners;
  bool open;
  double turn;  ///< of the first corner, in degrees
  double scale; ///< of the radius
};

// An open cross would look like a full one; other polygons replace the crosses.
constexpr Shape shapes[] = {{"circle", 20, false, 0, 1.0},
                            {"square", 4, false, 45, 1.25},
                            {"triangle", 3, false, 90, 1.4},
                            {"diamond", 4, false, 90, 1.25},
                            {"triangle down", 3, false, -90, 1.4},
                            {"cross", 0, false, 45, 1.2},
                            {"pentagon", 5, false, 90, 1.2},
                            {"plus", 0, false, 0, 1.2},
                            {"open circle", 20, true, 0, 1.0},
                            {"open square", 4, true, 45, 1.25},
                            {"open triangle", 3, true, 90, 1.4},
                            {"open diamond", 4, true, 90, 1.25},
                            {"open triangle down", 3, true, -90, 1.4},
                            {"open hexagon", 6, true, 0, 1.15},
                            {"open pentagon", 5, true, 90, 1.2},
                            {"open pentagon down", 5, true, -90, 1.2}};
constexpr int count = sizeof shapes / sizeof shapes[0];

std::vector<Vec2> ring(const Shape& shape, const Vec2& at, double radius, int corners) {
  std::vector<Vec2> points;
  for (int k = 0; k < corners; ++k) {
    const double angle = (shape.turn + 360.0 * k / corners) * std::numbers::pi / 180;
    points.push_back(at + radius * Vec2{std::cos(angle), std::sin(angle)});
  }
  return points;
}

void draw_cross(Drawing& drawing, const Shape& shape, const Vec2& at, double radius, double width, const Rgb& color) {
  const auto ends = ring(shape, at, radius, 4);
  drawing.marks.push_back(Stroke{{ends[0], ends[2]}, color, width});
  drawing.marks.push_back(Stroke{{ends[1], ends[3]}, color, width});
}

} // namespace

void Range::take(double value) {
  low = std::min(low, value), high = std::max(high, value);
}

Range axis_range(const Range& values, const std::optional<std::array<double, 2>>& given, bool log,
                 const std::string& axis, double margin) {
  if (given) {
    const auto [low, high] = *given;
    require(!log || low > 0, "view.axis.range_log", {{"axis", axis}, {"low", low}, {"high", high}});
    return {low, high};
  }
  if (log) {
    const double factor = values.high / values.low < 1 + 1e-9 ? 2 : std::pow(values.high / values.low, margin);
    return {values.low / factor, values.high * factor};
  }
  const double width = values.high - values.low;
  const double space = width > 1e-9 * std::max(std::abs(values.low), std::abs(values.high))
                           ? margin * width
                           : std::max(0.1 * std::abs(values.high), 1e-9);
  return {values.low - space, values.high + space};
}

int distinct_curves() {
  return palette_size * static_cast<int>(line_dashes.size());
}

const std::vector<Rgb>& curve_colors() {
  return palette;
}

bool drawn(const Series& s, std::size_t point) {
  return std::isfinite(s.x[point]) && std::isfinite(s.y[point]);
}

CurveLook look_of(const std::vector<Series>& series, std::size_t index, const Style& style) {
  const Series& s = series[index];
  const int number = s.color.value_or(static_cast<int>(index));
  const bool neutral = number == gray;
  const bool marked = s.marks.empty() && s.markers.value_or(s.line && series.size() > 1 && !neutral);
  return {neutral ? gray_color : palette[number % palette_size],
          marked ? s.marker.value_or(std::max(number, 0)) : no_marker, s.width * style.unit,
          dash_of(s, number, style.unit)};
}

Range range_within(const std::vector<Series>& series, const std::array<double, 2>& within, bool log_x, bool log_y) {
  // Lines are straight on paper, so they are clipped in the scales of the axes.
  const auto on_paper = [](double value, bool log) { return log ? std::log(value) : value; };
  constexpr double far = std::numeric_limits<double>::infinity();
  const Box strip = {on_paper(within[0], log_x), on_paper(within[1], log_x), -far, far};
  Range range;
  const auto take = [&](const Series& s) {
    for (std::size_t i = 0; i < s.x.size(); ++i) {
      if (!drawn(s, i)) continue;
      const Vec2 point = {on_paper(s.x[i], log_x), on_paper(s.y[i], log_y)};
      if (point[0] >= strip[0] && point[0] <= strip[1]) range.take(point[1]);
      if (!s.line || i == 0 || !drawn(s, i - 1)) continue;
      const Vec2 last = {on_paper(s.x[i - 1], log_x), on_paper(s.y[i - 1], log_y)};
      for (const auto& part : clip_line({last, point}, strip))
        for (const Vec2& end : part) range.take(end[1]);
    }
  };
  const auto values = [&] { return log_y ? Range{std::exp(range.low), std::exp(range.high)} : range; };
  for (const Series& s : series) take(s);
  if (range.empty()) return range;
  const double most = greatest_error(values());
  for (const Series& s : series)
    if (!s.error.empty())
      for (const int side : {-1, 1}) take(band_edge(s, side, most, log_y));
  return values();
}

namespace {

/// Draws heads at intervals of this length along a line, pixels at 1600 × 1000, the first after half of it.
void draw_arrows(Drawing& drawing, const std::vector<Vec2>& line, const Rgb& color, const Style& style) {
  constexpr double apart = 220;
  const double length = 26 * style.unit, half = 9 * style.unit;
  double left = 0.5 * apart * style.unit; // to the next head
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vec2 &from = line[i - 1], &to = line[i];
    const double piece = distance(from, to);
    for (; left <= piece && piece > 0; left += apart * style.unit) {
      const Vec2 t = 1 / piece * (to - from);
      const auto at = [&](double along, double across) { return from + (left + along) * t + across * left_of(t); };
      drawing.marks.push_back(Fill{{at(0.5 * length, 0), at(-0.5 * length, half), at(-0.5 * length, -half)}, color});
    }
    left -= piece;
  }
}

void draw_curve(Drawing& drawing, const std::vector<Series>& series, std::size_t index, const Frame& frame,
                const Style& style) {
  const Series& s = series[index];
  const CurveLook look = look_of(series, index, style);
  if (s.line)
    for (const auto& stretch : stretches(s, frame))
      for (const auto& part : clip_line(stretch, frame.box)) {
        drawing.marks.push_back(Stroke{part, look.color, look.width, look.dash});
        if (s.arrows) draw_arrows(drawing, part, look.color, style);
      }
  for (const CurvePlace& place : marker_places(series, index, frame, style))
    draw_marker(drawing, place.marker, place.at, marker_radius * style.unit, look.color);
  if (!s.line || !s.marks.empty() || s.markers.value_or(false)) return;
  const int marker = look.marker == no_marker ? 0 : look.marker;
  for (const Vec2& point : lone_points(s, frame))
    draw_marker(drawing, marker, point, marker_radius * style.unit, look.color);
}

} // namespace

void draw_series(Drawing& drawing, const std::vector<Series>& series, const Frame& frame, const Style& style) {
  constexpr double opacity = 0.25; // bands that overlap show through each other
  for (std::size_t n = 0; n < series.size(); ++n)
    for (auto& outline : bands(series[n], frame, style))
      drawing.marks.push_back(Fill{std::move(outline), look_of(series, n, style).color, opacity});
  for (std::size_t n = series.size(); n-- > 0;) draw_curve(drawing, series, n, frame, style);
}

void draw_sample(Drawing& drawing, const Series& s, const CurveLook& look, const Vec2& from, const Vec2& to,
                 const Style& style) {
  if (s.line || !s.marks.empty()) drawing.marks.push_back(Stroke{{from, to}, look.color, 1.13 * look.width, look.dash});
  if (look.marker == no_marker) return;
  draw_marker(drawing, look.marker, 0.5 * (from + to), 1.06 * marker_radius * style.unit, look.color);
}

void draw_mark_sample(Drawing& drawing, int mark, const Vec2& at, const Style& style) {
  draw_marker(drawing, mark, at, 1.06 * marker_radius * style.unit, ink);
}

Lines lines_of(const std::vector<Series>& series, const Frame& frame, const Style& style) {
  Lines lines;
  const double radius = marker_radius * style.unit;
  for (std::size_t n = 0; n < series.size(); ++n) {
    if (series[n].line)
      for (auto& stretch : stretches(series[n], frame)) lines.push_back(std::move(stretch));
    for (auto& outline : bands(series[n], frame, style)) lines.push_back(std::move(outline));
    for (const CurvePlace& place : marker_places(series, n, frame, style)) {
      const auto [x, y] = place.at;
      lines.insert(lines.end(), {{{x - radius, y}, {x + radius, y}}, {{x, y - radius}, {x, y + radius}}});
    }
  }
  return lines;
}

double covered(const Lines& lines, const Box& box) {
  double length = 0;
  for (const auto& line : lines)
    for (const auto& part : clip_line(line, box))
      for (std::size_t i = 1; i < part.size(); ++i) length += distance(part[i - 1], part[i]);
  return length;
}

const std::vector<std::string>& marker_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const Shape& shape : shapes) list.emplace_back(shape.name);
    return list;
  }();
  return names;
}

void draw_marker(Drawing& drawing, int marker, const Vec2& at, double radius, const Rgb& color) {
  const Shape& s = shapes[marker % count];
  const double size = s.scale * radius, rim = 0.22 * radius;
  if (s.corners == 0) {
    draw_cross(drawing, s, at, size + rim, 0.55 * radius + 2 * rim, white);
    draw_cross(drawing, s, at, size, 0.55 * radius, color);
    return;
  }
  // Moving the corners of a polygon out by rim / cos(π/n) moves its sides out by rim.
  const double out = 1 / std::cos(std::numbers::pi / s.corners);
  const auto fill = [&](double grown, const Rgb& c) {
    drawing.marks.push_back(Fill{ring(s, at, size + grown * out, s.corners), c});
  };
  fill(rim, white);
  fill(0, color);
  if (s.open) fill(-0.36 * radius, white);
}

} // namespace signorini::view
