#include "view/picture.hpp"

#include "base/error.hpp"
#include "base/index.hpp"
#include "view/cut.hpp"
#include "view/obstacle.hpp"
#include "view/picture_checks.hpp"
#include "view/sheet.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini::view {
namespace {

constexpr Rgb undeformed_colour = {120, 120, 120};

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
  require(box[0] <= box[1], "view.picture.empty");
  const Box bodies = box;
  for (const Outline& outline : panel.obstacles) take(box, worth_showing(outline, bodies));
  const double air = 0.03 * std::max({box[1] - box[0], box[3] - box[2], 1e-12});
  return {box[0] - air, box[1] + air, box[2] - air, box[3] + air};
}

std::vector<const VectorX*> values_of(const std::vector<Panel>& panels) {
  std::vector<const VectorX*> values;
  for (const Panel& panel : panels)
    for (const Body& body : panel.bodies) values.push_back(&body.values);
  return values;
}

Field field_of(const Surface& surface, const Canvas& canvas) {
  Field field{surface.points, {}, surface.triangles, surface.values, canvas.range, canvas.colours};
  if (surface.values.size() == 0) {
    field.values.setConstant(surface.points.cols(), canvas.range[0]);
    field.colours = {plain_colour, plain_colour};
  }
  return field;
}

/// Lines of a mesh that is fine on paper darken a tenth of it at most each way, and go where they would be threads.
void draw_mesh(Drawing& drawing, const Body& body, const Frame& frame, const Canvas& canvas) {
  const double full = std::max(1.7 * canvas.style.unit, 0.8), thread = 0.2;
  const double scale = (frame.x.to - frame.x.from) / (frame.x.high - frame.x.low);
  const Ground ground(body);
  for (const auto& [line, spacing] : body.mesh_lines) {
    const double width = std::min(full, 0.1 * scale * spacing);
    if (width < thread) continue;
    for (const auto& [first, count, tone] :
         toned(line.cols(), ground.along(line), mesh_colour, canvas.range, canvas.colours))
      add_line(drawing, on_paper(line.middleCols(first, count), frame), frame.box, tone, width);
  }
  for (const Points& line : body.rim) add_line(drawing, on_paper(line, frame), frame.box, mesh_colour, full);
}

void draw_contours(Drawing& drawing, const Surface& surface, const Frame& frame, const Canvas& canvas) {
  if (surface.values.size() == 0) return;
  for (double level : canvas.levels)
    for (const SurfaceLine& line : zeros(surface, surface.values.array() - level))
      add_line(drawing, on_paper(line.points, frame), frame.box,
               tone_on(colour_of(level, canvas.range, canvas.colours)), 1.8 * canvas.style.unit);
}

void draw_control_points(Drawing& drawing, const Body& body, const Frame& frame, const Style& style) {
  const std::vector<Vec2> points = on_paper(body.control_points, frame);
  for (const auto& [a, b] : body.net_lines)
    add_line(drawing, {points[a], points[b]}, frame.box, net_colour, 1.2 * style.unit);
  for (const Vec2& p : points) {
    if (!holds(frame.box, p)) continue;
    drawing.marks.push_back(Fill{circle_about(p, 6.4 * style.unit), white});
    drawing.marks.push_back(Fill{circle_about(p, 4.8 * style.unit), net_colour});
  }
}

std::vector<PlacedMark> on_paper(const std::vector<PointMark>& marks, const Frame& frame) {
  std::vector<PlacedMark> placed;
  placed.reserve(marks.size());
  for (const PointMark& mark : marks) placed.push_back({{frame.x(mark.at[0]), frame.y(mark.at[1])}, mark.text});
  return placed;
}

void draw_panel(Canvas& canvas, const Panel& panel, const Frame& frame, bool cropped) {
  Drawing& drawing = canvas.plate.drawing;
  const Style& style = canvas.style;
  Relief& relief = canvas.plate.reliefs.emplace_back(Relief{frame.box});
  std::vector<Surface> surfaces(panel.bodies.begin(), panel.bodies.end());
  for (Surface& surface : surfaces) {
    for (auto point : surface.points.colwise()) point << frame.x(point[0]), frame.y(point[1]), 0;
    relief.fields.push_back(field_of(surface, canvas));
  }
  for (const Body& body : panel.bodies)
    for (const Points& line : body.undeformed)
      add_line(drawing, on_paper(line, frame), frame.box, undeformed_colour, 2 * style.unit,
               {9 * style.unit, 6 * style.unit});
  for (const Outline& outline : panel.obstacles) draw_obstacle(drawing, outline, frame, style);
  for (const Body& body : panel.bodies) {
    draw_contours(drawing, body, frame, canvas);
    draw_mesh(drawing, body, frame, canvas);
    draw_control_points(drawing, body, frame, style);
  }
  std::vector<PointVector> vectors = regular_sample(surfaces, vector_step(style));
  for (const auto& [at, vector] : panel.vectors) vectors.push_back({{frame.x(at[0]), frame.y(at[1]), 0}, vector});
  draw_vectors(drawing, vectors, canvas.vector_scale, frame.box, style.unit);
  draw_frame(drawing, frame, style);
  draw_names(drawing, panel.names, Mat<3>::Identity(), frame, style);
  draw_marks(drawing, within(on_paper(panel.marks, frame), frame.box, !cropped, style), frame.box, style);
  draw_panel_title(drawing, panel.title, frame, canvas.sheet.panel_title_size, style);
}

} // namespace

ModelBoxes model_boxes(const std::vector<Panel>& panels, const std::optional<Box>& crop) {
  if (crop) {
    check_region(*crop, "crop");
    return ModelBoxes(panels.size(), *crop);
  }
  ModelBoxes boxes;
  for (const Panel& panel : panels) boxes.push_back(model_box(panel));
  return boxes;
}

Plate make_plate(const std::vector<Panel>& panels, const PictureOptions& options) {
  check(panels);
  Canvas canvas = make_canvas(titles_of(panels), model_boxes(panels, options.crop), values_of(panels),
                              longest_vector(panels), options);
  for (std::size_t p = 0; p < panels.size(); ++p)
    draw_panel(canvas, panels[p], canvas.sheet.frames[p], options.crop.has_value());
  return finished(std::move(canvas), options);
}

void align(PictureOptions& options, const std::vector<Panel>& panels) {
  check(panels);
  align(options, model_boxes(panels, options.crop), values_of(panels), longest_vector(panels));
}

} // namespace signorini::view
