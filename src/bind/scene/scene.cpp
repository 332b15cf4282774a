#include "bind/lua/functions.hpp"
#include "bind/lua/open.hpp"
#include "bind/lua/wording/wording.hpp"
#include "bind/scene/contact.hpp"
#include "model/warnings/undeclared_overlap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini::bind {

namespace {

/// A disc is a cylinder in the plane; in an axisymmetric model a sphere on the axis, or a torus.
void check_disc(const RigidShape<2>& rigid, bool revolved, const std::string& where) {
  const auto* disc = std::get_if<contact::Ball<2>>(&rigid.shape);
  if (!disc) return;
  const double x = disc->center(0);
  require(rigid.form == RigidForm::cylinder || revolved, where,
          rigid.form == RigidForm::sphere ? " is a sphere" : " is a torus",
          " in a plane model: use sg.rigid.cylinder, or kind = \"axisymmetric\" for the model");
  require(rigid.form != RigidForm::cylinder || !revolved, where,
          " is a cylinder across an axisymmetric model: use sg.rigid.sphere with its center on the axis x = 0, "
          "sg.rigid.torus off the axis, or for a shaft or a bore about the axis sg.rigid.plane with normal {1, 0} or "
          "{-1, 0}");
  if (rigid.form == RigidForm::sphere && x != 0)
    fail(where, " has its center at x = ", x,
         ": in an axisymmetric model a sphere's center lies on the axis, x = 0; a disc off the axis is a torus: use "
         "sg.rigid.torus");
  if (rigid.form == RigidForm::torus && x <= disc->radius)
    fail(where, " has its center at x = ", x, " and radius ", disc->radius,
         ": in an axisymmetric model a torus must not reach the axis, x = 0; use sg.rigid.sphere for a disc on the "
         "axis");
}

/// An entry of `ties`.
template <int D> model::Tie read_tie(const SceneBuilder<D>& builder, const Arguments& a) {
  return {{}, read_faces(builder, a, "slave"), read_faces(builder, a, "master"), read_multipliers(a)};
}

/// The two faces of an entry of `joins`, a list at a stack index.
template <int D>
model::Join read_join(const SceneBuilder<D>& builder, lua_State* L, int index, const std::string& where) {
  const auto face = [&](int i) {
    lua_rawgeti(L, index, i);
    const model::FaceReference found = builder.face(L, lua_gettop(L), text(where, "[", i, "]"));
    lua_pop(L, 1);
    return found;
  };
  const model::FaceReference first = face(1);
  return {{}, first, face(2)};
}

template <int D> std::vector<model::NamedBody<D>> read_bodies(const Arguments& a) {
  std::vector<model::NamedBody<D>> bodies;
  a.each("bodies", [&](const std::string& name, int index, const std::string& path) {
    const Body<D>& body = read_object<Body<D>>(a.state(), index, {path});
    for (const auto& other : bodies)
      if (other.body == body) a.fail(path, " is the same body as bodies.", other.name, ": make each with sg.body");
    bodies.push_back({name, body});
  });
  return bodies;
}

/// 2 or 3: that of the first body.
int dimension_of(const Arguments& a) {
  int dimension = 0;
  a.each("bodies", [&](const std::string&, int index, const std::string&) {
    if (dimension == 0) dimension = test_object<Body<3>>(a.state(), index) ? 3 : 2;
  });
  return dimension;
}

/// The bodies as bodies of revolution, or under plane stress.
void set_kind(model::Scene<2>& scene) {
  for (auto& named : scene.bodies) try {
      named.body =
          scene.kind == solid::Kind::axisymmetric ? solid::revolved(*named.body) : solid::in_plane_stress(*named.body);
    } catch (const Error& error) {
      fail("bodies.", named.name, ": ", worded(error));
    }
}

template <int D> int push_model(const Arguments& a, lua_State* L) {
  SceneBuilder<D> builder;
  model::Scene<D>& scene = builder.scene;
  if (D == 3 && a.has("kind")) a.fail("kind is for plane models, but the bodies are solids in 3D: omit it");
  if (a.has("kind"))
    scene.kind = choice<solid::Kind>(a.get<std::string>("kind"), {"plane_strain", "axisymmetric", "plane_stress"});
  scene.bodies = read_bodies<D>(a);
  const auto each = [&](const char* key, const auto& add) {
    if (!a.has(key)) return;
    a.each(key, [&](const std::string& name, int index, const std::string& path) {
      check_name(a, scene, name, path);
      add(Arguments(L, index, path), name) = name;
    });
  };
  // Loads are accepted among the supports: both are external actions on a body.
  const auto add_boundary_condition = [&](const Arguments& part, const std::string&) -> std::string& {
    if (part.has("traction") || part.has("pressure") || part.has("force") || part.has("moment"))
      return scene.loads.emplace_back(read_load(builder, part)).name;
    return scene.supports.emplace_back(read_support(builder, part)).name;
  };
  each("supports", add_boundary_condition);
  each("loads", add_boundary_condition);
  each("ties", [&](const Arguments& part, const std::string&) -> std::string& {
    return scene.ties.emplace_back(read_tie(builder, part)).name;
  });
  if (a.has("joins"))
    a.each("joins", [&](const std::string& name, int index, const std::string& path) {
      check_name(a, scene, name, path);
      scene.joins.push_back(read_join(builder, L, index, path));
      scene.joins.back().name = name;
    });
  if (a.has("contacts"))
    a.each("contacts", [&](const std::string& name, int index, const std::string& path) {
      check_name(a, scene, name, path);
      add_contact(builder, Arguments(L, index, path), name);
    });
  if constexpr (D == 2)
    if (scene.kind != solid::Kind::plane_strain) set_kind(scene);
  const auto& made = push_object<Model<D>>(L, std::make_shared<model::Model<D>>(std::move(scene)));
  count_memory(L, model::memory(*made));
  std::ranges::move(builder.warnings, std::back_inserter(made->scene_warnings));
  model::warn_of_folded_shapes(*made, made->scene_warnings);
  for (const Message& warning : made->scene_warnings) warn(worded(warning));
  return 1;
}

int make_model(const Arguments& a, lua_State* L) {
  return dimension_of(a) == 3 ? push_model<3>(a, L) : push_model<2>(a, L);
}

} // namespace

