#include "view/picture.hpp"

#include "bind/functions.hpp"
#include "bind/open.hpp"
#include "bind/scene.hpp"
#include "model/tessellate.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::bind {

namespace {

/// A state as it is drawn, free of its model, and what its colours mean.
struct StateFrame {
  view::Panel panel;
  std::string label;
};

} // namespace

template <> struct Type<StateFrame> { static constexpr auto name = "frame"; };

namespace {

/// What shows a model's state, and what lays out a picture of states.
const std::vector<std::string> state_keys = {"model",      "field", "factor",         "deformed",
                                             "undeformed", "mesh",  "control_points", "mirror"};
const std::vector<std::string> picture_keys = {"file", "title", "label", "range", "colormap", "size", "crop"};

std::vector<std::string> joined(std::vector<std::string> keys, const std::vector<std::string>& more) {
  keys.insert(keys.end(), more.begin(), more.end());
  return keys;
}

// ── A state ──────────────────────────────────────────────────────────────────────────────────────────────────────────

/// Pieces per element and direction: enough that a quadratic arc over an eighth of a circle looks round at any size;
/// fewer where elements are so many that each is small.
int divisions_for(int elements) {
  return std::clamp(static_cast<int>(std::sqrt(40000.0 / elements)), 4, 12);
}

/// The points of a tessellation in their order: element by element, row by row.
struct Grid {
  const view::Points& points;
  int divisions;
  std::array<int, 2> elements;

  int index(int element, int i, int j) const {
    const int side = divisions + 1;
    return side * side * element + side * j + i;
  }

  /// An element's border along a direction, at the start or the end of the other one.
  view::Points border(int element, int along, int end) const {
    view::Points line(3, divisions + 1);
    for (int k = 0; k <= divisions; ++k)
      line.col(k) = points.col(along == 0 ? index(element, k, end * divisions) : index(element, end * divisions, k));
    return line;
  }

  /// An element's size across a direction, through its middle.
  double across(int element, int along) const {
    const int half = divisions / 2;
    return along == 0 ? (points.col(index(element, half, divisions)) - points.col(index(element, half, 0))).norm()
                      : (points.col(index(element, divisions, half)) - points.col(index(element, 0, half))).norm();
  }

