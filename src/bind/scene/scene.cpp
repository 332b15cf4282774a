#include "bind/lua/functions.hpp"
#include "bind/lua/open.hpp"
#include "bind/lua/wording/wording.hpp"
#include "bind/scene/scene_builder.hpp"
#include "bind/scene/symbols.hpp"
#include "model/scene/free_faces.hpp"

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

/// Gauss points per slave element and direction: 3(p+1), p the full degree along the slave face (thesis 7.1.1), the
/// higher of its two directions.
template <int D> int default_points(const model::Scene<D>& scene, const model::Faces& slave) {
  int degree = 0;
  for (const model::FaceReference& part : slave) {
    const nurbs::Row face = scene.bodies[part.body].body->space().face(part.side);
    for (const nurbs::Space1D& direction : face.directions()) degree = std::max(degree, direction.degree());
  }
  return 3 * (degree + 1);
}

contact::MultiplierSpace read_multipliers(const Arguments& a) {
  return choice<contact::MultiplierSpace>(a.get<std::string>("multipliers"), {"equal", "reduced", "linear"});
}

/// A formula that a function of signorini.scene.formula makes of an argument of a contact.
const Symbol& read_formula(const Arguments& a, const char* key, const char* maker, int dimension) {
  lua_State* L = a.state();
  push_require(L);
  lua_pushliteral(L, "signorini.scene.formula");
  lua_call(L, 1, 1);
  lua_getfield(L, -1, maker);
  push(L, a.name(key));
  a.push(key);
  lua_call(L, 2, 1);
  const Symbol& made = read_object<Symbol>(L, -1, {"a formula"});
  const symbolic::Graph& graph = *made.graph;
  for (const int node : symbolic::needed_for(graph, {made.node})) {
    require(!graph.is_constant(node) || std::isfinite(graph[node].value), a.name(key), " contains the number ",
            graph[node].value, ", but a formula must be finite. Hint: look for a division by zero");
    require(dimension == 3 || node >= std::ssize(graph.variables()) || graph.variables()[node] != "Z", a.name(key),
            " depends on Z, but a plane model has X and Y alone");
  }
  return made;
}

contact::Cohesion read_cohesion(const Arguments& contact, int dimension, double penalty) {
  const Arguments a = contact.table("cohesive");
  const double shear = a.get<double>("shear");
  if (a.has("traction") || a.is("energy", LUA_TFUNCTION) || a.is("strength", LUA_TFUNCTION) || shear != 1) {
    const Symbol& traction = read_formula(contact, "cohesive", "cohesion", dimension);
    try {
      return contact::cohesive(contact::make_cohesion_formula({*traction.graph, traction.node}, shear));
    } catch (const Error& error) {
      contact.fail(worded(error));
    }
  }
  contact::Cohesion cohesion{a.get<double>("strength"), a.get<double>("energy")};
  cohesion.softening = choice<contact::Softening>(a.get<std::string>("law"), {"exponential", "bilinear"});
  if (cohesion.softening == contact::Softening::bilinear) cohesion.stiffness = a.get("stiffness", penalty);
  return cohesion;
}

/// μ: a number, two in the directions of an axis, or a formula.
void read_coefficient(const Arguments& friction, int dimension, contact::InterfaceLaw& law) {
  law.frictional = true;
  if (friction.has("along")) {
    const auto along = friction.get<VectorX>("along");
    require(along.size() == dimension, friction.name("along"), " must have ", dimension, " components, got ",
            along.size());
    law.along.emplace(Vec<3>::Zero()).head(dimension) = along;
  }
  if (friction.is("mu", LUA_TNUMBER)) {
    law.friction = friction.get<double>("mu");
    return;
  }
  if (friction.is("mu", LUA_TTABLE) && lua_rawlen(friction.state(), friction.push("mu")) > 0) {
    law.ellipse = friction.get<VectorX>("mu");
    law.friction = law.ellipse->maxCoeff();
    return;
  }
  const Symbol& mu = read_formula(friction, "mu", "friction", dimension);
  law.friction = 1;
  law.coefficient = contact::make_slip_formula({*mu.graph, mu.node});
}

