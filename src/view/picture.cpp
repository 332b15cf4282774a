#include "view/picture.hpp"

#include "base/error.hpp"
#include "view/camera.hpp"
#include "view/cut.hpp"
#include "view/obstacle.hpp"
#include "view/relief.hpp"
#include "view/sheet.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::view {
namespace {

constexpr Rgb undeformed_fill = {150, 158, 166}, undeformed_rim_color = {95, 95, 95}, rigid_color = {140, 146, 154},
              rigid_rim_color = {120, 120, 120}, undeformed_color = {120, 120, 120};
constexpr std::uint8_t undeformed_opacity = 55, rigid_opacity = 62;

// ── A state in the picture's axes ────────────────────────────────────────────────────────────────────────────────────

struct Line {
  SurfaceLine line;
  Pen pen; ///< maximum width; fine meshes have thinner lines
};

/// A translucent surface behind the bodies, with its outline.
struct TranslucentSurface {
  Surface surface;
  Rgb color;
  std::uint8_t opacity;
  bool facing_only; ///< omit triangles that face away
  Pen outline;
};

/// The content of a state, first in model units, then in pixels with z towards the eye.
struct Scene {
  bool plane; ///< plane bodies face the eye and are unlit
  std::vector<Surface> bodies;
  std::vector<Line> lines;
  std::vector<TranslucentSurface> translucent;
  std::vector<Vec<3>> dots;
  std::vector<SurfaceLine> undeformed_rims; ///< dashed, drawn last, where they face the eye
  std::vector<Outline> outlines;
  std::vector<PointVector> vectors;
};

/// Calls change(points, normals) for all parts of a scene except outlines and vectors.
template <class AnyScene, class Change> void each_part(AnyScene& scene, Change change) {
  for (auto& surface : scene.bodies) change(surface.points, surface.normals);
  for (auto& pane : scene.translucent) change(pane.surface.points, pane.surface.normals);
  for (auto& line : scene.lines) change(line.line.points, line.line.normals);
  for (auto& line : scene.undeformed_rims) change(line.points, line.normals);
  for (auto& dot : scene.dots) {
    Points none;
    change(dot, none);
  }
}

void add_lines(Scene& scene, const std::vector<SurfaceLine>& lines, const Pen& pen) {
  for (const SurfaceLine& line : lines) scene.lines.push_back({line, pen});
}

void add_body(Scene& scene, const Body& body, const Style& style) {
  const double u = style.unit;
  const double mesh = std::max((scene.plane ? 1.7 : 1.6) * u, 0.8), rim = scene.plane ? mesh : 2.4 * u;
  if (body.mesh) add_lines(scene, body.mesh_lines, {mesh_color, mesh, 1.2, !body.open});
  add_lines(scene, body.rim, {border_color, rim, 1.5, !body.open});
  for (const SurfaceLine& line : body.undeformed_rim) scene.undeformed_rims.push_back(line);
  if (body.undeformed.points.cols() > 0)
    scene.translucent.push_back(
        {body.undeformed, undeformed_fill, undeformed_opacity, true, {undeformed_rim_color, 1.8 * u, -2, false}});
  for (const auto& [a, b] : body.net_lines) {
    SurfaceLine line{Points(3, 2), Points::Zero(3, 2)};
    line.points << body.control_points.col(a), body.control_points.col(b);
    // White outline, visible on any color.
    if (!scene.plane) scene.lines.push_back({line, {white, 4.2 * u, 5, false}});
    scene.lines.push_back({line, {net_color, (scene.plane ? 1.2 : 2) * u, 6, false}});
  }
  for (Eigen::Index i = 0; i < body.control_points.cols(); ++i) scene.dots.push_back(body.control_points.col(i));
  scene.bodies.push_back(body.skin);
}

void add_obstacle(Scene& scene, const Rigid& rigid, const Bounds& box, const Panel& panel, const Style& style) {
  RigidSurface surface = shown(rigid, box, panel.windows);
  if (panel.cut) surface = cut(surface, *panel.cut, cut_tolerance * box.size());
  const Pen pen = {rigid_rim_color, 2 * style.unit, 1, false};
  add_lines(scene, surface.rim, pen);
  scene.translucent.push_back({std::move(surface.surface), rigid_color, rigid_opacity, false, pen});
}

/// The content of a panel, rotated to the axes of the picture.
Scene scene_of(const Panel& panel, bool plane, const Mat<3>& axes, const Style& style) {
  Scene scene;
  scene.plane = plane;
  for (const Body& body : panel.bodies) add_body(scene, panel.cut ? cut(body, *panel.cut) : body, style);
  const Bounds box = bounds(panel.bodies);
  require(!box.empty(), "view.picture.empty");
  for (const Rigid& rigid : panel.obstacles) add_obstacle(scene, rigid, box, panel, style);
  scene.outlines = panel.outlines;
  scene.vectors = panel.vectors;
  if (panel.cut) {
    const double tolerance = cut_tolerance * box.size() * panel.cut->normal.norm();
    std::erase_if(scene.vectors, [&](const PointVector& one) {
      return (one.at - panel.cut->point).dot(panel.cut->normal) > tolerance;
    });
  }
  if (plane) {
    each_part(scene,
              [](const auto& points, Points& normals) { normals = Vec<3>::UnitZ().replicate(1, points.cols()); });
    return scene;
  }
  each_part(scene, [&](auto& points, Points& normals) { points = axes * points, normals = axes * normals; });
  for (Surface& surface : scene.bodies) surface.vectors = axes * surface.vectors;
  for (auto& [at, vector] : scene.vectors) at = axes * at, vector = axes * vector;
  for (const TranslucentSurface& pane : scene.translucent)
    add_lines(scene, zeros(pane.surface, pane.surface.normals.row(2).transpose()), pane.outline);
  return scene;
}

/// The extent of a scene on paper, with a margin.
Box paper_box(const Scene& scene) {
  Bounds all;
  each_part(scene, [&](const auto& points, const Points&) { all.take(points); });
  require(!all.empty(), "view.solids.cut_away");
  const Bounds bodies = all;
  for (const Outline& outline : scene.outlines) all.take(worth_showing(outline, bodies));
  const double margin = (scene.plane ? 0.03 : 0.015) * std::max((all.high - all.low).head<2>().maxCoeff(), 1e-12);
  return {all.low[0] - margin, all.high[0] + margin, all.low[1] - margin, all.high[1] + margin};
}

/// The projection of a box in space.
Box paper_box(const Bounds& region, const Mat<3>& axes) {
  Bounds seen;
  for (int corner = 0; corner < 8; ++corner)
    seen.take(axes * Vec<3>(corner & 1 ? region.high[0] : region.low[0], corner & 2 ? region.high[1] : region.low[1],
                            corner & 4 ? region.high[2] : region.low[2]));
  return {seen.low[0], seen.high[0], seen.low[1], seen.high[1]};
}

/// All states of one picture.
struct Scenes {
  Mat<3> axes = Mat<3>::Identity(); ///< those of the picture, as rows
  std::vector<Scene> list;
  ModelBoxes boxes;

