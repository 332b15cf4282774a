#include "view/solid_picture.hpp"

#include "base/error.hpp"
#include "base/whole_file.hpp"
#include "view/body_colours.hpp"
#include "view/colormap.hpp"
#include "view/ribbon.hpp"
#include "view/ruler.hpp"
#include "view/sheet.hpp"
#include "view/solid_checks.hpp"
#include "view/triad.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace signorini::view {
namespace {

constexpr Rgb ghost_colour = {150, 158, 166}, ghost_rim_colour = {140, 140, 140}, rigid_colour = {140, 146, 154},
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
  const Pen ghost = {ghost_rim_colour, 1.8 * u, -2, false};
  add_lines(scene, body.undeformed_rim, ghost);
  if (body.undeformed.points.cols() > 0)
    scene.veils.push_back({body.undeformed, ghost_colour, ghost_opacity, true, ghost});
  for (const auto& [a, b] : body.net_lines) {
    SurfaceLine line{Points(3, 2), Points(3, 2)};
    line.points << body.control_points.col(a), body.control_points.col(b);
    line.normals.setZero();
    scene.lines.push_back({std::move(line), {net_colour, 1.2 * u, 2, false}});
  }
  for (Eigen::Index i = 0; i < body.control_points.cols(); ++i) scene.dots.push_back(body.control_points.col(i));
  scene.bodies.push_back(body.skin);
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
    add_body(scene, panel.cut ? cut(body, *panel.cut) : body, style);
  }
  require(!box.empty(), "a picture needs at least one body with points, none came");
  for (const Rigid& rigid : panel.obstacles) add_obstacle(scene, rigid, box, panel.cut, panel.windows, style);
  const auto turn = [&](Points& points) { points = axes * points; };
  scene.each_surface([&](Surface& surface) { turn(surface.points), turn(surface.normals); });
  for (Line& line : scene.lines) turn(line.line.points), turn(line.line.normals);
  for (Vec<3>& dot : scene.dots) dot = axes * dot;
  for (const Sheer& veil : scene.veils) add_lines(scene, outline(veil.surface), veil.outline);
  return scene;
}

/// What a scene needs of the paper, with a little air.
Box paper_box(const Scene& scene) {
  Bounds all;
  for (const Surface& surface : scene.bodies) all.take(surface.points);
  for (const Sheer& veil : scene.veils) all.take(veil.surface.points);
  for (const Vec<3>& dot : scene.dots) all.take(dot);
  require(!all.empty(), "the cut takes all bodies away; move its plane, or turn its normal round");
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
  for (Vec<3>& dot : scene.dots) dot = scale * dot + shift;
}

std::vector<PlacedMark> on_paper(const std::vector<PointMark>& marks, const Mat<3>& axes, const Frame& frame) {
  std::vector<PlacedMark> placed;
  for (const PointMark& mark : marks) {
    const Vec<3> seen = axes * mark.at;
    placed.push_back({{frame.x(seen[0]), frame.y(seen[1])}, mark.text});
  }
  return placed;
}

/// Takes away what lies outside the frame.
void trim(Scene& scene, const Box& box) {
  for (int axis = 0; axis < 2; ++axis)
    for (int end = 0; end < 2; ++end) {
      const double limit = box[static_cast<std::size_t>(2 * axis + end)];
      const CutPlane side{limit * Vec<3>::Unit(axis), (end == 0 ? -1 : 1) * Vec<3>::Unit(axis)};
      scene.each_surface([&](Surface& surface) { surface = cut(surface, side, 0); });
      std::vector<Line> lines;
      for (const Line& line : scene.lines)
        for (SurfaceLine& part : cut(line.line, side, 0)) lines.push_back({std::move(part), line.pen});
      scene.lines = std::move(lines);
      std::erase_if(scene.dots, [&](const Vec<3>& dot) { return side.normal.dot(dot - side.point) > 0; });
    }
}

std::vector<Vec3> plain_points(const Points& points) {
  std::vector<Vec3> result;
  for (Eigen::Index i = 0; i < points.cols(); ++i) result.push_back({points(0, i), points(1, i), points(2, i)});
  return result;
}

/// The corners of a triangle in the order that the renderer takes for the side its normals show.
std::array<int, 3> turned(const Surface& surface, Eigen::Index triangle) {
  const int a = surface.triangles(0, triangle), b = surface.triangles(1, triangle), c = surface.triangles(2, triangle);
  const Vec<3> facing =
                   (surface.points.col(b) - surface.points.col(a)).cross(surface.points.col(c) - surface.points.col(a)),
               normal = surface.normals.col(a) + surface.normals.col(b) + surface.normals.col(c);
  return facing.dot(normal) < 0 ? std::array{a, c, b} : std::array{a, b, c};
}

Shaded shaded(const Surface& surface, const std::array<double, 2>& range, const std::vector<Rgb>& colours) {
  Shaded result{plain_points(surface.points), plain_points(surface.normals), {}, {}, range, colours};
  for (Eigen::Index t = 0; t < surface.triangles.cols(); ++t) result.triangles.push_back(turned(surface, t));
  result.values.assign(surface.values.data(), surface.values.data() + surface.values.size());
  if (surface.values.size() == 0) {
    result.values.assign(result.points.size(), range[0]);
    result.colours = {plain_colour, plain_colour};
  }
  return result;
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
  Eigen::Index triangle;
  double depth; ///< of its middle
};