/// k of wear: a number, or a formula.
contact::Wear read_wear(const Arguments& wear, int dimension) {
  contact::Wear law;
  law.update = choice<contact::WearUpdate>(wear.get<std::string>("update"), {"implicit", "explicit"});
  if (wear.is("rate", LUA_TNUMBER)) {
    symbolic::Graph graph(contact::slip_variables());
    const int rate = graph.constant(wear.get<double>("rate"));
    law.rate = contact::make_slip_formula({graph, rate});
  } else {
    const Symbol& rate = read_formula(wear, "rate", "wear", dimension);
    law.rate = contact::make_slip_formula({*rate.graph, rate.node});
  }
  return law;
}

contact::Method read_method(const Arguments& a, int dimension) {
  if (a.has("adhesion")) {
    const Arguments adhesion = a.table("adhesion");
    return contact::adhesive({adhesion.get<double>("hamaker"), adhesion.get<double>("r0")});
  }
  contact::InterfaceLaw law{a.get("penalty", 0.0)};
  if (a.has("pressure")) {
    const Symbol& pressure = read_formula(a, "pressure", "pressure", dimension);
    const double clearance =
        a.is("clearance", LUA_TSTRING) ? std::numeric_limits<double>::infinity() : a.get("clearance", 0.0);
    law.pressure = contact::make_pressure_formula({*pressure.graph, pressure.node}, clearance);
  }
  if (a.has("friction")) {
    const Arguments friction = a.table("friction");
    read_coefficient(friction, dimension, law);
    law.tangential = friction.get("penalty", 0.0);
  }
  if (a.has("wear")) law.wear = read_wear(a.table("wear"), dimension);
  law.enforcement = choice<contact::Enforcement>(a.get<std::string>("enforcement"), {"penalty", "multipliers"});
  if (a.has("cohesive")) {
    law.per = contact::TractionArea::reference;
    return {law, {}, contact::Pass::full, read_cohesion(a, dimension, law.normal)};
  }
  enum class Points { gauss, half_passes, mortar };
  const auto points = choice<Points>(a.get<std::string>("method"), {"gpts", "half_passes", "mortar"});
  std::optional<contact::MultiplierSpace> space;
  if (a.has("multipliers")) space = read_multipliers(a);
  if (points == Points::half_passes) return {law, space, contact::Pass::half};
  if (points == Points::mortar || (a.has("per") && a.get<std::string>("per") == "reference"))
    law.per = contact::TractionArea::reference;
  if (points == Points::gauss) return law;
  using contact::MultiplierSpace;
  const bool solved = law.enforcement == contact::Enforcement::multipliers;
  return {law, space.value_or(solved ? MultiplierSpace::automatic : MultiplierSpace::equal)};
}

/// The user's function of the reference position, below a path of keys. It is called only while the model is created,
/// when sg.model's argument at the bottom of the stack holds it.
template <int D> contact::Region<D> read_region(const Arguments& a, const std::vector<std::string>& path) {
  if (!a.has("where")) return {};
  return [L = a.state(), path, name = a.name("where")](const Vec<D>& place) {
    const int top = lua_gettop(L);
    lua_pushvalue(L, 1);
    for (const std::string& key : path) lua_getfield(L, -1, key.c_str());
    lua_getfield(L, -1, "where");
    push(L, VectorX(place));
    lua_call(L, 1, 1);
    if (!lua_isboolean(L, -1))
      fail(name, " must return true or false, got ", describe(L, -1),
           ": return a comparison, as in return X[1] <= 150");
    const bool acts = lua_toboolean(L, -1) != 0;
    lua_settop(L, top);
    return acts;
  };
}

template <int D> model::Faces read_faces(const SceneBuilder<D>& builder, const Arguments& a, const char* key) {
  model::Faces faces;
  a.list(key,
         [&](int, int index, const std::string&) { faces.push_back(builder.face(a.state(), index, a.name(key))); });
  return faces;
}

