#include "view/solid_picture.hpp"

#include "base/error.hpp"
#include "view/picture_checks.hpp"
#include "view/ribbon.hpp"
#include "view/sheet.hpp"
#include "view/space_axes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace signorini::view {
namespace {

constexpr Rgb ghost_colour = {150, 158, 166}, ghost_rim_colour = {95, 95, 95}, rigid_colour = {140, 146, 154},
              rigid_rim_colour = {120, 120, 120};
constexpr std::uint8_t ghost_opacity = 55, rigid_opacity = 62;

// ── A scene in the picture's axes ────────────────────────────────────────────────────────────────────────────────────

struct Line {
  SurfaceLine line;
  Pen pen; ///< its width is the greatest; fine meshes get thinner lines
};

/// A translucent surface behind the bodies, with an outline that lies in front of what is behind it.
struct Sheer {
  Surface surface;
  Rgb colour;
  std::uint8_t opacity;
  bool facing_only; ///< without the triangles that face away
  Pen outline;
};

struct Scene {
  std::vector<Surface> bodies;
  std::vector<Line> lines;
  std::vector<Sheer> veils;
  std::vector<Vec<3>> dots;
  std::vector<SurfaceLine> ghosts; ///< dashed, over all else, where they face the eye
  std::vector<PointVector> vectors;

