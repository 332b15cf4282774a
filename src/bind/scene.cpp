#include "bind/scene.hpp"

#include "bind/functions.hpp"
#include "bind/open.hpp"

#include <algorithm>

namespace signorini::bind {

namespace {

using model::Hold;

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

template <int D>
int index_of(lua_State* L, const model::Scene<D>& scene, const Place<D>& place, const std::string& where) {
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    if (scene.bodies[b].body == place.body) return static_cast<int>(b);
  throw ArgumentError(text(function_name(L), ": ", where, " is on a body that is not in bodies: add it there"));
}

/// A scene while it is read, with the obstacles that it has met so far.
template <int D> struct Draft {
  model::Scene<D> scene;
  std::vector<Rigid<D>> obstacles;
};

/// Index of an obstacle, new ones appended.
template <int D> int index_of(lua_State* L, Draft<D>& draft, const Rigid<D>& rigid, const std::string& where) {
  const auto found = std::find(draft.obstacles.begin(), draft.obstacles.end(), rigid);
  if (found != draft.obstacles.end()) return static_cast<int>(found - draft.obstacles.begin());
  const bool revolved = draft.scene.kind == solid::Kind::axisymmetric;
  if (rigid->form == RigidForm::sphere && !revolved)
    throw ArgumentError(text(function_name(L), ": ", where, " is a sphere in plane strain: use sg.rigid.cylinder, or ",
                             "kind = \"axisymmetric\" for the model"));
  if (rigid->form == RigidForm::cylinder && revolved)
    throw ArgumentError(text(function_name(L), ": ", where, " is a cylinder across an axisymmetric model: use ",
                             "sg.rigid.sphere with its centre on the axis x = 0"));
  if (const auto* ball = std::get_if<contact::Ball<D>>(&rigid->shape); ball && revolved && ball->centre(0) != 0)
    throw ArgumentError(text(function_name(L), ": ", where, " has its centre at x = ", ball->centre(0),
                             ": in an axisymmetric model a sphere's centre lies on the axis, x = 0"));
  draft.obstacles.push_back(rigid);
  draft.scene.obstacles.push_back(rigid->shape);
  return static_cast<int>(draft.obstacles.size()) - 1;
}

template <int D>
model::FaceReference face_of(lua_State* L, const model::Scene<D>& scene, int index, const Argument& argument) {
  const Place<D>& place = read_object<Place<D>>(L, index, argument);
  if (!place.side) reject(L, index, argument, "a face", "a corner has no surface");
  return {index_of(L, scene, place, argument.name), *place.side};
}

/// Calls add(index on the stack) for one item, or for each of a list.
template <class Add> void each_item(lua_State* L, const Options& o, const Argument& argument, Add add) {
  const int value = o.push_value("on");
  if (!lua_istable(L, value)) return add(value);
  const int count = read_list(L, value, argument);
  if (count == 0) reject(L, value, argument, argument.meaning);
  for (int i = 1; i <= count; ++i) {
    lua_rawgeti(L, value, i);
    add(lua_gettop(L));
    lua_pop(L, 1);
  }
}

template <int D>
void read_components(lua_State* L, const Options& o, const char* key, const char* meaning, Hold hold,
                     model::Support<D>& support) {
  if (!o.has(key)) return;
  for (char letter : o.choice(key, meaning, {"x", "y", "xy"})) {
    Hold& component = support.hold[letter == 'x' ? 0 : 1];
    if (component != Hold::free)
      throw ArgumentError(text(function_name(L), ": ", o.path(), " both fixes and drives ", letter,
                               ": a component is either fixed or driven, take it out of one of the two"));
    component = hold;
  }
}

/// The face that a support turns, and about which point.
template <int D> void read_rotation(lua_State* L, const Options& o, const Argument& on, model::Support<D>& support) {
  support.rotates = o.flag("rotate", "turn the face as a rigid line by the angle that stages give", false);
  if (!support.rotates) return;
  const int value = o.push_value("on");
  const Place<D>* place = test_object<Place<D>>(L, value);
  if (!place || !place->side)
    reject(L, value, on, "one face", "what rotates is one face of a body; give other faces a support of their own");
  support.centre = model::face_centroid(*place->body, *place->side);
}

template <int D>
model::Support<D> read_support(lua_State* L, Draft<D>& draft, const std::string& name, int index,
                               const Argument& entry) {
  const Options o(L, index, {"on", "fix", "drive", "rotate"}, false, entry.name);
  model::Support<D> support;
  support.name = name;
  const Argument on = o.argument("on", "a face, a list of faces, a corner, or an obstacle");
  each_item(L, o, on, [&](int at) {
    if (const Rigid<D>* rigid = test_object<Rigid<D>>(L, at)) {
      support.obstacles.push_back(index_of(L, draft, *rigid, on.name));
      return;
    }
    const Place<D>& place = read_object<Place<D>>(L, at, on);
    support.on.push_back({index_of(L, draft.scene, place, on.name), place.functions});
  });
  read_components<D>(L, o, "fix", "components that stay", Hold::fixed, support);
  read_components<D>(L, o, "drive", "components that stages move", Hold::driven, support);
  read_rotation(L, o, on, support);
  if (support.hold == std::array<Hold, 2>{} && !support.rotates)
    throw ArgumentError(
        text(function_name(L), ": ", entry.name, " holds nothing: add fix = \"xy\", drive = \"xy\" or rotate = true"));
  return support;
}

template <int D>
model::Load read_load(lua_State* L, const model::Scene<D>& scene, const std::string& name, int index,
                      const Argument& entry) {
  const Options o(L, index, {"on", "traction", "pressure"}, false, entry.name);
  model::Load load;
  load.name = name;
  const Argument on = o.argument("on", "a face, or a list of faces");
  each_item(L, o, on, [&](int at) { load.on.push_back(face_of(L, scene, at, on)); });
  load.pressure = o.has("pressure");
  if (load.pressure == o.has("traction"))
    throw ArgumentError(
        text(function_name(L), ": ", entry.name, " must have one of traction = {tx, ty} and pressure = p"));
  if (load.pressure) {
    load.start = {o.number("pressure", "force per reference area, against the outward normal")};
  } else {
    const VectorX traction = o.point("traction", "force per reference area", 2, 2);
    load.start.assign(traction.begin(), traction.end());
  }
  return load;
}

/// Gauss points per slave element: 3(p+1), p the full degree along the slave face (thesis 7.1.1).
template <int D> int default_points(const model::Scene<D>& scene, const model::FaceReference& slave) {
  const auto& space = scene.bodies[static_cast<std::size_t>(slave.body)].body->space();
  return 3 * (space.face_patch(slave.side).direction(0).degree() + 1);
}

contact::Law read_law(lua_State* L, const Options& o, const Argument& entry) {
  if (o.has("adhesion")) {
    for (const char* other : {"penalty", "friction"})
      if (o.has(other))
        throw ArgumentError(text(function_name(L), ": ", entry.name, " has both adhesion and ", other,
                                 ": the van der Waals law pushes off by itself; take one of the two out"));
    const Options adhesion = o.table("adhesion", {"hamaker", "r0"});
    return contact::Adhesion{adhesion.positive("hamaker", "Hamaker's constant, force times length"),
                             adhesion.positive("r0", "equilibrium distance of the potential, a length")};
  }
  contact::PenaltyLaw law{o.positive("penalty", "normal penalty, pressure per length")};
  if (o.has("friction")) {
    const Options friction = o.table("friction", {"mu", "penalty"});
    law.friction = friction.non_negative("mu", "Coulomb's coefficient of friction");
    law.tangential = friction.positive("penalty", "tangential penalty, pressure per length");
  }
  return law;
}

/// The user's function of the reference position. It is called while the model is made, not later: sg.model's argument,
/// at the bottom of the stack, holds it.
template <int D> contact::Region<D> read_region(lua_State* L, const Options& o, const std::string& contact) {
  if (!o.has("where")) return {};
  const Argument argument = o.argument("where", "a function of the slave face's reference position X = {x, y}");
  const int index = o.push_value("where");
  if (!lua_isfunction(L, index))
    reject(L, index, argument, "a function",
           "it says for a reference position X of the slave face whether the contact acts there, as in "
           "function(X) return X[1] <= 150 end");
  return [L, contact, argument](const Vec<D>& place) {
    const int top = lua_gettop(L);
    lua_getfield(L, 1, "contacts");
    lua_getfield(L, -1, contact.c_str());
    lua_getfield(L, -1, "where");
    push(L, VectorX(place));
    lua_call(L, 1, 1);
    if (!lua_isboolean(L, -1)) reject(L, -1, argument, "a function that returns true or false");
    const bool acts = lua_toboolean(L, -1) != 0;
    lua_settop(L, top);
    return acts;
  };
}

template <int D>
model::Contact<D> read_contact(lua_State* L, Draft<D>& draft, const std::string& name, int index,
                               const Argument& entry) {
  const Options o(L, index, {"slave", "master", "penalty", "friction", "points", "adhesion", "where"}, false,
                  entry.name);
  const Argument slave = o.argument("slave", "the face that is integrated over");
  const int slave_value = o.push_value("slave");
  if (test_object<Rigid<D>>(L, slave_value))
    reject(L, slave_value, slave, "a face of a body", "an obstacle can only be the master: swap the two");
  const Argument master = o.argument("master", "the face or obstacle that is projected onto");
  const int master_value = o.push_value("master");
  model::Contact<D> contact{name, face_of(L, draft.scene, slave_value, slave), {}, {}, 0, {}};
  if (const Rigid<D>* rigid = test_object<Rigid<D>>(L, master_value))
    contact.master = model::ObstacleReference{index_of(L, draft, *rigid, master.name)};
  else if (test_object<Place<D>>(L, master_value))
    contact.master = face_of(L, draft.scene, master_value, master);
  else
    reject(L, master_value, master, "a face or an obstacle");
  const auto* face = std::get_if<model::FaceReference>(&contact.master);
  if (face && contact.slave == *face)
    throw ArgumentError(text(function_name(L), ": ", entry.name, ".master is the same face as ", entry.name,
                             ".slave; a face cannot touch itself: name a face of the other body"));
  contact.law = read_law(L, o, entry);
  contact.points =
      o.integer("points", "Gauss points per slave element", 1, 100, default_points(draft.scene, contact.slave));
  contact.where = read_region<D>(L, o, name);
  return contact;
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

/// The bodies as bodies of revolution.
template <int D> void revolve(lua_State* L, model::Scene<D>& scene) {
  for (auto& named : scene.bodies) try {
      named.body = solid::revolved(*named.body);
    } catch (const Error& error) {
      throw ArgumentError(text(function_name(L), ": bodies.", named.name, ": ", error.what()));
    }
}

template <int D> int make_model(lua_State* L) {
  const Options o(L, 1, {"bodies", "supports", "loads", "contacts", "kind"});
  Draft<D> draft;
  model::Scene<D>& scene = draft.scene;
  const bool revolved =
      o.choice("kind", "what the plane stands for", {"plane_strain", "axisymmetric"}, "plane_strain") == "axisymmetric";
  scene.kind = revolved ? solid::Kind::axisymmetric : solid::Kind::plane_strain;
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
  if (o.has("contacts"))
    o.each("contacts", "the contacts by name", [&](const std::string& name, int index, const Argument& entry) {
      check_name(L, scene, name, entry);
      scene.contacts.push_back(read_contact(L, draft, name, index, entry));
    });
  if (revolved) revolve(L, scene);
  push_object<Model<D>>(L, std::make_shared<model::Model<D>>(std::move(scene)));
  return 1;
}

constexpr Function functions[] = {
    {"model", wrap<make_model<2>>,
     "sg.model{ bodies, supports, loads, contacts, kind = \"plane_strain\" }\n"
     "A scene of unit depth, or with kind = \"axisymmetric\" one of revolution: x is the radius, y the axis, forces "
     "are\n"
     "those over the full circle. All parts are tables by name:\n"
     "  bodies   = { die = die, slab = slab }\n"
     "  supports = { bed  = { on = slab:face \"south\", fix = \"xy\" },\n"
     "               grip = { on = {die:face \"west\", die:face \"east\"}, drive = \"xy\" },\n"
     "               edge = { on = strip:face \"east\", rotate = true } }\n"
     "  loads    = { push = { on = ring:face \"east\", traction = {0, -1} }, gas = { on = face, pressure = 2 } }\n"
     "  contacts = { interface = { slave = die:face \"south\", master = slab:face \"north\", penalty = 100,\n"
     "                             friction = { mu = 0.2, penalty = 100 }, points = 3(p+1), where = function(X) … end "
     "},\n"
     "               film = { slave = strip:face \"south\", master = sg.rigid.plane{ point = {0, 0}, normal = {0, 1} "
     "},\n"
     "                        adhesion = { hamaker = 0.1, r0 = 0.4 } } }\n"
     "on: a face, a list of faces (their reactions add up), a corner, or an obstacle. fix, drive: \"x\", \"y\" or "
     "\"xy\";\n"
     "stages move what is driven. rotate: the face turns as a rigid line about its centre by an angle in degrees that\n"
     "stages give; translations that are neither fixed nor driven are free. Loads are dead: force per reference area;\n"
     "pressure acts against the outward normal; the value given here acts from the first step on, stages change it.\n"
     "slave: the face that is integrated over with `points` Gauss points per element; master: the face or obstacle "
     "that it\n"
     "is projected onto. penalty: pressure per length. adhesion: van der Waals traction with Hamaker's constant "
     "(force\n"
     "times length) and r0 (length) in place of penalty and friction. where: whether the contact acts at a reference\n"
     "position X = {x, y} of the slave face. An open end of the master is no contact."},
};

} // namespace

void open_scene(lua_State* L) {
  register_functions(L, "sg", functions);
}

} // namespace signorini::bind
