#include "base/warning.hpp"
#include "bind/draft.hpp"
#include "bind/functions.hpp"
#include "bind/open.hpp"

#include <algorithm>

namespace signorini::bind {

namespace {

template <int D> std::vector<model::NamedBody<D>> read_bodies(lua_State* L, const Options& o) {
  std::vector<model::NamedBody<D>> bodies;
  o.each("bodies", "the bodies by name", [&](const std::string& name, int index, const Argument& entry) {
    const Body<D>& body = read_object<Body<D>>(L, index, entry);
    for (const auto& other : bodies)
      if (other.body == body)
        throw ArgumentError(text(function_name(L), ": bodies.", name, " is the same body as bodies.", other.name,
                                 ": make one with sg.body for each"));
    bodies.push_back({name, body});
  });
  return bodies;
}

/// Names become columns ("grip.fx") and stage keys, so no two things share one and none is a key of a stage.
template <int D>
void check_name(lua_State* L, const model::Scene<D>& scene, const std::string& name, const Argument& entry) {
  const auto clash = [&](const auto& items, const char* kind) {
    if (std::any_of(items.begin(), items.end(), [&](const auto& item) { return item.name == name; }))
      throw ArgumentError(text(function_name(L), ": ", entry.name, " has the name of a ", kind, ": columns such as '",
                               name, ".fx' would mean both; choose another name"));
  };
  clash(scene.supports, "support");
  clash(scene.loads, "load");
  if (name == "name" || name == "steps")
    throw ArgumentError(text(function_name(L), ": ", entry.name, " cannot be called '", name,
                             "', which is a key of stages: choose another name"));
}

bool has_field(lua_State* L, int index, const char* name) {
  if (!lua_istable(L, index)) return false;
  const bool present = lua_getfield(L, index, name) != LUA_TNIL;
  lua_pop(L, 1);
  return present;
}

/// 2 or 3: the first body's. Where there is no body at all, read_bodies() says so.
int dimension_of(lua_State* L, const Options& o) {
  int dimension = 0;
  o.each("bodies", "the bodies by name", [&](const std::string&, int index, const Argument&) {
    if (dimension == 0) dimension = test_object<Body<3>>(L, index) ? 3 : 2;
  });
  return dimension;
}

/// Whether the scene is one of revolution.
bool read_kind(lua_State* L, const Options& o, int dimension) {
  if (dimension == 3 && o.has("kind"))
    throw ArgumentError(text(
        function_name(L), ": kind says what the plane stands for, but the bodies are solids in 3D: ", "leave it out"));
  return o.choice("kind", "what the plane stands for", {"plane_strain", "axisymmetric"}, "plane_strain") ==
         "axisymmetric";
}

/// The bodies as bodies of revolution.
void revolve(lua_State* L, model::Scene<2>& scene) {
  for (auto& named : scene.bodies) try {
      named.body = solid::revolved(*named.body);
    } catch (const Error& error) {
      throw ArgumentError(text(function_name(L), ": bodies.", named.name, ": ", error.what()));
    }
}

template <int D> void push_model(lua_State* L, const Options& o) {
  Draft<D> draft;
  model::Scene<D>& scene = draft.scene;
  if (read_kind(L, o, D)) scene.kind = solid::Kind::axisymmetric;
  scene.bodies = read_bodies<D>(L, o);
  // A load may stand among the supports: both are what holds and moves a body from outside.
  for (const char* key : {"supports", "loads"})
    if (o.has(key))
      o.each(key, "supports or loads by name", [&](const std::string& name, int index, const Argument& entry) {
        check_name(L, scene, name, entry);
        const bool load = has_field(L, index, "traction") || has_field(L, index, "pressure");
        if (load || std::string(key) == "loads")
          scene.loads.push_back(read_load(L, scene, name, index, entry));
        else
          scene.supports.push_back(read_support(L, draft, name, index, entry));
      });
  if (o.has("contacts")) {
    const int contacts = o.push_value("contacts");
    if (lua_istable(L, contacts) && (has_field(L, contacts, "slave") || has_field(L, contacts, "master")))
      throw ArgumentError(text(function_name(L),
                               ": contacts holds one contact that has no name: write contacts = { name = "
                               "{ slave = …, master = …, penalty = … } }"));
    lua_settop(L, contacts - 1);
    o.each("contacts", "the contacts by name", [&](const std::string& name, int index, const Argument& entry) {
      check_name(L, scene, name, entry);
      scene.contacts.push_back(read_contact(L, draft, name, index, entry));
    });
  }
  if constexpr (D == 2)
    if (scene.kind == solid::Kind::axisymmetric) revolve(L, scene);
  const auto& made = push_object<Model<D>>(L, std::make_shared<model::Model<D>>(std::move(scene)));
  count_memory(L, model::memory(*made));
  for (const std::string& warning : model::warnings(*made)) warn(warning);
}

int make_model(lua_State* L) {
  const Options o(L, 1, {"bodies", "supports", "loads", "contacts", "kind"});
  if (dimension_of(L, o) == 3)
    push_model<3>(L, o);
  else
    push_model<2>(L, o);
  return 1;
}

constexpr Function scene_functions[] = {
    {"model", make_model,
     "sg.model{ bodies, supports, loads, contacts, kind = \"plane_strain\" }\n"
     "A scene of plane bodies or of solids. Plane: of unit depth, or with kind = \"axisymmetric\" one of revolution:\n"
     "x is the radius, y the axis, forces are those over the full circle. All parts are tables by name:\n"
     "  bodies   = { die = die, slab = slab }\n"
     "  supports = { bed  = { on = slab:face \"south\", fix = \"xy\" },\n"
     "               grip = { on = {die:face \"west\", die:face \"east\"}, drive = \"xy\" },\n"
     "               edge = { on = strip:face \"east\", rotate = true },\n"
     "               half = { on = {die:face \"north\", slab:face \"west\"}, symmetry = true } }\n"
     "  loads    = { push = { on = ring:face \"east\", traction = {0, -1} }, gas = { on = face, pressure = 2 } }\n"
     "  contacts = { interface = { slave = die:face \"south\", master = slab:face \"north\", penalty = 100,\n"
     "                             friction = { mu = 0.2, penalty = 100 }, points = 3(p+1),\n"
     "                             where = function(X) … end },\n"
     "               film = { slave = strip:face \"south\",\n"
     "                        master = sg.rigid.plane{ point = {0, 0}, normal = {0, 1} },\n"
     "                        adhesion = { hamaker = 0.1, r0 = 0.4 } } }\n"
     "In 3D:\n"
     "  supports = { bed  = { on = slab:face \"front\", fix = \"xyz\" },\n"
     "               grip = { on = punch:face \"back\", drive = \"z\", fix = \"xy\", rotate = \"z\" } }\n"
     "  loads    = { push = { on = block:face \"east\", traction = {0, 0, -1} } }\n"
     "on: a face, a list of faces (their reactions add up), a corner, in 3D an edge, or an obstacle. fix, drive:\n"
     "\"x\", \"xy\", in 3D \"xyz\" and so on; stages move what is driven. rotate: the face turns as a rigid body\n"
     "about its centroid by an angle in degrees that stages give (after the driven components); translations that\n"
     "are neither fixed nor driven are free, which free = \"xy\" may say. In 3D rotate names the axis through the "
     "centroid, \"x\", \"y\", \"z\"\n"
     "or a vector {ax, ay, az}, and a list of faces turns as one. symmetry: the faces lie in one plane\n"
     "across an axis, their normal component is held. Loads are dead: force per reference area; pressure\n"
     "acts against the outward normal; the value given here acts from the first step on, stages change it.\n"
     "slave: the face that is integrated over with `points` Gauss points per element and direction; master: the face\n"
     "or obstacle that it is projected onto. penalty: pressure per length. mu: Coulomb's coefficient, tan of the "
     "angle\n"
     "of friction, not the angle. adhesion: van der Waals traction with\n"
     "Hamaker's constant (force times length) and r0 (length) in place of penalty and friction. where: whether the\n"
     "contact acts at a reference position X = {x, y} ({x, y, z}) of the slave face. Beyond an open end of the\n"
     "master the traction fades over a fifth of its last element. More on these parts: help \"support\", \"load\", "
     "\"contact\"; on the path: help \"stage\".\n"
     "Example: sg.model{ bodies = { slab = slab }, supports = { bed = { on = slab:face \"south\", fix = \"x\", drive = "
     "\"y\" } },\n"
     "                   contacts = { roof = { slave = slab:face \"north\", penalty = 100,\n"
     "                                         master = sg.rigid.plane{ point = {0, 1}, normal = {0, -1} } } } }"},
};

} // namespace

void open_scene(lua_State* L) {
  register_functions(L, "sg", scene_functions);
}

} // namespace signorini::bind
