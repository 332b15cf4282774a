#include "view/picture.hpp"

#include "base/error.hpp"
#include "base/index.hpp"
#include "base/whole_file.hpp"
#include "view/body_colours.hpp"
#include "view/clip.hpp"
#include "view/colormap.hpp"
#include "view/extent_text.hpp"
#include "view/obstacle.hpp"
#include "view/sheet.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace signorini::view {
namespace {

constexpr Rgb undeformed_colour = {120, 120, 120};

void check(const Body& body, const std::string& name) {
  require(body.points.allFinite() && body.control_points.allFinite(), name,
          " has coordinates that are not finite; nothing can be drawn");
  bool finite = true;
  for (const MeshLine& line : body.mesh_lines) finite &= line.points.allFinite() && line.spacing >= 0;
  for (const auto* lines : {&body.rim, &body.undeformed})
    for (const Points& line : *lines) finite &= line.allFinite();
  require(finite, name, " has a line with coordinates that are not finite; nothing can be drawn");
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

void check(const std::vector<Panel>& panels) {
  require(!panels.empty(), "a sheet needs at least one state, none came");
  for (std::size_t p = 0; p < panels.size(); ++p) {
    const std::string where = panels.size() > 1 ? text("state ", p + 1, ", ") : "";
    for (std::size_t b = 0; b < panels[p].bodies.size(); ++b) check(panels[p].bodies[b], text(where, "body ", b + 1));
    for (const Outline& outline : panels[p].obstacles)
      require(outline.line.allFinite(), where, "an obstacle has coordinates that are not finite");
    for (const PointMark& mark : panels[p].marks)
      require(mark.at.allFinite(), where, "the mark '", mark.text, "' stands at a place that is not finite");
  }
}

void take(Box& box, const Points& points) {
  if (points.cols() == 0) return;
  for (int axis = 0; axis < 2; ++axis) {
    double &low = box[at(2 * axis)], &high = box[at(2 * axis + 1)];
    low = std::min(low, points.row(axis).minCoeff());
    high = std::max(high, points.row(axis).maxCoeff());
  }
}

/// What holds all bodies and what is drawn with them, with a little air.
Box model_box(const Panel& panel) {
  constexpr double far = std::numeric_limits<double>::infinity();
  Box box = {far, -far, far, -far};
  for (const Body& body : panel.bodies) {
    take(box, body.points);
    take(box, body.control_points);
    for (const MeshLine& line : body.mesh_lines) take(box, line.points);
    for (const auto* lines : {&body.rim, &body.undeformed})
      for (const Points& line : *lines) take(box, line);
  }
  require(box[0] <= box[1], "a picture needs at least one body with points, none came");
  const Box bodies = box;
  for (const Outline& outline : panel.obstacles) take(box, worth_showing(outline, bodies));
  const double air = 0.03 * std::max({box[1] - box[0], box[3] - box[2], 1e-12});
  return {box[0] - air, box[1] + air, box[2] - air, box[3] + air};
}

std::string text_of(const Box& box) {
  return text("{", box[0], ", ", box[1], ", ", box[2], ", ", box[3], "}");
}

void check_box(const Box& box, const std::string& argument) {
  require(std::all_of(box.begin(), box.end(), [](double v) { return std::isfinite(v); }) && box[0] < box[1] &&
              box[2] < box[3],
          argument, " is ", text_of(box), "; expected {xmin, xmax, ymin, ymax} with min below max");
}

ModelBoxes model_boxes(const std::vector<Panel>& panels, const std::optional<Box>& crop) {
  if (crop) {
    check_box(*crop, "crop");
    return ModelBoxes(panels.size(), *crop);
  }
  ModelBoxes boxes;
  for (const Panel& panel : panels) boxes.push_back(model_box(panel));
  return boxes;
}

std::optional<ColouredValues> values_of(const std::vector<Panel>& panels) {
  std::vector<const VectorX*> values;
  for (const Panel& panel : panels)
    for (const Body& body : panel.bodies) values.push_back(&body.values);
  return coloured_values(values);
}

Field field_of(const Body& body, const Frame& frame, const std::array<double, 2>& range,
               const std::vector<Rgb>& colours) {
  Field field{on_paper(body.points, frame), {}, {}, range, colours};
  for (Eigen::Index t = 0; t < body.triangles.cols(); ++t)
    field.triangles.push_back({body.triangles(0, t), body.triangles(1, t), body.triangles(2, t)});
  field.values.assign(body.values.data(), body.values.data() + body.values.size());
  if (body.values.size() == 0) {
    field.values.assign(field.points.size(), range[0]);
    field.colours = {plain_colour, plain_colour};
  }
  return field;
}

void add_line(Drawing& drawing, const std::vector<Vec2>& line, const Box& box, const Rgb& colour, double width,
              const std::vector<double>& dash = {}) {
  for (auto& part : clip_line(line, box)) drawing.marks.push_back(Stroke{std::move(part), colour, width, dash});
}

/// Lines of a mesh that is fine on paper darken a tenth of it at most each way, and go where they would be threads.
void draw_mesh(Drawing& drawing, const Body& body, const Frame& frame, const Style& style) {
  const double full = std::max(1.7 * style.unit, 0.8), thread = 0.2;
  const double scale = (frame.x.to - frame.x.from) / (frame.x.high - frame.x.low);
  for (const auto& [line, spacing] : body.mesh_lines) {
    const double width = std::min(full, 0.1 * scale * spacing);
    if (width >= thread) add_line(drawing, on_paper(line, frame), frame.box, mesh_colour, width);
  }
  for (const Points& line : body.rim) add_line(drawing, on_paper(line, frame), frame.box, mesh_colour, full);
}

void draw_control_points(Drawing& drawing, const Body& body, const Frame& frame, const Style& style) {
  const Box& box = frame.box;
  const std::vector<Vec2> points = on_paper(body.control_points, frame);
  for (const auto& [a, b] : body.net_lines)
    add_line(drawing, {points[a], points[b]}, box, net_colour, 1.2 * style.unit);
  for (const Vec2& p : points) {
    if (p[0] < box[0] || p[0] > box[1] || p[1] < box[2] || p[1] > box[3]) continue;
    std::vector<Vec2> rim, dot;
    for (int k = 0; k < 24; ++k) {
      const double c = std::cos(k * std::numbers::pi / 12) * style.unit,
                   s = std::sin(k * std::numbers::pi / 12) * style.unit;
      rim.push_back({p[0] + 6.4 * c, p[1] + 6.4 * s});
      dot.push_back({p[0] + 4.8 * c, p[1] + 4.8 * s});
    }
    drawing.marks.push_back(Fill{rim, white});
    drawing.marks.push_back(Fill{dot, net_colour});
  }
}

std::vector<PlacedMark> on_paper(const std::vector<PointMark>& marks, const Frame& frame) {
  std::vector<PlacedMark> placed;
  placed.reserve(marks.size());
  for (const PointMark& mark : marks) placed.push_back({{frame.x(mark.at[0]), frame.y(mark.at[1])}, mark.text});
  return placed;
}

/// Everything of a state but its coloured areas.
void draw_panel(Drawing& drawing, const Panel& panel, const Frame& frame, bool cropped, double title_size,
                const Style& style) {
  for (const Body& body : panel.bodies)
    for (const Points& line : body.undeformed)
      add_line(drawing, on_paper(line, frame), frame.box, undeformed_colour, 2 * style.unit,
               {9 * style.unit, 6 * style.unit});
  for (const Outline& outline : panel.obstacles) draw_obstacle(drawing, outline, frame, style);
  for (const Body& body : panel.bodies) {
    draw_mesh(drawing, body, frame, style);
    draw_control_points(drawing, body, frame, style);
  }
  draw_frame(drawing, frame, style);
  draw_names(drawing, panel.names, Mat<3>::Identity(), frame, style);
  draw_marks(drawing, within(on_paper(panel.marks, frame), frame.box, !cropped, style), frame.box, style);
  draw_panel_title(drawing, panel.title, frame, title_size, style);
}

} // namespace

Plate make_plate(const std::vector<Panel>& panels, const PictureOptions& options) {
  check_columns(options);
  check(panels);
  const Style style = style_of(options);
  const std::vector<Rgb> colours = colormap(options.colormap);
  const ModelBoxes boxes = widened(model_boxes(panels, options.crop), options);
  const auto values = values_of(panels);
  std::optional<std::array<double, 2>> range;
  if (values) range = colour_range(*values, options.range, is_diverging(options.colormap), options.field_label);
  const auto shown = options.bar ? range : std::nullopt;
  std::vector<std::string> titles;
  titles.reserve(panels.size());
  for (const Panel& panel : panels) titles.push_back(panel.title);
  const Sheet sheet = lay_out_sheet(titles, boxes, options, shown, style);

  Drawing drawing{sheet.size, {}};
  std::vector<Field> fields;
  for (std::size_t p = 0; p < panels.size(); ++p) {
    const Frame& frame = sheet.frames[p];
    for (const Body& body : panels[p].bodies) {
      Field field = field_of(body, frame, range.value_or(std::array<double, 2>{0, 1}), colours);
      fields.push_back(options.crop ? clip_field(field, frame.box) : std::move(field));
    }
    draw_panel(drawing, panels[p], frame, options.crop.has_value(), sheet.panel_title_size, style);
  }
  if (shown) draw_colorbar(drawing, sheet.bar, *range, values->all, colours, options.field_label, style);
  draw_title(drawing, options.title, sheet.whole, style);
  return {std::move(drawing), std::move(fields), {}, sheet.frames};
}

Style style_of(const PictureOptions& options) {
  const Style own = style_for(options.size);
  return options.style.value_or(own);
}

void align(PictureOptions& options, const std::vector<Panel>& panels) {
  check(panels);
  options.extent = hull(model_boxes(panels, options.crop));
  if (const auto values = values_of(panels))
    options.range = colour_range(*values, options.range, is_diverging(options.colormap), options.field_label);
}

void check_part(const std::vector<Panel>& panels, const PictureOptions& options, const std::string& argument) {
  if (!options.crop) return;
  check(panels);
  const Box &part = *options.crop, all = hull(model_boxes(panels, {}));
  check_box(part, argument);
  require(part[0] < all[1] && all[0] < part[1] && part[2] < all[3] && all[2] < part[3], argument, " = ", text_of(part),
          " shows nothing: all that is drawn lies in ", extent_text("x", all[0], all[1]), ", ",
          extent_text("y", all[2], all[3]));
}

void draw_sheet(const std::vector<Panel>& panels, const PictureOptions& options, const std::string& file) {
  const Format format = format_of(file);
  write_whole(file, bytes_of(figure_of(make_plate(panels, options)), format, options.transparent));
}

void draw_picture(const std::vector<Body>& bodies, const PictureOptions& options, const std::string& file) {
  draw_sheet({{"", bodies, {}}}, options, file);
}

} // namespace signorini::view