  Scenes(const std::vector<Panel>& panels, const PictureOptions& options) {
    check(panels);
    if (options.camera) axes = picture_axes(*options.camera);
    for (const Panel& panel : panels) {
      list.push_back(scene_of(panel, !options.camera, axes, style_of(options)));
      boxes.push_back(options.crop ? paper_box(*options.crop, axes) : paper_box(list.back()));
    }
  }

  std::vector<const VectorX*> values() const {
    std::vector<const VectorX*> values;
    for (const Scene& scene : list)
      for (const Surface& surface : scene.bodies) values.push_back(&surface.values);
    return values;
  }
};

// ── On paper ─────────────────────────────────────────────────────────────────────────────────────────────────────────

/// Maps a scene to its position in the picture: pixels, z towards the eye.
void put_on_paper(Scene& scene, const Frame& frame) {
  const double scale = (frame.x.to - frame.x.from) / (frame.x.high - frame.x.low);
  const Vec<3> shift(frame.x.from - scale * frame.x.low, frame.y.from - scale * frame.y.low, 0);
  each_part(scene, [&](auto& points, const Points&) { points = (scale * points).colwise() + shift; });
  for (Outline& outline : scene.outlines) outline.line = (scale * outline.line).colwise() + shift;
  for (Outline& outline : scene.outlines)
    if (outline.spoke.size() > 0) outline.spoke = ((scale * outline.spoke).colwise() + shift).eval();
  for (Line& line : scene.lines) line.line.spacing *= scale;
  for (PointVector& one : scene.vectors) one.at = scale * one.at + shift;
}

/// The triangles with vertices ordered so that the renderer lights the side of the normals.
Triangles turned(const Surface& surface) {
  Triangles triangles = surface.triangles;
  for (auto triangle : triangles.colwise()) {
    const int a = triangle[0], b = triangle[1], c = triangle[2];
    const Vec<3> along = surface.points.col(b) - surface.points.col(a),
                 across = surface.points.col(c) - surface.points.col(a);
    if (along.cross(across).dot(surface.normals.col(a) + surface.normals.col(b) + surface.normals.col(c)) < 0)
      std::swap(triangle[1], triangle[2]);
  }
  return triangles;
}

Field field_of(const Surface& surface, bool lit, const Canvas& canvas) {
  Field field{surface.points,
              lit ? surface.normals : Points(),
              lit ? turned(surface) : surface.triangles,
              surface.values,
              canvas.range,
              canvas.colors,
              plain_color};
  if (surface.values.size() == 0) {
    field.values.setConstant(surface.points.cols(), canvas.range[0]);
    field.colors = {plain_color, plain_color};
  }
  return field;
}

/// Limits mesh lines to a tenth of their spacing each way, so that fine meshes do not darken the colors; thinner ones
/// than 0.2 pixels are omitted.
double width_of(const Line& line) {
  if (line.line.spacing == 0) return line.pen.width;
  const double facing = line.pen.facing_only ? std::max(0.0, line.line.normals.row(2).mean()) : 1;
  const double thread = 0.2, width = std::min(line.pen.width, 0.1 * line.line.spacing * std::sqrt(facing));
  return width >= thread ? width : 0;
}

/// A triangle of a translucent surface, to be sorted by depth.
struct Waiting {
  const TranslucentSurface* pane;
  Eigen::Vector3i corners;
  double depth; ///< of its center
};

/// Adds translucent triangles, the farthest first.
void add_translucent(Translucent& result, const std::vector<TranslucentSurface>& panes) {
  std::vector<Waiting> queue;
  for (const TranslucentSurface& pane : panes) {
    const Triangles triangles = turned(pane.surface);
    for (const auto& triangle : triangles.colwise()) {
      const double facing = pane.surface.normals.row(2)(triangle).sum();
      if (!pane.facing_only || facing > 0)
        queue.push_back({&pane, triangle, pane.surface.points.row(2)(triangle).mean()});
    }
  }
  std::stable_sort(queue.begin(), queue.end(), [](const Waiting& a, const Waiting& b) { return a.depth < b.depth; });
  for (const auto& [pane, corners, depth] : queue) {
    for (int corner : corners) {
      result.corners.emplace_back(pane->surface.points.col(corner));
      result.normals.emplace_back(pane->surface.normals.col(corner));
    }
    result.colors.push_back({pane->color[0], pane->color[1], pane->color[2], pane->opacity});
  }
}

/// Calls draw(points, normals, pen) for contours, in tones that contrast with their colors, and lines.
template <class Draw> void draw_lines(const Scene& scene, const Canvas& canvas, Draw draw) {
  for (const Surface& surface : scene.bodies)
    for (double level : surface.values.size() > 0 ? canvas.levels : std::vector<double>())
      for (const SurfaceLine& line : zeros(surface, surface.values.array() - level))
        draw(line.points, line.normals,
             Pen{tone_on(color_of(level, canvas.range, canvas.colors)), (scene.plane ? 1.8 : 2) * canvas.style.unit, 1,
                 true});
  for (const Line& line : scene.lines) {
    Pen pen = line.pen;
    pen.width = width_of(line);
    if (pen.width == 0) continue;
    draw(line.line.points, line.line.normals, pen);
  }
}

Relief relief_of(const Scene& scene, const Box& window, const Canvas& canvas) {
  Relief relief{window};
  for (const Surface& surface : scene.bodies) relief.fields.push_back(field_of(surface, !scene.plane, canvas));
  if (scene.plane) return relief;
  draw_lines(scene, canvas, [&](const Points& points, const Points& normals, const Pen& pen) {
    add_ribbon(relief.ink, points, normals, pen);
  });
  const double u = canvas.style.unit;
  for (const Vec<3>& dot : scene.dots) {
    add_dot(relief.ink, dot + 12 * u * Vec<3>::UnitZ(), 6.4 * u, white);
    add_dot(relief.ink, dot + 13 * u * Vec<3>::UnitZ(), 4.8 * u, net_color);
  }
  add_translucent(relief.translucent, scene.translucent);
  return relief;
}

/// Draws the parts of a line on a surface that face the eye.
void draw_dashed(Drawing& drawing, const SurfaceLine& line, const Box& box, const Pen& pen, double unit) {
  std::vector<Vec2> part;
  for (Eigen::Index i = 0; i <= line.points.cols(); ++i) {
    if (i < line.points.cols() && line.normals(2, i) > 0) {
      part.push_back({line.points(0, i), line.points(1, i)});
      continue;
    }
    add_line(drawing, part, box, pen.color, pen.width, {9 * unit, 6 * unit});
    part.clear();
  }
}

/// Draws everything on top of the relief: of plane states all lines.
void draw_scene(Drawing& drawing, const Scene& scene, const Frame& frame, const Canvas& canvas) {
  const double u = canvas.style.unit;
  const Pen pen = scene.plane ? Pen{undeformed_color, 2 * u, 0} : Pen{undeformed_rim_color, 2.2 * u, 0};
  for (const SurfaceLine& line : scene.undeformed_rims) draw_dashed(drawing, line, frame.box, pen, u);
  if (!scene.plane) return;
  for (const Outline& outline : scene.outlines) draw_obstacle(drawing, outline, frame.box, canvas.style);
  draw_lines(scene, canvas, [&](const Points& points, const Points&, const Pen& pen) {
    add_line(drawing, flat(points), frame.box, pen.color, pen.width);
  });
  for (const Vec<3>& dot : scene.dots) {
    const Vec2 at = {dot[0], dot[1]};
    if (!holds(frame.box, at)) continue;
    drawing.marks.push_back(Fill{circle_about(at, 6.4 * u), white});
    drawing.marks.push_back(Fill{circle_about(at, 4.8 * u), net_color});
  }
}

std::vector<PlacedMark> on_paper(const std::vector<PointMark>& marks, const Mat<3>& axes, const Frame& frame) {
  std::vector<PlacedMark> placed;
  for (const PointMark& mark : marks) {
    const Vec<3> seen = axes * mark.at;
    placed.push_back({{frame.x(seen[0]), frame.y(seen[1])}, mark.text});
  }
  return placed;
}

void draw_panel(Canvas& canvas, const Panel& panel, Scene& scene, const Frame& frame, const Mat<3>& axes,
                bool cropped) {
  Drawing& drawing = canvas.plate.drawing;
  const Style& style = canvas.style;
  put_on_paper(scene, frame);
  canvas.plate.reliefs.push_back(relief_of(scene, frame.box, canvas));
  draw_scene(drawing, scene, frame, canvas);
  std::vector<PointVector> vectors = regular_sample(scene.bodies, vector_step(style));
  vectors.insert(vectors.end(), scene.vectors.begin(), scene.vectors.end());
  draw_vectors(drawing, vectors, canvas.vector_scale, frame.box, style.unit);
  if (scene.plane || cropped) draw_frame(drawing, frame, style);
  draw_names(drawing, panel.names, axes, frame, style);
  draw_marks(drawing, within(on_paper(panel.marks, axes, frame), frame.box, !cropped, style), frame.box, style);
  if (panel.title.empty()) return;
  const auto& [left, right, bottom, top] = frame.box;
  const double raised = frame.yticks.factor.empty() ? 0 : 1.2 * style.tick_size, size = canvas.sheet.panel_title_size;
  drawing.marks.push_back(
      Text{{0.5 * (left + right), top + raised + 0.5 * size}, panel.title, size, Align::center, ink});
}

} // namespace