  template <class Change> void each_surface(Change change) {
    for (Surface& surface : bodies) change(surface);
    for (Sheer& veil : veils) change(veil.surface);
  }
};

void add_lines(Scene& scene, const std::vector<SurfaceLine>& lines, const Pen& pen) {
  for (const SurfaceLine& line : lines) scene.lines.push_back({line, pen});
}

void add_body(Scene& scene, const Solid& body, const Style& style) {
  const double u = style.unit;
  if (body.mesh) add_lines(scene, body.mesh_lines, {mesh_colour, std::max(1.6 * u, 0.8), 1.2, !body.open});
  add_lines(scene, body.rim, {mesh_colour, 2.4 * u, 1.5, !body.open});
  for (const SurfaceLine& line : body.undeformed_rim) scene.ghosts.push_back(line);
  if (body.undeformed.points.cols() > 0)
    scene.veils.push_back({body.undeformed, ghost_colour, ghost_opacity, true, {ghost_rim_colour, 1.8 * u, -2, false}});
  for (const auto& [a, b] : body.net_lines) {
    SurfaceLine line{Points(3, 2), Points::Zero(3, 2)};
    line.points << body.control_points.col(a), body.control_points.col(b);
    // White beneath, so that it shows on any colour.
    scene.lines.push_back({line, {white, 4.2 * u, 5, false}});
    scene.lines.push_back({line, {net_colour, 2 * u, 6, false}});
  }
  for (Eigen::Index i = 0; i < body.control_points.cols(); ++i) scene.dots.push_back(body.control_points.col(i));
  scene.bodies.push_back(body.skin);
}

/// The body with the values beneath its mesh lines.
Solid with_ground(Solid body) {
  const Ground ground(body.skin);
  for (SurfaceLine& line : body.mesh_lines) line.values = ground.along(line.points);
  return body;
}

void add_obstacle(Scene& scene, const Rigid& rigid, const Bounds& box, const std::optional<CutPlane>& plane,
                  const std::vector<Window>& windows, const Style& style) {
  RigidSurface surface = shown(rigid, box, windows);
  std::vector<SurfaceLine> rim = surface.rim;
  if (plane) {
    const double tolerance = 1e-9 * box.size();
    rim = traces(surface.surface, *plane, tolerance);
    for (const SurfaceLine& line : surface.rim)
      for (SurfaceLine& part : cut(line, *plane, tolerance)) rim.push_back(std::move(part));
    surface.surface = cut(surface.surface, *plane, tolerance);
  }
  const Pen pen = {rigid_rim_colour, 2 * style.unit, 1, false};
  add_lines(scene, rim, pen);
  scene.veils.push_back({std::move(surface.surface), rigid_colour, rigid_opacity, false, pen});
}

/// What a panel shows, turned into the picture's axes.
Scene scene_of(const SolidPanel& panel, const Mat<3>& axes, const Style& style) {
  Scene scene;
  Bounds box;
  for (const Solid& body : panel.bodies) {
    const Bounds own = bounds(body);
    box.take(own.low);
    box.take(own.high);
    const Solid grounded = with_ground(body);
    add_body(scene, panel.cut ? cut(grounded, *panel.cut) : grounded, style);
  }
  require(!box.empty(), "view.picture.empty");
  for (const Rigid& rigid : panel.obstacles) add_obstacle(scene, rigid, box, panel.cut, panel.windows, style);
  scene.vectors = panel.vectors;
  if (panel.cut)
    std::erase_if(scene.vectors, [&, tolerance = 1e-9 * box.size() * panel.cut->normal.norm()](const PointVector& one) {
      return (one.at - panel.cut->point).dot(panel.cut->normal) > tolerance;
    });
  const auto turn = [&](auto& points) { points = axes * points; };
  scene.each_surface([&](Surface& surface) { turn(surface.points), turn(surface.normals), turn(surface.vectors); });
  for (SurfaceLine& line : scene.ghosts) turn(line.points), turn(line.normals);
  for (auto& [at, vector] : scene.vectors) turn(at), turn(vector);
  for (Line& line : scene.lines) turn(line.line.points), turn(line.line.normals);
  for (Vec<3>& dot : scene.dots) dot = axes * dot;
  for (const Sheer& veil : scene.veils)
    add_lines(scene, zeros(veil.surface, veil.surface.normals.row(2).transpose()), veil.outline);
  return scene;
}

/// What a scene needs of the paper, with a little air.
Box paper_box(const Scene& scene) {
  Bounds all;
  for (const Surface& surface : scene.bodies) all.take(surface.points);
  for (const Sheer& veil : scene.veils) all.take(veil.surface.points);
  for (const Vec<3>& dot : scene.dots) all.take(dot);
  require(!all.empty(), "view.solids.cut_away");
  const double air = 0.015 * std::max({all.high[0] - all.low[0], all.high[1] - all.low[1], 1e-12});
  return {all.low[0] - air, all.high[0] + air, all.low[1] - air, all.high[1] + air};
}

/// What shows the whole of a box in space.
Box paper_box(const Bounds& region, const Mat<3>& axes) {
  check_region(region, "crop");
  Bounds seen;
  for (int corner = 0; corner < 8; ++corner)
    seen.take(axes * Vec<3>(corner & 1 ? region.high[0] : region.low[0], corner & 2 ? region.high[1] : region.low[1],
                            corner & 4 ? region.high[2] : region.low[2]));
  return {seen.low[0], seen.high[0], seen.low[1], seen.high[1]};
}

std::vector<Scene> scenes_of(const std::vector<SolidPanel>& panels, const Mat<3>& axes, const Style& style) {
  std::vector<Scene> scenes;
  scenes.reserve(panels.size());
  for (const SolidPanel& panel : panels) scenes.push_back(scene_of(panel, axes, style));
  return scenes;
}

/// What each scene shows, or the box in space that the options ask for.
ModelBoxes paper_boxes(const std::vector<Scene>& scenes, const SolidOptions& options, const Mat<3>& axes) {
  ModelBoxes boxes;
  for (const Scene& scene : scenes)
    boxes.push_back(options.region ? paper_box(*options.region, axes) : paper_box(scene));
  return boxes;
}

// ── On paper ─────────────────────────────────────────────────────────────────────────────────────────────────────────

/// Moves a scene to its place in the picture: pixels, z towards the eye.
void put_on_paper(Scene& scene, const Frame& frame) {
  const double scale = (frame.x.to - frame.x.from) / (frame.x.high - frame.x.low);
  const Vec<3> shift(frame.x.from - scale * frame.x.low, frame.y.from - scale * frame.y.low, 0);
  const auto place = [&](Points& points) { points = (scale * points).colwise() + shift; };
  scene.each_surface([&](Surface& surface) { place(surface.points); });
  for (Line& line : scene.lines) {
    place(line.line.points);
    line.line.spacing *= scale;
  }
  for (SurfaceLine& line : scene.ghosts) place(line.points);
  for (Vec<3>& dot : scene.dots) dot = scale * dot + shift;
  for (PointVector& one : scene.vectors) one.at = scale * one.at + shift;
}

std::vector<PlacedMark> on_paper(const std::vector<PointMark>& marks, const Mat<3>& axes, const Frame& frame) {
  std::vector<PlacedMark> placed;
  for (const PointMark& mark : marks) {
    const Vec<3> seen = axes * mark.at;
    placed.push_back({{frame.x(seen[0]), frame.y(seen[1])}, mark.text});
  }
  return placed;
}

/// The triangles with their corners in the order that the renderer takes for the side its normals show.
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

Field field_of(const Surface& surface, const Canvas& canvas) {
  Field field{surface.points, surface.normals, turned(surface), surface.values, canvas.range, canvas.colours};
  if (surface.values.size() == 0) {
    field.values.setConstant(surface.points.cols(), canvas.range[0]);
    field.colours = {plain_colour, plain_colour};
  }
  return field;
}

/// Lines of a mesh that is fine on paper darken a tenth of it at most each way, and go where they would be threads.
double width_of(const Line& line) {
  if (line.line.spacing == 0) return line.pen.width;
  const double facing = line.pen.facing_only ? std::max(0.0, line.line.normals.row(2).mean()) : 1;
  const double thread = 0.2, width = std::min(line.pen.width, 0.1 * line.line.spacing * std::sqrt(facing));
  return width >= thread ? width : 0;
}

/// A triangle of a translucent surface that waits for its turn.
struct Waiting {
  const Sheer* veil;
  Eigen::Vector3i corners;
  double depth; ///< of its middle
};

/// Translucent triangles, the farthest first.
void add_veils(Veil& result, const std::vector<Sheer>& veils) {
  std::vector<Waiting> queue;
  for (const Sheer& veil : veils) {
    const Triangles triangles = turned(veil.surface);
    for (const auto& triangle : triangles.colwise()) {
      const double facing = veil.surface.normals.row(2)(triangle).sum();
      if (!veil.facing_only || facing > 0)
        queue.push_back({&veil, triangle, veil.surface.points.row(2)(triangle).mean()});
    }
  }
  std::stable_sort(queue.begin(), queue.end(), [](const Waiting& a, const Waiting& b) { return a.depth < b.depth; });
  for (const auto& [veil, corners, depth] : queue) {
    for (int corner : corners) {
      result.corners.emplace_back(veil->surface.points.col(corner));
      result.normals.emplace_back(veil->surface.normals.col(corner));
    }
    result.colours.push_back({veil->colour[0], veil->colour[1], veil->colour[2], veil->opacity});
  }
}

void add_contours(Ink& ink, const Surface& surface, const Canvas& canvas) {
  if (surface.values.size() == 0) return;
  for (double level : canvas.levels)
    for (const SurfaceLine& line : zeros(surface, surface.values.array() - level))
      add_ribbon(ink, line.points, line.normals,
                 {tone_on(colour_of(level, canvas.range, canvas.colours)), 2 * canvas.style.unit, 1, true});
}

Relief relief_of(const Scene& scene, const Box& window, const Canvas& canvas) {
  const Style& style = canvas.style;
  Relief relief{window};
  for (const Surface& surface : scene.bodies) {
    relief.fields.push_back(field_of(surface, canvas));
    add_contours(relief.ink, surface, canvas);
  }
  for (const Line& line : scene.lines) {
    Pen pen = line.pen;
    pen.width = width_of(line);
    if (pen.width == 0) continue;
    const auto& [points, normals, spacing, values] = line.line;
    for (const auto& [first, count, tone] : toned(points.cols(), values, pen.colour, canvas.range, canvas.colours)) {
      pen.colour = tone;
      add_ribbon(relief.ink, points.middleCols(first, count), normals.middleCols(first, count), pen);
    }
  }
  for (const Vec<3>& dot : scene.dots) {
    add_dot(relief.ink, dot + 12 * style.unit * Vec<3>::UnitZ(), 6.4 * style.unit, white);
    add_dot(relief.ink, dot + 13 * style.unit * Vec<3>::UnitZ(), 4.8 * style.unit, net_colour);
  }
  add_veils(relief.veil, scene.veils);
  return relief;
}

/// The parts of a line on a surface that face the eye.
void draw_ghost(Drawing& drawing, const SurfaceLine& line, const Box& box, const Style& style) {
  std::vector<Vec2> part;
  for (Eigen::Index i = 0; i <= line.points.cols(); ++i) {
    if (i < line.points.cols() && line.normals(2, i) > 0) {
      part.push_back({line.points(0, i), line.points(1, i)});
      continue;
    }
    add_line(drawing, part, box, ghost_rim_colour, 2.2 * style.unit, {9 * style.unit, 6 * style.unit});
    part.clear();
  }
}

std::vector<const VectorX*> values_of(const std::vector<Scene>& scenes) {
  std::vector<const VectorX*> values;
  for (const Scene& scene : scenes)
    for (const Surface& surface : scene.bodies) values.push_back(&surface.values);
  return values;
}

} // namespace

