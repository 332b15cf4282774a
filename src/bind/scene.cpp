#include "bind/scene.hpp"

#include "bind/functions.hpp"
#include "bind/open.hpp"

#include <algorithm>

namespace signorini::bind {

namespace {

using model::Hold;

std::vector<model::NamedBody<2>> read_bodies(lua_State* L, const Options& o) {
  std::vector<model::NamedBody<2>> bodies;
  o.each("bodies", "the bodies by name", [&](const std::string& name, int index, const Argument& entry) {
    const Body& body = read_object<Body>(L, index, entry);
    for (const auto& other : bodies)
      if (other.body == body)
        throw ArgumentError(text(function_name(L), ": bodies.", name, " is the same body as bodies.", other.name,
                                 ": make one with sg.body for each"));
    bodies.push_back({name, body});
  });
  return bodies;
}

int index_of(lua_State* L, const model::Scene<2>& scene, const Place& place, const std::string& where) {
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    if (scene.bodies[b].body == place.body) return static_cast<int>(b);
  throw ArgumentError(text(function_name(L), ": ", where, " is on a body that is not in bodies: add it there"));
}

model::FaceReference read_face(lua_State* L, const model::Scene<2>& scene, const Options& o, const char* key,
                               const char* meaning) {
  const Place& place = o.object<Place>(key, meaning);
  const Argument argument = o.argument(key, meaning);
  if (!place.side) reject(L, o.push_value(key), argument, "a face", "a corner has no surface to touch");
  return {index_of(L, scene, place, argument.name), *place.side};
}

void read_components(lua_State* L, const Options& o, const char* key, const char* meaning, Hold hold,
                     model::Support<2>& support) {
  if (!o.has(key)) return;
  for (char letter : o.choice(key, meaning, {"x", "y", "xy"})) {
    Hold& component = support.hold[letter == 'x' ? 0 : 1];
    if (component != Hold::free)
      throw ArgumentError(text(function_name(L), ": ", o.path(), " both fixes and drives ", letter,
                               ": a component is either fixed or driven, take it out of one of the two"));
    component = hold;
  }
}

model::Support<2> read_support(lua_State* L, const model::Scene<2>& scene, const std::string& name, int index,
                               const Argument& entry) {
  const Options o(L, index, {"on", "fix", "drive"}, false, entry.name);
  model::Support<2> support;
  support.name = name;
  const Argument on = o.argument("on", "a face, a list of faces, or a corner");
  const auto add = [&](int at) {
    const Place& place = read_object<Place>(L, at, on);
    support.on.push_back({index_of(L, scene, place, on.name), place.functions});
  };
  const int value = o.push_value("on");
  if (lua_istable(L, value)) {
    const int count = read_list(L, value, on);
    if (count == 0) reject(L, value, on, "a face, a list of faces, or a corner");
    for (int i = 1; i <= count; ++i) {
      lua_rawgeti(L, value, i);
      add(-1);
      lua_pop(L, 1);
    }
  } else {
    add(value);
  }
  read_components(L, o, "fix", "components that stay", Hold::fixed, support);
  read_components(L, o, "drive", "components that stages move", Hold::driven, support);
  if (support.hold == std::array<Hold, 2>{})
    throw ArgumentError(text(function_name(L), ": ", entry.name, " holds nothing: add fix = \"xy\" or drive = \"xy\""));
  return support;
}

/// Gauss points per slave element: 3(p+1), p the full degree along the slave face (thesis 7.1.1).
int default_points(const model::Scene<2>& scene, const model::FaceReference& slave) {
  const auto& space = scene.bodies[static_cast<std::size_t>(slave.body)].body->space();
  return 3 * (space.face_patch(slave.side).direction(0).degree() + 1);
}

model::Contact read_contact(lua_State* L, const model::Scene<2>& scene, const std::string& name, int index,
                            const Argument& entry) {
  const Options o(L, index, {"slave", "master", "penalty", "friction", "points"}, false, entry.name);
  model::Contact contact;
  contact.name = name;
  contact.slave = read_face(L, scene, o, "slave", "the face that is integrated over");
  contact.master = read_face(L, scene, o, "master", "the face that is projected onto");
  if (contact.slave == contact.master)
    throw ArgumentError(text(function_name(L), ": ", entry.name, ".master is the same face as ", entry.name,
                             ".slave; a face cannot touch itself: name a face of the other body"));
  contact.law.normal = o.positive("penalty", "normal penalty, pressure per length");
  if (o.has("friction")) {
    const Options friction = o.table("friction", {"mu", "penalty"});
    contact.law.friction = friction.non_negative("mu", "Coulomb's coefficient of friction");
    contact.law.tangential = friction.positive("penalty", "tangential penalty, pressure per length");
  }
  contact.points = o.integer("points", "Gauss points per slave element", 1, 100, default_points(scene, contact.slave));
  return contact;
}

/// Names become columns ("grip.fx") and stage keys, so no two things share one and none is a key of a stage.
void check_name(lua_State* L, const model::Scene<2>& scene, const std::string& name, const Argument& entry) {
  const auto clash = [&](const auto& items) {
    return std::any_of(items.begin(), items.end(), [&](const auto& item) { return item.name == name; });
  };
  if (clash(scene.supports))
    throw ArgumentError(text(function_name(L), ": ", entry.name, " has the name of a support: columns such as '", name,
                             ".fx' would mean both; choose another name"));
  if (name == "name" || name == "steps")
    throw ArgumentError(text(function_name(L), ": ", entry.name, " cannot be called '", name,
                             "', which is a key of stages: choose another name"));
}

int make_model(lua_State* L) {
  const Options o(L, 1, {"bodies", "supports", "contacts"});
  model::Scene<2> scene;
  scene.bodies = read_bodies(L, o);
  if (o.has("supports"))
    o.each("supports", "the supports by name", [&](const std::string& name, int index, const Argument& entry) {
      check_name(L, scene, name, entry);
      scene.supports.push_back(read_support(L, scene, name, index, entry));
    });
  if (o.has("contacts"))
    o.each("contacts", "the contacts by name", [&](const std::string& name, int index, const Argument& entry) {
      check_name(L, scene, name, entry);
      scene.contacts.push_back(read_contact(L, scene, name, index, entry));
    });
  push_object<Model>(L, std::make_shared<model::Model<2>>(std::move(scene)));
  return 1;
}

constexpr Function functions[] = {
    {"model", wrap<make_model>,
     "sg.model{ bodies, supports, contacts }\n"
     "A scene, plane strain, unit depth. All three are tables by name:\n"
     "  bodies   = { die = die, slab = slab }\n"
     "  supports = { bed = { on = slab:face \"south\", fix = \"xy\" },\n"
     "               grip = { on = {die:face \"west\", die:face \"east\"}, drive = \"xy\" } }\n"
     "  contacts = { interface = { slave = die:face \"south\", master = slab:face \"north\", penalty = 100,\n"
     "                             friction = { mu = 0.2, penalty = 100 }, points = 3(p+1) } }\n"
     "on: a face, a list of faces (their reactions add up), or a corner. fix, drive: \"x\", \"y\" or \"xy\"; stages "
     "move\n"
     "what is driven. slave: the face that is integrated over with `points` Gauss points per element; master: the "
     "face\n"
     "that it is projected onto. penalty: pressure per length. An open end of the master is no contact."},
};

} // namespace

void open_scene(lua_State* L) {
  register_functions(L, "sg", functions);
}

} // namespace signorini::bind