Plate make_plate(const std::vector<Panel>& panels, const PictureOptions& options) {
  Scenes scenes(panels, options);
  const Style style = style_of(options);
  std::array<std::string, 3> names;
  for (int axis = 0; axis < 3 && options.camera; ++axis) names[axis] = axis_name(options, axis);
  const auto [left, right, below, above] = triad_room(scenes.axes, names, style);
  const bool triad = options.camera && options.axis_names;
  std::optional<ArrowRoom> arrows;
  if (options.camera) arrows = triad ? ArrowRoom{left + right + 0.3 * style.margin, below + above} : ArrowRoom{0, 0};
  std::vector<std::string> titles;
  for (const Panel& panel : panels) titles.push_back(panel.title);
  Canvas canvas = make_canvas(titles, scenes.boxes, scenes.values(), longest_vector(panels), options, arrows);
  for (std::size_t p = 0; p < panels.size(); ++p)
    draw_panel(canvas, panels[p], scenes.list[p], canvas.sheet.frames[p], scenes.axes, options.crop.has_value());
  Drawing& drawing = canvas.plate.drawing;
  const Sheet& sheet = canvas.sheet;
  if (triad) draw_triad(drawing, {sheet.arrows[0] + left, sheet.arrows[1] + below}, scenes.axes, names, style);
  if (options.camera && options.ruler)
    draw_ruler(drawing, {sheet.whole[0], sheet.whole[2] - ruler_room(style)}, sheet.frames.back().x, options.unit,
               style);
  return finished(std::move(canvas), options);
}

void align(PictureOptions& options, const std::vector<Panel>& panels) {
  const Scenes scenes(panels, options);
  options.longest_vector = longest_vector(panels);
  options.extent = hull(scenes.boxes);
  if (const auto all = colored_values(scenes.values())) options.range = color_range(*all, options);
}

double longest_vector(const std::vector<Panel>& panels) {
  double longest = 0;
  for (const Panel& panel : panels) {
    for (const Body& body : panel.bodies)
      if (const Points& vectors = body.skin.vectors; vectors.cols() > 0)
        longest = std::max(longest, vectors.colwise().norm().maxCoeff());
    for (const PointVector& one : panel.vectors) longest = std::max(longest, one.vector.norm());
  }
  return longest;
}

} // namespace signorini::view