Plate make_plate(const std::vector<SolidPanel>& panels, const SolidOptions& options) {
  check(panels);
  const Style style = style_of(options);
  const Mat<3> axes = picture_axes(options.camera);
  const std::array<std::string, 3> names = {axis_name(options, 0), axis_name(options, 1), axis_name(options, 2)};
  std::vector<Scene> scenes = scenes_of(panels, axes, style);
  const auto [left, right, below, above] = triad_room(axes, names, style);
  ArrowRoom arrows{0, 0};
  if (options.axis_names) arrows = {left + right + 0.3 * style.margin, below + above};
  Canvas canvas = make_canvas(titles_of(panels), paper_boxes(scenes, options, axes), values_of(scenes),
                              longest_vector(panels), options, arrows);
  Drawing& drawing = canvas.plate.drawing;
  const Sheet& sheet = canvas.sheet;
  for (std::size_t p = 0; p < panels.size(); ++p) {
    const Frame& frame = sheet.frames[p];
    put_on_paper(scenes[p], frame);
    canvas.plate.reliefs.push_back(relief_of(scenes[p], frame.box, canvas));
    for (const SurfaceLine& line : scenes[p].ghosts) draw_ghost(drawing, line, frame.box, style);
    std::vector<PointVector> vectors = regular_sample(scenes[p].bodies, vector_step(style));
    vectors.insert(vectors.end(), scenes[p].vectors.begin(), scenes[p].vectors.end());
    draw_vectors(drawing, vectors, canvas.vector_scale, frame.box, style.unit);
    if (options.region) draw_frame(drawing, frame, style);
    draw_names(drawing, panels[p].names, axes, frame, style);
    draw_marks(drawing, within(on_paper(panels[p].marks, axes, frame), frame.box, !options.region, style), frame.box,
               style);
    draw_panel_title(drawing, panels[p].title, frame, sheet.panel_title_size, style);
  }
  if (options.axis_names) draw_triad(drawing, {sheet.arrows[0] + left, sheet.arrows[1] + below}, axes, names, style);
  if (options.ruler)
    draw_ruler(drawing, {sheet.whole[0], sheet.whole[2] - ruler_room(style)}, sheet.frames.back().x, options.unit,
               style);
  return finished(std::move(canvas), options);
}

void align(SolidOptions& options, const std::vector<SolidPanel>& panels) {
  check(panels);
  const Mat<3> axes = picture_axes(options.camera);
  const std::vector<Scene> scenes = scenes_of(panels, axes, style_of(options));
  align(options, paper_boxes(scenes, options, axes), values_of(scenes), longest_vector(panels));
}

} // namespace signorini::view
