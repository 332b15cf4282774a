#include "bind/state_frame.hpp"

#include "bind/marks.hpp"
#include "bind/model.hpp"
#include "bind/number_text.hpp"
#include "bind/patch.hpp"
#include "bind/patch_frame.hpp"

#include <algorithm>

namespace signorini::bind {

const std::vector<std::string> state_keys = {"model",     "field",          "factor", "deformed", "undeformed",
                                             "mesh",      "control_points", "mirror", "cut",      "bodies",
                                             "obstacles", "marks",          "patch",  "names"};

namespace {

const std::vector<std::string> axis_names = {"x", "y", "z", "-x", "-y", "-z"};

Vec<3> unit(const std::string& axis) {
  return (axis[0] == '-' ? -1.0 : 1.0) * Vec<3>::Unit(axis.back() - 'x');
}

template <int D> std::string read_label(const Showing& showing) {
  if (showing.field.empty()) return "";
  const std::string label = field_label<D>(showing.field);
  return showing.factor == 1 ? label : number_text(showing.factor) + " × " + label;
}

/// The bodies that are named; all when none are.
template <int D> std::vector<int> read_bodies(lua_State* L, const Options& o, const Model<D>& model) {
  const int all = static_cast<int>(model->system.scene.bodies.size());
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

/// What is asked for but the field, which comes from `field` or `fields`.
Showing read_showing(const Options& o, bool solid) {
  Showing showing;
  showing.factor = o.number("factor", "multiplies the field", 1.0);
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
  return showing;
}

std::vector<StateFrame> read_state(lua_State* L, const Options& o, const std::vector<std::string>& fields,
                                   const ReadWindows& windows, const Model<2>* plane, const Model<3>* solid) {
  const int top = lua_gettop(L);
  Showing showing = read_showing(o, solid);
  if (fields[0].empty() && o.has("factor"))
    throw ArgumentError(text(function_name(L), ": factor has no field to multiply: name one, as in field = \"uy\""));
  if (plane && o.has("cut"))
    throw ArgumentError(text(function_name(L), ": cut is for models of solids, this one is plane"));
  if (!showing.deformed && o.has("marks"))
    throw ArgumentError(text(function_name(L), ": marks stand in the present state, which deformed = false hides: "
                                               "leave one of them out"));
  showing.bodies = solid ? read_bodies(L, o, *solid) : read_bodies(L, o, *plane);
  showing.windows = windows(solid);
  for (char letter : showing.mirror)
    for (std::size_t i = 0, count = showing.windows.size(); i < count; ++i)
      showing.windows.push_back(mirrored(showing.windows[i], letter - 'x'));
  std::vector<StateFrame> states;
  for (const std::string& field : fields) {
    showing.field = field;
    StateFrame& state = states.emplace_back();
    state.label = solid ? read_label<3>(showing) : read_label<2>(showing);
    if (solid)
      state.panel = show(**solid, showing, read_cut(L, o));
    else
      state.panel = show(**plane, showing);
    std::visit([&](auto& one) { one.marks = read_marks(L, o, solid ? 3 : 2); }, state.panel);
  }
  lua_settop(L, top);
  return states;
}

/// Patches before they are bodies have no state.
StateFrame read_shape(lua_State* L, const Options& o, const ReadWindows& windows) {
  const int top = lua_gettop(L);
  for (const char* key : {"model", "field", "factor", "deformed", "undeformed", "mirror", "cut", "bodies", "obstacles"})
    if (o.has(key))
      throw ArgumentError(text(function_name(L), ": ", key,
                               " is for models, and patch draws a shape that is none yet: ", "leave one of them out"));
  const std::vector<nurbs::Patch> patches = read_patches(L, o);
  PatchShowing showing;
  showing.mesh = o.flag("mesh", "draw element borders", true);
  showing.control_points = o.flag("control_points", "draw control points and the net between them", false);
  showing.names = o.flag("names", "name faces and directions", true);
  showing.windows = windows(patches.front().dimension() == 3);
  StateFrame state{show(patches, showing), ""};
  std::visit([&](auto& one) { one.marks = read_marks(L, o, patches.front().dimension()); }, state.panel);
  lua_settop(L, top);
  return state;
}

/// Puts a model back into the state in which it was.
template <int D> class Return {
public:
  explicit Return(Model<D> model) : model_(std::move(model)), state_(model::snapshot(*model_)) {}
  ~Return() { model::restore(*model_, state_); }
  Return(const Return&) = delete;
  Return& operator=(const Return&) = delete;

private:
  Model<D> model_;
  model::Snapshot<D> state_;
};

/// The kept state on top of the stack, as each of the fields shows it.
template <int D>
std::vector<StateFrame> show_kept(lua_State* L, const Options& o, const std::vector<std::string>& fields,
                                  const ReadWindows& windows, const Snapshot<D>& kept) {
  const Return<D> back(kept.model);
  model::restore(*kept.model, kept.state);
  if constexpr (D == 2)
    return read_state(L, o, fields, windows, &kept.model, nullptr);
  else
    return read_state(L, o, fields, windows, nullptr, &kept.model);
}

bool is_of(const Snapshot<2>* plane, const Snapshot<3>* solid, const void* model) {
  return (plane ? static_cast<const void*>(plane->model.get()) : solid->model.get()) == model;
}

/// The model that is named beside the states; nothing when none is.
const void* named_model(lua_State* L, const Options& o) {
  if (!o.has("model")) return nullptr;
  if (const Model<3>* solid = test_object<Model<3>>(L, o.push_value("model"))) return solid->get();
  return o.object<Model<2>>("model", "made by sg.model").get();
}

} // namespace

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

std::string read_field(const Options& o) {
  return o.string("field", "such as \"uy\" or \"von_mises\"", "");
}

std::vector<std::string> read_fields(lua_State* L, const Options& o) {
  if (!o.has("fields")) return {read_field(o)};
  if (o.has("field")) throw ArgumentError(text(function_name(L), ": field and fields are both given: leave one out"));
  const Argument argument = o.argument("fields", "names of fields, such as \"uy\" or \"von_mises\"");
  const int list = o.push_value("fields"), count = read_list(L, list, argument, "a list of names");
  if (count == 0) reject(L, list, argument, "a list of at least one name");
  std::vector<std::string> fields;
  for (int i = 1; i <= count; ++i) {
    lua_rawgeti(L, list, i);
    fields.push_back(read_string(L, -1, {text("fields[", i, "]"), argument.meaning}));
    lua_pop(L, 1);
  }
  return fields;
}

std::vector<StateFrame> read_state(lua_State* L, const Options& o, const std::vector<std::string>& fields,
                                   const ReadWindows& windows) {
  if (o.has("patch")) return {read_shape(L, o, windows)};
  if (o.has("names"))
    throw ArgumentError(text(function_name(L), ": names are those of a patch's faces and directions: give patch = …"));
  const int value = o.push_value("model");
  const Model<3>* solid = test_object<Model<3>>(L, value);
  const Model<2>* plane = solid ? nullptr : &o.object<Model<2>>("model", "made by sg.model");
  return read_state(L, o, fields, windows, plane, solid);
}

std::vector<std::vector<StateFrame>> read_states(lua_State* L, const Options& o, const std::vector<std::string>& fields,
                                                 const ReadWindows& windows) {
  const Argument argument = o.argument("states", "what a run has kept");
  constexpr const char* expected = "a list of states made by run:states()";
  const void* model = named_model(L, o);
  const int list = o.push_value("states"), count = read_list(L, list, argument, expected);
  if (count == 0) reject(L, list, argument, "a list of at least one state", "the run has kept none");
  std::vector<std::vector<StateFrame>> by_field;
  for (int i = 1; i <= count; ++i) {
    const Argument entry{text("states[", i, "]"), argument.meaning};
    lua_rawgeti(L, list, i);
    if (lua_type(L, -1) != LUA_TTABLE) reject(L, -1, entry, "a state made by run:states()");
    lua_getfield(L, -1, "snapshot");
    const Snapshot<2>* plane = test_object<Snapshot<2>>(L, lua_gettop(L));
    const Snapshot<3>* solid = test_object<Snapshot<3>>(L, lua_gettop(L));
    if (!plane && !solid) reject(L, -2, entry, "a state made by run:states()");
    if (model && !is_of(plane, solid, model))
      throw ArgumentError(text(function_name(L), ": ", entry.name, " is a state of another model than model"));
    std::vector<StateFrame> frames =
        solid ? show_kept<3>(L, o, fields, windows, *solid) : show_kept<2>(L, o, fields, windows, *plane);
    lua_getfield(L, -2, "title");
    const std::string title = read_string(L, -1, {entry.name + ".title", "line above this state"});
    by_field.resize(frames.size());
    for (std::size_t f = 0; f < frames.size(); ++f) {
      frames[f].set_title(title);
      by_field[f].push_back(std::move(frames[f]));
    }
    lua_settop(L, list);
  }
  return by_field;
}

} // namespace signorini::bind
