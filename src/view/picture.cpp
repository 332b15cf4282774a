#include "view/picture.hpp"

#include "base/error.hpp"
#include "view/colorbar.hpp"
#include "view/colormap.hpp"
#include "view/frame.hpp"
#include "view/output.hpp"
#include "view/renderer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace signorini::view {
namespace {

constexpr Rgb plain = {203, 209, 214}, mesh_colour = {45, 45, 45}, net_colour = {200, 60, 20},
              point_colour = {200, 60, 20};

std::string body_name(std::size_t index) {
  return text("body ", index + 1);
}

void check(const Body& body, const std::string& name) {
  require(body.points.allFinite() && body.control_points.allFinite(), name,
          " has coordinates that are not finite; nothing can be drawn");
  for (const Points& line : body.mesh_lines)
    require(line.allFinite(), name, " has a mesh line with coordinates that are not finite; nothing can be drawn");
  require(body.triangles.size() == 0 ||
              (body.triangles.minCoeff() >= 0 && body.triangles.maxCoeff() < body.points.cols()),
          name, " has triangles that name points outside 0 … ", body.points.cols() - 1);
  require(body.values.size() == 0 || body.values.size() == body.points.cols(), name, " has ", body.values.size(),
          " values for ", body.points.cols(), " points; give one per point or none");
  require(body.values.allFinite(), name,
          " has field values that are not finite; solve the state first, or choose another field");
  for (const auto& line : body.net_lines)
    require(std::min(line[0], line[1]) >= 0 && std::max(line[0], line[1]) < body.control_points.cols(), name,
            " has a net line that names control points outside 0 … ", body.control_points.cols() - 1);
}

/// The crop, or what holds all bodies and what is drawn with them, with a little air.
Box model_box(const std::vector<Body>& bodies, const std::optional<std::array<double, 4>>& crop) {
  if (crop) {
    const auto& c = *crop;
    require(std::all_of(c.begin(), c.end(), [](double v) { return std::isfinite(v); }) && c[0] < c[1] && c[2] < c[3],
            "crop is {", c[0], ", ", c[1], ", ", c[2], ", ", c[3],
            "}; expected {xmin, xmax, ymin, ymax} with min below max");
    return c;
  }
  constexpr double far = std::numeric_limits<double>::infinity();
  Box box = {far, -far, far, -far};
  const auto take = [&](const Points& points) {
    if (points.cols() == 0) return;
    for (int axis = 0; axis < 2; ++axis) {
      box[2 * axis] = std::min(box[2 * axis], points.row(axis).minCoeff());
      box[2 * axis + 1] = std::max(box[2 * axis + 1], points.row(axis).maxCoeff());
    }
  };
  for (const Body& body : bodies) {
    take(body.points);
    take(body.control_points);
    for (const Points& line : body.mesh_lines) take(line);
  }
  require(box[0] <= box[1], "a picture needs at least one body with points, none came");
  const double air = 0.03 * std::max({box[1] - box[0], box[3] - box[2], 1e-12});
  return {box[0] - air, box[1] + air, box[2] - air, box[3] + air};
}

/// The given range, or the values' own; about zero for diverging maps whose values have both signs.
std::array<double, 2> colour_range(const std::vector<Body>& bodies, const PictureOptions& options) {
  if (options.range) {
    const auto [low, high] = *options.range;
    require(std::isfinite(low) && std::isfinite(high) && low < high, "range is {", low, ", ", high,
            "}; expected two finite numbers, the lower one first");
    return *options.range;
  }
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Body& body : bodies)
    if (body.values.size() > 0)
      low = std::min(low, body.values.minCoeff()), high = std::max(high, body.values.maxCoeff());
  if (is_diverging(options.colormap) && low < 0 && high > 0) high = std::max(-low, high), low = -high;
  if (high - low > 1e-12 * std::max(std::abs(low), std::abs(high))) return {low, high};
  const double room = std::max(0.01 * std::abs(low), 1e-12);
  return {low - room, high + room};
}

/// From model units to pixels, the same in x and y.
struct View {
  Frame frame;

  Vec2 operator()(const Points& points, Eigen::Index column) const {
    return {frame.x(points(0, column)), frame.y(points(1, column))};
  }

  std::vector<Vec2> operator()(const Points& points) const {
    std::vector<Vec2> result;
    for (Eigen::Index i = 0; i < points.cols(); ++i) result.push_back((*this)(points, i));
    return result;
  }
};

/// The largest frame of the model box's shape in the free area, in its middle.
View fit_view(const Box& model, const Box& area, const Style& style) {
  const double width = model[1] - model[0], height = model[3] - model[2];
  const double scale = std::min((area[1] - area[0]) / width, (area[3] - area[2]) / height);
  const double left = 0.5 * (area[0] + area[1] - scale * width), bottom = 0.5 * (area[2] + area[3] - scale * height);
  const double right = left + scale * width, top = bottom + scale * height;
  View view;
  view.frame.box = {left, right, bottom, top};
  view.frame.x = {model[0], model[1], false, left, right};
  view.frame.y = {model[2], model[3], false, bottom, top};
  view.frame.xticks = fitting_ticks(model[0], model[1], false, right - left, style);
  view.frame.yticks = stacked_ticks(model[2], model[3], false, top - bottom, style);
  view.frame.xlabel = "x";
  view.frame.ylabel = "y";
  return view;
}