/// An entry of `contacts` with this name in sg.model's argument.
template <int D> model::Contact<D> read_contact(SceneBuilder<D>& builder, const Arguments& a, const std::string& name) {
  model::Contact<D> contact;
  if (a.has("among")) {
    contact.slave = a.is("among", LUA_TSTRING) ? free_faces(builder.scene) : read_faces(builder, a, "among");
    contact.master = contact.slave;
  } else {
    contact.slave = read_faces(builder, a, "slave");
    if (has_type(a.state(), a.push("master"), Type<Rigid<D>>::name))
      contact.master = model::ObstacleReference{builder.index_of(a.object<Rigid<D>>("master"), a.name("master"))};
    else
      contact.master = read_faces(builder, a, "master");
    const auto* master = std::get_if<model::Faces>(&contact.master);
    for (const model::FaceReference& face : contact.slave)
      require(!master || !master->contains(face), a.name("master"), " is the same face as ", a.name("slave"),
              ": write among = … in place of both for faces in contact with each other");
  }
  contact.method = read_method(a, D);
  contact.adaptive_points = a.is("points", LUA_TSTRING);
  require(!contact.adaptive_points || !of_rate(contact.method.law), a.name("points"),
          " is \"auto\", but a formula depends on v, which points that begin to act do not know: give a number");
  contact.points =
      a.has("points") && !contact.adaptive_points ? a.get<int>("points") : default_points(builder.scene, contact.slave);
  contact.where = read_region<D>(a, {"contacts", name});
  if (a.has("cohesive")) contact.bonded = read_region<D>(a.table("cohesive"), {"contacts", name, "cohesive"});
  contact.start = {a.get<bool>("active"), a.get<double>("offset"), a.get<std::string>("overlap") == "interference"};
  return contact;
}

/// The half pass over the master face of a contact.
template <int D> model::Contact<D> swapped(const SceneBuilder<D>& builder, const Arguments& a, model::Contact<D> pass) {
  const model::Faces slave = std::get<model::Faces>(pass.master);
  pass.master = pass.slave;
  pass.slave = slave;
  // What slides along an axis under the one face slides against it under the other.
  if (auto& along = pass.method.law.along) along = -*along;
  if (!a.has("points") || pass.adaptive_points) pass.points = default_points(builder.scene, slave);
  pass.name += ".master";
  return pass;
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

/// Names become columns ("grip.fx") and stage keys, so they must be unique and different from the keys of a stage.
template <int D>
void check_name(const Arguments& a, const model::Scene<D>& scene, const std::string& name, const std::string& path) {
  const auto clash = [&](const auto& items, const char* kind) {
    if (std::any_of(items.begin(), items.end(), [&](const auto& item) { return item.name == name; }))
      a.fail(path, " has the name of a ", kind, ": columns such as '", name,
             ".fx' would be ambiguous; choose another name");
  };
  clash(scene.supports, "support");
  clash(scene.loads, "load");
  clash(scene.contacts, "contact"); // the second one of two half passes
  clash(scene.ties, "tie");
  clash(scene.joins, "join");
  if (name == "name" || name == "steps" || name == "contacts")
    a.fail(path, " cannot be called '", name, "', which is a key of stages: choose another name");
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
  each("contacts", [&](const Arguments& part, const std::string& name) -> std::string& {
    const std::size_t first = scene.contacts.size();
    scene.contacts.push_back(read_contact(builder, part, name));
    for (int obstacle = 0; part.is("among", LUA_TSTRING) && obstacle < std::ssize(scene.obstacles); ++obstacle) {
      scene.contacts[first].name = name;
      model::Contact<D> other = with_obstacle(scene, scene.contacts[first], obstacle);
      check_name(a, scene, other.name, part.path());
      scene.contacts.push_back(std::move(other));
    }
    if (scene.contacts[first].method.pass == contact::Pass::half && !is_set(scene.contacts[first])) {
      scene.contacts[first].name = name;
      model::Contact<D> other = swapped(builder, part, scene.contacts[first]);
      check_name(a, scene, other.name, text("the second pass '", other.name, "' of contacts.", name));
      scene.contacts.push_back(std::move(other));
      scene.contacts[first].other_pass = static_cast<int>(first + 1);
      scene.contacts[first + 1].other_pass = static_cast<int>(first);
    }
    return scene.contacts[first].name;
  });
  if constexpr (D == 2)
    if (scene.kind != solid::Kind::plane_strain) set_kind(scene);
  const auto& made = push_object<Model<D>>(L, std::make_shared<model::Model<D>>(std::move(scene)));
  count_memory(L, model::memory(*made));
  std::ranges::move(builder.warnings, std::back_inserter(made->scene_warnings));
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