/// Translucent triangles, the farthest first.
void add_veils(Veil& result, const std::vector<Sheer>& veils) {
  std::vector<Waiting> queue;
  for (const Sheer& veil : veils)
    for (Eigen::Index t = 0; t < veil.surface.triangles.cols(); ++t) {
      double depth = 0, facing = 0;
      for (int corner : veil.surface.triangles.col(t))
        depth += veil.surface.points(2, corner) / 3, facing += veil.surface.normals(2, corner);
      if (!veil.facing_only || facing > 0) queue.push_back({&veil, t, depth});
    }
  std::stable_sort(queue.begin(), queue.end(), [](const Waiting& a, const Waiting& b) { return a.depth < b.depth; });
  for (const Waiting& next : queue) {
    const Sheer& veil = *next.veil;
    for (int corner : turned(veil.surface, next.triangle)) {
      const Vec<3> p = veil.surface.points.col(corner), n = veil.surface.normals.col(corner);
      result.corners.push_back({p[0], p[1], p[2]});
      result.normals.push_back({n[0], n[1], n[2]});
    }
    result.colours.push_back({veil.colour[0], veil.colour[1], veil.colour[2], veil.opacity});
  }
}

void add_relief(Relief& relief, const Scene& scene, const std::array<double, 2>& range, const std::vector<Rgb>& colours,
                const Style& style) {
  for (const Surface& surface : scene.bodies) relief.surfaces.push_back(shaded(surface, range, colours));
  for (const Line& line : scene.lines) {
    Pen pen = line.pen;
    pen.width = width_of(line);
    if (pen.width > 0) add_ribbon(relief.ink, line.line.points, line.line.normals, pen);
  }
  for (const Vec<3>& dot : scene.dots) {
    add_dot(relief.ink, dot + 12 * style.unit * Vec<3>::UnitZ(), 6.4 * style.unit, white);
    add_dot(relief.ink, dot + 13 * style.unit * Vec<3>::UnitZ(), 4.8 * style.unit, net_colour);
  }
  add_veils(relief.veil, scene.veils);
}

std::optional<ColouredValues> values_of(const std::vector<Scene>& scenes) {
  std::vector<const VectorX*> values;
  for (const Scene& scene : scenes)
    for (const Surface& surface : scene.bodies) values.push_back(&surface.values);
  return coloured_values(values);
}

} // namespace

Plate make_plate(const std::vector<SolidPanel>& panels, const SolidOptions& options) {
  check_columns(options);
  check(panels);
  const Style style = style_of(options);
  const std::vector<Rgb> colours = colormap(options.colormap);
  const Mat<3> axes = picture_axes(options.camera);
  std::vector<Scene> scenes = scenes_of(panels, axes, style);
  std::vector<std::string> titles;
  for (const SolidPanel& panel : panels) titles.push_back(panel.title);
  const ModelBoxes boxes = widened(paper_boxes(scenes, options, axes), options);
  const auto values = values_of(scenes);
  std::optional<std::array<double, 2>> range;
  if (values) range = colour_range(*values, options.range, is_diverging(options.colormap), options.field_label);
  const auto shown = options.bar ? range : std::nullopt;
  const auto [left, right, below, above] = triad_room(axes, style);
  ArrowRoom arrows{0, 0};
  if (options.axis_names) arrows = {left + right + 0.3 * style.margin, below + above};
  const Sheet sheet = lay_out_sheet(titles, boxes, options, shown, style, arrows);

  Drawing drawing{sheet.size, {}};
  Relief relief;
  for (std::size_t p = 0; p < panels.size(); ++p) {
    const Frame& frame = sheet.frames[p];
    put_on_paper(scenes[p], frame);
    if (options.region) {
      trim(scenes[p], frame.box);
      draw_frame(drawing, frame, style);
    }
    add_relief(relief, scenes[p], range.value_or(std::array<double, 2>{0, 1}), colours, style);
    draw_names(drawing, panels[p].names, axes, frame, style);
    draw_marks(drawing, within(on_paper(panels[p].marks, axes, frame), frame.box, !options.region, style), frame.box,
               style);
    draw_panel_title(drawing, titles[p], frame, sheet.panel_title_size, style);
  }
  if (options.axis_names) draw_triad(drawing, {sheet.arrows[0] + left, sheet.arrows[1] + below}, axes, style);
  if (options.ruler)
    draw_ruler(drawing, {sheet.whole[0], sheet.whole[2] - ruler_room(style)}, sheet.frames.back().x, options.unit,
               style);
  if (shown) draw_colorbar(drawing, sheet.bar, *range, values->all, colours, options.field_label, style);
  draw_title(drawing, options.title, sheet.whole, style);
  return {std::move(drawing), {}, std::move(relief), sheet.frames};
}

void align(SolidOptions& options, const std::vector<SolidPanel>& panels) {
  check(panels);
  const Mat<3> axes = picture_axes(options.camera);
  const std::vector<Scene> scenes = scenes_of(panels, axes, style_of(options));
  options.extent = hull(paper_boxes(scenes, options, axes));
  if (const auto values = values_of(scenes))
    options.range = colour_range(*values, options.range, is_diverging(options.colormap), options.field_label);
}

void draw_solids(const std::vector<SolidPanel>& panels, const SolidOptions& options, const std::string& file) {
  const Format format = format_of(file);
  write_whole(file, bytes_of(figure_of(make_plate(panels, options)), format, options.transparent));
}

} // namespace signorini::view