Field field_of(const Body& body, const View& view, const std::array<double, 2>& range,
               const std::vector<Rgb>& colours) {
  Field field{view(body.points), {}, {}, range, colours};
  for (Eigen::Index t = 0; t < body.triangles.cols(); ++t)
    field.triangles.push_back({body.triangles(0, t), body.triangles(1, t), body.triangles(2, t)});
  field.values.assign(body.values.data(), body.values.data() + body.values.size());
  if (body.values.size() == 0) {
    field.values.assign(field.points.size(), range[0]);
    field.colours = {plain, plain};
  }
  return field;
}

void add_line(Drawing& drawing, const std::vector<Vec2>& line, const Box& box, const Rgb& colour, double width) {
  for (auto& part : clip_line(line, box)) drawing.marks.push_back(Stroke{std::move(part), colour, width});
}

void draw_lines(Drawing& drawing, const Body& body, const View& view, const Style& style) {
  const Box& box = view.frame.box;
  for (const Points& line : body.mesh_lines) add_line(drawing, view(line), box, mesh_colour, 1.7 * style.unit);
  for (const auto& [a, b] : body.net_lines)
    add_line(drawing, {view(body.control_points, a), view(body.control_points, b)}, box, net_colour, 1.2 * style.unit);
  for (const Vec2& p : view(body.control_points)) {
    if (p[0] < box[0] || p[0] > box[1] || p[1] < box[2] || p[1] > box[3]) continue;
    std::vector<Vec2> rim, dot;
    for (int k = 0; k < 24; ++k) {
      const double c = std::cos(k * std::numbers::pi / 12) * style.unit,
                   s = std::sin(k * std::numbers::pi / 12) * style.unit;
      rim.push_back({p[0] + 6.4 * c, p[1] + 6.4 * s});
      dot.push_back({p[0] + 4.8 * c, p[1] + 4.8 * s});
    }
    drawing.marks.push_back(Fill{rim, white});
    drawing.marks.push_back(Fill{dot, point_colour});
  }
}

/// White over what the coloured areas show outside the frame.
void mask_outside(Drawing& drawing, const Box& box) {
  const double width = drawing.size[0], height = drawing.size[1];
  const auto cover = [&](double left, double right, double bottom, double top) {
    drawing.marks.push_back(Fill{{{left, bottom}, {right, bottom}, {right, top}, {left, top}}, white});
  };
  cover(0, box[0], 0, height);
  cover(box[1], width, 0, height);
  cover(box[0], box[1], 0, box[2]);
  cover(box[0], box[1], box[3], height);
}

} // namespace

void draw_picture(const std::vector<Body>& bodies, const PictureOptions& options, const std::string& file) {
  require(file_ending(file) == ".png", "file '", file, "' of a picture must end in .png");
  for (std::size_t i = 0; i < bodies.size(); ++i) check(bodies[i], body_name(i));
  const Style style = style_for(options.size);
  const std::vector<Rgb> colours = colormap(options.colormap);
  const Box model = model_box(bodies, options.crop);
  const bool coloured = std::any_of(bodies.begin(), bodies.end(), [](const Body& b) { return b.values.size() > 0; });
  const std::array<double, 2> range = coloured ? colour_range(bodies, options) : std::array<double, 2>{0, 1};

  const double width = options.size[0], height = options.size[1];
  const double top = height - style.margin - (options.title.empty() ? 0.4 : 1.7) * style.title_size;
  const double bottom = style.margin + room_below(style, "x");
  const Ticks guess = stacked_ticks(model[2], model[3], false, top - bottom, style);
  const double left = style.margin + room_left(style, guess, "y");
  const double bar_room = coloured ? colorbar_room(range, options.field_label, top - bottom, style) : style.margin;
  const Box area = {left, width - style.margin - bar_room, bottom,
                    top - (guess.factor.empty() ? 0 : 1.2 * style.tick_size)};
  require(area[1] - area[0] > 0.2 * width && area[3] - area[2] > 0.2 * height, "a picture of ", options.size[0], " × ",
          options.size[1], " pixels leaves too little room beside labels and colour bar; choose a larger size");

  const View view = fit_view(model, area, style);
  const Box& box = view.frame.box;
  Drawing drawing{options.size, {}};
  std::vector<Field> fields;
  for (const Body& body : bodies) fields.push_back(field_of(body, view, range, colours));
  if (options.crop) mask_outside(drawing, box);
  for (const Body& body : bodies) draw_lines(drawing, body, view, style);
  draw_frame(drawing, view.frame, style);
  double highest = box[3] + (view.frame.yticks.factor.empty() ? 0 : 1.2 * style.tick_size);
  if (coloured) {
    const double least = 0.55 * (top - bottom), middle = 0.5 * (box[2] + box[3]),
                 half = 0.5 * std::max(box[3] - box[2], least);
    const double bar_bottom = std::clamp(middle - half, bottom, top - 2 * half);
    highest = std::max(highest, bar_bottom + 2 * half);
    std::array<bool, 2> beyond = {false, false};
    for (const Body& body : bodies)
      if (body.values.size() > 0) {
        beyond[0] |= body.values.minCoeff() < range[0];
        beyond[1] |= body.values.maxCoeff() > range[1];
      }
    draw_colorbar(drawing, {box[1] + 1.3 * style.margin, bar_bottom, bar_bottom + 2 * half}, range, beyond, colours,
                  options.field_label, style);
  }
  draw_title(drawing, options.title, {box[0], box[1], box[2], highest}, style);
  write_whole(file, png(drawing, std::move(fields)));
}

} // namespace signorini::view