template <int D> int SceneBuilder<D>::index_of(const Body<D>& body, const std::string& where) const {
  const auto found = std::ranges::find(scene.bodies, body, &model::NamedBody<D>::body);
  require(found != scene.bodies.end(), where, " is on a body that is not in bodies: add the body");
  return static_cast<int>(found - scene.bodies.begin());
}

template <int D> int SceneBuilder<D>::index_of(const Rigid<D>& rigid, const std::string& where) {
  const auto found = std::find(obstacles.begin(), obstacles.end(), rigid);
  const auto index = static_cast<int>(found - obstacles.begin());
  if (found != obstacles.end()) return index;
  if constexpr (D == 2) check_disc(*rigid, scene.kind == solid::Kind::axisymmetric, where);
  obstacles.push_back(rigid);
  scene.obstacles.push_back(rigid->shape);
  return index;
}

template <int D> model::FaceReference SceneBuilder<D>::face(lua_State* L, int index, const std::string& where) const {
  const BoundaryPart<D>& place = read_object<BoundaryPart<D>>(L, index, {where});
  if (!place.side) reject_place(place, where, "a face", text(with_article(place.kind), " has no surface"));
  return {index_of(place, where), *place.side};
}

template struct SceneBuilder<2>;
template struct SceneBuilder<3>;

void open_scene(lua_State* L) {
  register_functions(L, "sg", {{"model", call<make_model>}});
}

} // namespace signorini::bind