  /// Whether an element is the first or the last of those across a direction.
  bool is_last(int element, int along, int end) const {
    const int place = along == 0 ? element / elements[0] : element % elements[0];
    return place == (end == 0 ? 0 : elements[static_cast<std::size_t>(1 - along)] - 1);
  }
};

/// Borders between elements, each once.
std::vector<view::MeshLine> mesh_lines(const Grid& grid) {
  std::vector<view::MeshLine> lines;
  for (int e = 0; e < grid.elements[0] * grid.elements[1]; ++e)
    for (int along : {0, 1})
      if (!grid.is_last(e, along, 0)) lines.push_back({grid.border(e, along, 0), grid.across(e, along)});
  return lines;
}

/// The sides of the body, element by element.
std::vector<view::Points> rim(const Grid& grid) {
  std::vector<view::Points> lines;
  for (int along : {0, 1})
    for (int end : {0, 1}) {
      view::Points line(3, 0);
      for (int e = 0; e < grid.elements[0] * grid.elements[1]; ++e)
        if (grid.is_last(e, along, end)) {
          const view::Points piece = grid.border(e, along, end);
          const Eigen::Index kept = std::max<Eigen::Index>(line.cols() - 1, 0); // neighbours share a point
          line.conservativeResize(3, kept + piece.cols());
          line.rightCols(piece.cols()) = piece;
        }
      lines.push_back(std::move(line));
    }
  return lines;
}

/// What becomes of a field's values in the mirror of an axis: components that point along the axis once change sign.
double mirror_sign(const std::string& field, int axis) {
  static const std::vector<std::string> odd[] = {{"ux", "sxy", "F12", "F21"}, {"uy", "sxy", "F12", "F21"}};
  return std::find(odd[axis].begin(), odd[axis].end(), field) == odd[axis].end() ? 1 : -1;
}

void add_mirror_image(view::Panel& panel, int axis, double sign) {
  for (std::size_t i = 0, count = panel.bodies.size(); i < count; ++i)
    panel.bodies.push_back(view::mirrored(panel.bodies[i], axis, sign));
  for (std::size_t i = 0, count = panel.obstacles.size(); i < count; ++i)
    panel.obstacles.push_back(view::mirrored(panel.obstacles[i], axis));
}

/// The rim of a model's rigid obstacle where it stands now, or stood at the start.
view::Outline obstacle(const Model<2>& model, int index, bool deformed) {
  const int first = model->unknowns().obstacle_offset(index);
  const Vec<2> shift = deformed ? Vec<2>(model->displacement().segment<2>(first)) : Vec<2>::Zero();
  const contact::Obstacle<2>& shape = model->scene().obstacles[static_cast<std::size_t>(index)];
  if (const auto* plane = std::get_if<contact::Plane<2>>(&shape))
    return view::half_plane(plane->point + shift, plane->normal);
  if (const auto* ball = std::get_if<contact::Ball<2>>(&shape)) return view::circle(ball->centre + shift, ball->radius);
  const auto& curve = std::get<nurbs::Patch>(shape);
  const nurbs::KnotVector& knots = curve.directions().front();
  constexpr int pieces = 400;
  view::Outline outline{view::Points::Zero(3, pieces + 1)};
  for (int k = 0; k <= pieces; ++k) {
    const double xi = knots.first() + (knots.last() - knots.first()) * k / pieces;
    outline.line.col(k).head<2>() = nurbs::evaluate(curve, VectorX::Constant(1, xi)) + shift;
  }
  return outline;
}

StateFrame read_state(lua_State* L, const Options& o) {
  const Model<2>& model = o.object<Model<2>>("model", "made by sg.model");
  const model::Field<2>* field = nullptr;
  if (o.has("field")) field = &model::find_field<2>(o.string("field", "such as \"uy\" or \"von_mises\""));
  const double factor = o.number("factor", "multiplies the field", 1.0);
  if (!field && o.has("factor"))
    throw ArgumentError(text(function_name(L), ": factor has no field to multiply: name one, as in field = \"uy\""));
  const bool deformed = o.flag("deformed", "draw the present state, not the reference", true);
  const bool undeformed = o.flag("undeformed", "draw the reference shape's outline", false);
  const bool mesh = o.flag("mesh", "draw element borders", true);
  const bool control_points = o.flag("control_points", "draw control points and their rows", false);

  StateFrame state;
  if (field) state.label = factor == 1 ? field->label : text(factor, " × ", field->label);
  for (int b = 0; b < static_cast<int>(model->scene().bodies.size()); ++b) {
    const nurbs::Discretisation& space = model->scene().bodies[static_cast<std::size_t>(b)].body->space();
    const std::array<int, 2> elements = {space.elements(0), space.elements(1)};
    const int divisions = divisions_for(space.elements());
    model::Tessellation sampled = model::tessellate(*model, b, field, divisions, deformed);
    view::Body body;
    body.points = std::move(sampled.points);
    body.triangles = std::move(sampled.triangles);
    body.values = factor * sampled.values;
    const Grid grid{body.points, divisions, elements};
    body.rim = rim(grid);
    if (mesh) body.mesh_lines = mesh_lines(grid);
    if (control_points) {
      body.control_points = std::move(sampled.control_points);
      body.net_lines = std::move(sampled.net_lines);
    }
    if (undeformed) {
      const view::Points reference = model::tessellate(*model, b, nullptr, divisions, false).points;
      body.undeformed = rim({reference, divisions, elements});
    }
    state.panel.bodies.push_back(std::move(body));
  }
  for (int k = 0; k < static_cast<int>(model->scene().obstacles.size()); ++k)
    state.panel.obstacles.push_back(obstacle(model, k, deformed));
  if (o.has("mirror"))
    for (char letter : o.choice("mirror", "axis across which the model is continued", {"x", "y", "xy"})) {
      const int axis = letter == 'x' ? 0 : 1;
      add_mirror_image(state.panel, axis, field ? mirror_sign(field->name, axis) : 1);
    }
  return state;
}

int frame(lua_State* L) {
  const Options o(L, 1, joined(state_keys, {"title"}));
  StateFrame state = read_state(L, o);
  state.panel.title = o.string("title", "line above this state", "");
  push_object(L, std::move(state));
  return 1;
}

int frame_tostring(lua_State* L) {
  const StateFrame& state = self<StateFrame>(L);
  const std::string &title = state.panel.title, &label = state.label;
  push(L, text("frame", title.empty() ? "" : " '" + title + "'", " of ", state.panel.bodies.size(),
               state.panel.bodies.size() == 1 ? " body" : " bodies", label.empty() ? "" : ", coloured by " + label));
  return 1;
}

// ── A picture ────────────────────────────────────────────────────────────────────────────────────────────────────────

constexpr int largest_size = 5000; // OpenGL's limit after supersampling

/// A pair is the picture's size. A number is the most it may be wide, and half of the most it may be high. Nothing
/// stands for 1600 × 1000 at most, for sheets 1600 × 2000.
void read_size(lua_State* L, const Options& o, view::PictureOptions& options) {
  options.trim = true;
  if (o.has("frames")) options.size = {1600, 2000};
  if (!o.has("size")) return;
  const Argument argument = o.argument("size", "width and height in pixels, or the greatest width");
  const int value = o.push_value("size");
  if (lua_type(L, value) == LUA_TNUMBER) {
    const int width = read_integer(L, value, argument, 160, largest_size);
    options.size = {width, std::min(2 * width, largest_size)};
    return;
  }
  const auto size = read_integers(L, value, argument, 120, largest_size);
  if (size.size() != 2) reject(L, value, argument, "a whole number or a list of 2 whole numbers");
  options.size = {size[0], size[1]};
  options.trim = false;
}

/// The frames of a sheet, and what all their colours mean.
std::vector<view::Panel> read_frames(lua_State* L, const Options& o, std::string& label) {
  for (const std::string& key : state_keys)
    if (o.has(key.c_str()))
      throw ArgumentError(
          text(function_name(L), ": ", key, " belongs to each of the frames: give it to sg.frame{ … }"));
  const Argument argument = o.argument("frames", "made by sg.frame");
  const int list = o.push_value("frames"), count = read_list(L, list, argument, "a list of frames");
  if (count == 0) reject(L, list, argument, "a list of at least one frame", "add one made by sg.frame{ … }");
  std::vector<view::Panel> panels;
  for (int i = 1; i <= count; ++i) {
    lua_rawgeti(L, list, i);
    const StateFrame& state = read_object<StateFrame>(L, -1, {text("frames[", i, "]"), argument.meaning});
    if (i == 1) label = state.label;
    if (state.label != label && !o.has("label"))
      throw ArgumentError(text(function_name(L), ": frames[", i, "] shows '", state.label, "' and frames[1] '", label,
                               "': one colour bar serves all frames, give them one field, or name the bar by label"));
    panels.push_back(state.panel);
    lua_pop(L, 1);
  }
  return panels;
}

int picture(lua_State* L) {
  const Options o(L, 1, joined(joined(state_keys, picture_keys), {"frames", "columns"}));
  const std::string file = o.string("file", "a name that ends with .png");
  view::PictureOptions options;
  options.title = o.string("title", "line above the picture", "");
  options.colormap = o.choice("colormap", "colours of the field", view::colormaps(), options.colormap);
  read_size(L, o, options);
  if (o.has("range")) {
    const VectorX range = o.point("range", "lowest and highest value", 2, 2);
    options.range = {range[0], range[1]};
  }
  if (o.has("crop")) {
    const std::vector<double> crop = o.numbers("crop", "xmin, xmax, ymin, ymax");
    if (crop.size() != 4)
      reject(L, o.push_value("crop"), o.argument("crop", "xmin, xmax, ymin, ymax"), "a list of 4 numbers");
    options.crop = {crop[0], crop[1], crop[2], crop[3]};
  }
  std::vector<view::Panel> panels;
  if (o.has("frames")) {
    panels = read_frames(L, o, options.field_label);
    if (o.has("columns")) options.columns = o.integer("columns", "frames in a row", 1, 100);
  } else {
    if (o.has("columns")) throw ArgumentError(text(function_name(L), ": columns needs frames = {…}, made by sg.frame"));
    StateFrame state = read_state(L, o);
    options.field_label = state.label;
    panels.push_back(std::move(state.panel));
  }
  if (o.has("label")) {
    if (options.field_label.empty())
      throw ArgumentError(text(function_name(L), ": label names a colour bar, but no field is drawn: add field"));
    options.field_label = o.string("label", "title of the colour bar");
  }
  view::draw_sheet(panels, options, file);
  return 0;
}

constexpr Function rows[] = {
    {"picture", wrap<picture>,
     "sg.picture{ model, file, field, factor = 1, label, title, range, colormap = \"viridis\", size, crop,\n"
     "            deformed = true, undeformed = false, mesh = true, control_points = false, mirror }\n"
     "Draws the model's present state to a .png file. field: ux uy u, Cauchy stresses sxx syy szz sxy, von_mises,\n"
     "pressure, I1 (tr sigma), F11 F12 F21 F22; grey without. Stresses are evaluated where they are drawn, not "
     "smoothed.\n"
     "factor multiplies the field; label is the colour bar's title (the field's own); range = {low, high} of the "
     "colours.\n"
     "undeformed adds the reference shape's outline; mirror = \"x\" the mirror image at x = 0, for half models. Rigid "
     "obstacles\n"
     "are drawn hatched.\n"
     "size = {width, height} in pixels, or a number: the greatest width, and half the greatest height. Without a pair "
     "the\n"
     "picture is no larger than what it shows; at most 1600 x 1000, sheets 1600 x 2000. crop = {xmin, xmax, ymin, "
     "ymax}.\n"
     "sg.picture{ frames = {…}, file, columns, … } draws states kept by sg.frame side by side, with one colour bar.\n"
     "Example: sg.picture{ model = model, field = \"uy\", file = \"die.png\" }"},
    {"frame", wrap<frame>,
     "sg.frame{ model, title, field, factor, deformed, undeformed, mesh, control_points, mirror }\n"
     "Keeps the model's present state for a picture of several; arguments as in sg.picture.\n"
     "Example: local frames = {}\n"
     "         model:run(stages, { on_step = function(info)\n"
     "           if info.step % 10 == 0 then frames[#frames + 1] = sg.frame{ model = model, field = \"uy\" } end\n"
     "         end })\n"
     "         sg.picture{ frames = frames, columns = 2, file = \"states.png\" }"},
};

constexpr Function frame_rows[] = {
    {"__tostring", wrap<frame_tostring>, "tostring(frame)\nThe frame's title and field in words."},
};

} // namespace

void open_picture(lua_State* L) {
  register_functions(L, "sg", rows);
  register_type<StateFrame>(L, frame_rows);
}

} // namespace signorini::bind
