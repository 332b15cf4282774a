#include "bind/frame.hpp"
#include "bind/functions.hpp"
#include "bind/marks.hpp"
#include "bind/model.hpp"
#include "bind/open.hpp"

#include <algorithm>
#include <variant>

namespace signorini::bind {

namespace {

/// A state as it is drawn, and what its colours mean.
struct StateFrame {
  std::variant<view::Panel, view::SolidPanel> panel;
  std::string label;

  const std::string& title() const {
    return std::visit([](const auto& one) -> const std::string& { return one.title; }, panel);
  }
  void set_title(std::string title) {
    std::visit([&](auto& one) { one.title = std::move(title); }, panel);
  }
  std::size_t bodies() const {
    return std::visit([](const auto& one) { return one.bodies.size(); }, panel);
  }
  bool solid() const { return std::holds_alternative<view::SolidPanel>(panel); }
};

} // namespace

template <> struct Type<StateFrame> { static constexpr auto name = "frame"; };

namespace {

/// What shows a model's state, and what lays out a picture of states.
const std::vector<std::string> state_keys = {"model",          "field",  "factor", "deformed", "undeformed", "mesh",
                                             "control_points", "mirror", "cut",    "bodies",   "obstacles",  "marks"};
const std::vector<std::string> picture_keys = {"file", "title", "label", "range", "colormap", "size", "crop", "camera"};

std::vector<std::string> joined(std::vector<std::string> keys, const std::vector<std::string>& more) {
  keys.insert(keys.end(), more.begin(), more.end());
  return keys;
}

// ── A state ──────────────────────────────────────────────────────────────────────────────────────────────────────────

const std::vector<std::string> axis_names = {"x", "y", "z", "-x", "-y", "-z"};

Vec<3> unit(const std::string& axis) {
  return (axis[0] == '-' ? -1.0 : 1.0) * Vec<3>::Unit(axis.back() - 'x');
}

/// "y", or { normal = …, point = … }, or { normal = "y", at = … }.
std::optional<Cut> read_cut(lua_State* L, const Options& o) {
  if (!o.has("cut")) return std::nullopt;
  constexpr const char* meaning = "the half on this side is taken away";
  const int value = o.push_value("cut"), type = lua_type(L, value);
  if (type == LUA_TSTRING) return Cut{unit(o.choice("cut", meaning, axis_names))};
  if (type != LUA_TTABLE)
    reject(L, value, o.argument("cut", meaning), "an axis such as \"y\" or \"-y\", or a table with normal and point");
  const Options c = o.table("cut", {"normal", "point", "at"});
  const int normal = c.push_value("normal");
  Cut cut;
  if (lua_type(L, normal) == LUA_TSTRING) {
    cut.normal = unit(c.choice("normal", meaning, axis_names));
    if (c.has("at")) cut.point = c.number("at", "where the plane meets the normal's axis") * cut.normal.cwiseAbs();
  } else {
    cut.normal = c.point("normal", "points to the half that is taken away", 3, 3);
    if (cut.normal.norm() == 0)
      reject(L, normal, c.argument("normal", "points to the half that is taken away"), "a vector that is not zero");
    if (c.has("at"))
      throw ArgumentError(text(function_name(L), ": cut.at needs an axis as cut.normal, such as \"y\"; with a vector "
                                                 "give cut.point"));
  }
  if (c.has("point")) {
    if (cut.point) throw ArgumentError(text(function_name(L), ": cut has both at and point; give one of them"));
    cut.point = c.point("point", "a point of the plane", 3, 3);
  }
  return cut;
}

template <int D> std::string read_label(const Options& o, const Showing& showing) {
  if (!o.has("field")) return "";
  const std::string label = field_label<D>(showing.field);
  return showing.factor == 1 ? label : text(showing.factor, " × ", label);
}

/// The bodies that are named; all when none are.
template <int D> std::vector<int> read_bodies(lua_State* L, const Options& o, const Model<D>& model) {
  const int all = static_cast<int>(model->scene().bodies.size());
  std::vector<int> bodies;
  if (!o.has("bodies")) {
    for (int b = 0; b < all; ++b) bodies.push_back(b);
    return bodies;
  }
  const Argument argument = o.argument("bodies", "names of the bodies to be drawn");
  const int list = o.push_value("bodies"), count = read_list(L, list, argument, "a list of names");
  if (count == 0) reject(L, list, argument, "a list of at least one name");
  for (int i = 1; i <= count; ++i) {
    lua_rawgeti(L, list, i);
    bodies.push_back(find_body(L, model, read_string(L, -1, {text("bodies[", i, "]"), "name of a body"})));
    lua_pop(L, 1);
  }
  return bodies;
}

StateFrame read_state(lua_State* L, const Options& o) {
  const int value = o.push_value("model");
  const Model<3>* solid = test_object<Model<3>>(L, value);
  if (!solid) o.object<Model<2>>("model", "made by sg.model");
  Showing showing;
  showing.field = o.string("field", "such as \"uy\" or \"von_mises\"", "");
  showing.factor = o.number("factor", "multiplies the field", 1.0);
  StateFrame state;
  state.label = solid ? read_label<3>(o, showing) : read_label<2>(o, showing);
  if (!o.has("field") && o.has("factor"))
    throw ArgumentError(text(function_name(L), ": factor has no field to multiply: name one, as in field = \"uy\""));
  showing.deformed = o.flag("deformed", "draw the present state, not the reference", true);
  showing.undeformed = o.flag("undeformed", "draw the reference shape as well", false);
  showing.mesh = o.flag("mesh", "draw element borders", true);
  showing.control_points = o.flag("control_points", "draw control points and their rows", false);
  showing.obstacles = o.flag("obstacles", "draw rigid obstacles", true);
  if (o.has("mirror")) {
    constexpr const char* meaning = "axis across which the model is continued";
    showing.mirror = solid ? o.choice("mirror", meaning, {"x", "y", "z", "xy", "xz", "yz", "xyz"})
                           : o.choice("mirror", meaning, {"x", "y", "xy"});
  }
  if (solid) {
    showing.bodies = read_bodies(L, o, *solid);
    state.panel = show(**solid, showing, read_cut(L, o));
  } else {
    if (o.has("cut")) throw ArgumentError(text(function_name(L), ": cut is for models of solids, this one is plane"));
    const Model<2>& plane = o.object<Model<2>>("model", "made by sg.model");
    showing.bodies = read_bodies(L, o, plane);
    state.panel = show(*plane, showing);
  }
  std::visit([&](auto& one) { one.marks = read_marks(L, o, solid ? 3 : 2); }, state.panel);
  if (!showing.deformed && o.has("marks"))
    throw ArgumentError(text(function_name(L), ": marks stand in the present state, which deformed = false hides: "
                                               "leave one of them out"));
  lua_settop(L, value - 1);
  return state;
}

int frame(lua_State* L) {
  const Options o(L, 1, joined(state_keys, {"title"}));
  StateFrame state = read_state(L, o);
  state.set_title(o.string("title", "line above this state", ""));
  push_object(L, std::move(state));
  return 1;
}

int frame_tostring(lua_State* L) {
  const StateFrame& state = self<StateFrame>(L);
  const std::string &title = state.title(), &label = state.label;
  push(L, text("frame", title.empty() ? "" : " '" + title + "'", " of ", state.bodies(),
               state.bodies() == 1 ? " body" : " bodies", label.empty() ? "" : ", coloured by " + label));
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

/// The frames of a sheet: of one field and one dimension.
std::vector<StateFrame> read_frames(lua_State* L, const Options& o) {
  for (const std::string& key : state_keys)
    if (o.has(key.c_str()))
      throw ArgumentError(
          text(function_name(L), ": ", key, " belongs to each of the frames: give it to sg.frame{ … }"));
  const Argument argument = o.argument("frames", "made by sg.frame");
  const int list = o.push_value("frames"), count = read_list(L, list, argument, "a list of frames");
  if (count == 0) reject(L, list, argument, "a list of at least one frame", "add one made by sg.frame{ … }");
  std::vector<StateFrame> frames;
  for (int i = 1; i <= count; ++i) {
    lua_rawgeti(L, list, i);
    const StateFrame& state = read_object<StateFrame>(L, -1, {text("frames[", i, "]"), argument.meaning});
    frames.push_back(state);
    const std::string& label = frames.front().label;
    if (state.label != label && !o.has("label"))
      throw ArgumentError(text(function_name(L), ": frames[", i, "] shows '", state.label, "' and frames[1] '", label,
                               "': one colour bar serves all frames, give them one field, or name the bar by label"));
    if (state.solid() != frames.front().solid())
      throw ArgumentError(text(function_name(L), ": frames[", i, "] shows a ", state.solid() ? "solid" : "plane",
                               " model and frames[1] does not; draw them in pictures of their own"));
    lua_pop(L, 1);
  }
  return frames;
}

template <class Panel> std::vector<Panel> panels_of(const std::vector<StateFrame>& frames) {
  std::vector<Panel> panels;
  for (const StateFrame& frame : frames) panels.push_back(std::get<Panel>(frame.panel));
  return panels;
}

/// A name, or { from = …, up = … }.
view::Camera read_camera(lua_State* L, const Options& o) {
  constexpr const char* meaning = "where the picture is seen from";
  if (!o.has("camera")) return view::camera("iso");
  const int value = o.push_value("camera"), type = lua_type(L, value);
  if (type == LUA_TSTRING) return view::camera(o.choice("camera", meaning, view::camera_names()));
  if (type != LUA_TTABLE)
    reject(L, value, o.argument("camera", meaning),
           text(one_of(view::camera_names()), ", or a table { from = …, up = … }"));
  const Options c = o.table("camera", {"from", "up"});
  const Vec<3> from = c.point("from", "direction from the model to the eye", 3, 3);
  if (from.norm() == 0)
    reject(L, c.push_value("from"), c.argument("from", "direction from the model to the eye"),
           "a vector that is not zero");
  const bool steep = from.head<2>().norm() < 1e-6 * from.norm();
  const Vec<3> otherwise = steep ? Vec<3>::UnitY() : Vec<3>::UnitZ();
  return {from, c.point("up", "direction that points upwards in the picture", 3, 3, VectorX(otherwise))};
}

/// What of a picture is read the same way for all models.
void read_options(lua_State* L, const Options& o, view::PictureOptions& options) {
  options.title = o.string("title", "line above the picture", "");
  options.colormap = o.choice("colormap", "colours of the field", view::colormaps(), options.colormap);
  read_size(L, o, options);
  if (o.has("range")) {
    const VectorX range = o.point("range", "lowest and highest value", 2, 2);
    options.range = {range[0], range[1]};
  }
}

std::vector<double> read_crop(lua_State* L, const Options& o, const char* meaning, std::size_t count) {
  const std::vector<double> crop = o.numbers("crop", meaning);
  if (crop.size() != count)
    reject(L, o.push_value("crop"), o.argument("crop", meaning), text("a list of ", count, " numbers"));
  return crop;
}

int picture(lua_State* L) {
  const Options o(L, 1, joined(joined(state_keys, picture_keys), {"frames", "columns"}));
  const std::string file = o.string("file", "a name that ends with .png");
  view::SolidOptions options;
  read_options(L, o, options);
  std::vector<StateFrame> frames;
  if (o.has("frames")) {
    frames = read_frames(L, o);
    if (o.has("columns")) options.columns = o.integer("columns", "frames in a row", 1, 100);
  } else {
    if (o.has("columns")) throw ArgumentError(text(function_name(L), ": columns needs frames = {…}, made by sg.frame"));
    frames.push_back(read_state(L, o));
  }
  options.field_label = frames.front().label;
  if (o.has("label")) {
    if (options.field_label.empty())
      throw ArgumentError(text(function_name(L), ": label names a colour bar, but no field is drawn: add field"));
    options.field_label = o.string("label", "title of the colour bar");
  }
  if (frames.front().solid()) {
    options.camera = read_camera(L, o);
    if (o.has("crop")) {
      const std::vector<double> crop = read_crop(L, o, "xmin, xmax, ymin, ymax, zmin, zmax", 6);
      options.region = view::Bounds{{crop[0], crop[2], crop[4]}, {crop[1], crop[3], crop[5]}};
    }
    view::draw_solids(panels_of<view::SolidPanel>(frames), options, file);
  } else {
    if (o.has("camera"))
      throw ArgumentError(text(function_name(L), ": camera is for models of solids, this one is plane"));
    if (o.has("crop")) {
      const std::vector<double> crop = read_crop(L, o, "xmin, xmax, ymin, ymax", 4);
      options.crop = {crop[0], crop[1], crop[2], crop[3]};
    }
    view::draw_sheet(panels_of<view::Panel>(frames), options, file);
  }
  return 0;
}

constexpr Function rows[] = {
    {"picture", wrap<picture>,
     "sg.picture{ model, file, field, factor = 1, label, title, range, colormap = \"viridis\", size, crop, bodies,\n"
     "            deformed = true, undeformed = false, mesh = true, control_points = false, obstacles = true, mirror,\n"
     "            camera = \"iso\", cut, marks, frames, columns }\n"
     "Draws the model's present state to a .png file. field: ux uy u, Cauchy stresses sxx syy szz sxy, von_mises,\n"
     "pressure, I1 (tr sigma), F11 F12 F21 F22; grey without. Stresses are evaluated where they are drawn, not "
     "smoothed.\n"
     "factor multiplies the field; label is the colour bar's title (the field's own); range = {low, high} of the "
     "colours.\n"
     "undeformed adds the reference shape's outline; mirror = \"x\" the mirror image at x = 0, for half models; bodies "
     "= {names}\n"
     "draws these only. Rigid obstacles are drawn hatched.\n"
     "size = {width, height} in pixels, or a number: the greatest width, and half the greatest height. Without a pair "
     "the\n"
     "picture is no larger than what it shows; at most 1600 x 1000, sheets 1600 x 2000. crop = {xmin, xmax, ymin, "
     "ymax}.\n"
     "marks = { { x = {x, y}, text = \"J = -0.2\" }, … } puts rings with crosses at places of the present state, the "
     "first ones\n"
     "first where there is little room for texts; entries may hold what the places of a failed run hold.\n"
     "Solids: also fields uz sxz syz F13 … F33, and contact_pressure on the slave faces (bilinear between contact "
     "points).\n"
     "camera: \"iso\" (from the front, the right and above), \"front\" (from -y, z upwards), \"back\", \"left\" (from "
     "-x), \"right\",\n"
     "\"top\" (from +z, y upwards), \"bottom\", or { from = {direction to the eye}, up = {direction} }; parallel "
     "projection.\n"
     "cut takes a half away: \"y\" that of greater y, \"-y\" that of smaller y, through the middle of the bodies;\n"
     "{ normal = \"y\", at = 0.5 } at y = 0.5; { normal = {…}, point = {…} } the half that the normal points to. The "
     "cut face\n"
     "is coloured by the field inside. undeformed adds the reference shape, translucent; mirror = \"x\" … \"xyz\"; "
     "crop = {xmin,\n"
     "xmax, ymin, ymax, zmin, zmax} zooms to this box. Surfaces are shaded a little: what faces the light has the "
     "colours of\n"
     "the bar. Rigid obstacles are grey and translucent.\n"
     "sg.picture{ frames = {…}, file, columns, camera, … } draws states kept by sg.frame side by side, with one colour "
     "bar.\n"
     "Example: sg.picture{ model = model, field = \"uy\", file = \"die.png\" }\n"
     "Example: sg.picture{ model = solid, field = \"szz\", cut = \"-y\", camera = { from = {1, -2, 1} }, file = "
     "\"cut.png\" }"},
    {"frame", wrap<frame>,
     "sg.frame{ model, title, field, factor, bodies, deformed, undeformed, mesh, control_points, obstacles, mirror, "
     "cut,\n"
     "          marks }\n"
     "Keeps the model's present state for a picture of several; arguments as in sg.picture.\n"
     "Example: local frames = {}\n"
     "         model:run(stages, { on_step = function(info)\n"
     "           if info.step % 2 == 0 then frames[#frames + 1] = sg.frame{ model = model, field = \"uy\" } end\n"
     "         end })\n"
     "         sg.picture{ frames = frames, columns = 2, file = \"states.png\" }"},
};

constexpr Function frame_rows[] = {
    {"__tostring", wrap<frame_tostring>,
     "frame\nWhat sg.frame returns, a state kept for sg.picture{ frames = {…} }; print(frame) tells its title and "
     "field."},
};

} // namespace

void open_picture(lua_State* L) {
  register_functions(L, "sg", rows);
  register_type<StateFrame>(L, frame_rows);
}

} // namespace signorini::bind
