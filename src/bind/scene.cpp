#include "bind/draft.hpp"
#include "bind/functions.hpp"
#include "bind/open.hpp"
#include "bind/wording/wording.hpp"

#include <algorithm>

namespace signorini::bind {

namespace {

template <int D> std::vector<model::NamedBody<D>> read_bodies(lua_State* L, const Arguments& a) {
  std::vector<model::NamedBody<D>> bodies;
  a.each("bodies", [&](const std::string& name, int index, const std::string& path) {
    const Body<D>& body = read_object<Body<D>>(L, index, {path});
    for (const auto& other : bodies)
      if (other.body == body)
        a.fail(path, " is the same body as bodies.", other.name, ": make one with sg.body for each");
    bodies.push_back({name, body});
  });
  return bodies;
}

/// Names become columns ("grip.fx") and stage keys, so no two things share one and none is a key of a stage.
template <int D>
void check_name(const Arguments& a, const model::Scene<D>& scene, const std::string& name, const std::string& path) {
  const auto clash = [&](const auto& items, const char* kind) {
    if (std::any_of(items.begin(), items.end(), [&](const auto& item) { return item.name == name; }))
      a.fail(path, " has the name of a ", kind, ": columns such as '", name,
             ".fx' would mean both; choose another name");
  };
  clash(scene.supports, "support");
  clash(scene.loads, "load");
  if (name == "name" || name == "steps")
    a.fail(path, " cannot be called '", name, "', which is a key of stages: choose another name");
}

/// 2 or 3: the first body's.
int dimension_of(lua_State* L, const Arguments& a) {
  int dimension = 0;
  a.each("bodies", [&](const std::string&, int index, const std::string&) {
    if (dimension == 0) dimension = test_object<Body<3>>(L, index) ? 3 : 2;
  });
  return dimension;
}

/// The bodies as bodies of revolution.
void revolve(lua_State* L, model::Scene<2>& scene) {
  for (auto& named : scene.bodies) try {
      named.body = solid::revolved(*named.body);
    } catch (const Error& error) {
      throw ArgumentError(text(function_name(L), ": bodies.", named.name, ": ", worded(error)));
    }
}

template <int D> int push_model(lua_State* L, const Arguments& a) {
  Draft<D> draft;
  model::Scene<D>& scene = draft.scene;
  if (D == 3 && a.has("kind"))
    a.fail("kind says what the plane stands for, but the bodies are solids in 3D: leave it out");
  if (a.get<std::string>("kind") == "axisymmetric") scene.kind = solid::Kind::axisymmetric;
  scene.bodies = read_bodies<D>(L, a);
  const auto each = [&](const char* key, const auto& add) {
    if (!a.has(key)) return;
    a.each(key, [&](const std::string& name, int index, const std::string& path) {
      check_name(a, scene, name, path);
      add(Arguments(L, index, path), name) = name;
    });
  };
  // A load may stand among the supports: both are what holds and moves a body from outside.
  const auto add_held = [&](const Arguments& part, const std::string&) -> std::string& {
    if (part.has("traction") || part.has("pressure")) return scene.loads.emplace_back(read_load(L, scene, part)).name;
    return scene.supports.emplace_back(read_support(L, draft, part)).name;
  };
  each("supports", add_held);
  each("loads", add_held);
  each("contacts", [&](const Arguments& part, const std::string& name) -> std::string& {
    return scene.contacts.emplace_back(read_contact(L, draft, part, name)).name;
  });
  if constexpr (D == 2)
    if (scene.kind == solid::Kind::axisymmetric) revolve(L, scene);
  const auto& made = push_object<Model<D>>(L, std::make_shared<model::Model<D>>(std::move(scene)));
  count_memory(L, model::memory(*made));
  for (const Message& warning : model::warnings(*made)) warn(worded(warning));
  return 1;
}

int make_model(lua_State* L) {
  const Arguments a(L);
  return dimension_of(L, a) == 3 ? push_model<3>(L, a) : push_model<2>(L, a);
}

constexpr Function scene_functions[] = {{"model", make_model}};

} // namespace

void open_scene(lua_State* L) {
  register_functions(L, "sg", scene_functions);
}

} // namespace signorini::bind
