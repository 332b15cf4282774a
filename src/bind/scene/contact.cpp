#include "bind/scene/contact.hpp"

#include "model/scene/free_faces.hpp"

#include <algorithm>

namespace signorini::bind {

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

namespace {

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

/// What is in contact by one argument: the faces of a set, or slave and master.
template <int D> model::Contact<D> read_contact(SceneBuilder<D>& builder, const Arguments& a, const std::string& name) {
  model::Contact<D> contact;
  contact.name = name;
  if (a.has("among")) {
    const bool all = a.is("among", LUA_TSTRING);
    contact.slave = all ? free_faces(builder.scene) : read_faces(builder, a, "among");
    for (const model::FaceReference& face : contact.slave) {
      const auto& [name, body] = builder.scene.bodies[face.body];
      if (all && crosses_layer(body->space(), face.side))
        a.fail("among", " is \"all\", but face '", name_of(face.side), "' of body '", name,
               "' crosses its layer and cannot touch: list the faces that may touch, or take an order without a layer");
    }
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

/// One of the two things that a pair in a set names: faces, bodies with all their faces, obstacles.
struct Group {
  model::Faces faces;
  std::vector<int> bodies, obstacles;

  bool has(const model::FaceReference& face) const {
    return faces.contains(face) || std::ranges::find(bodies, face.body) != bodies.end();
  }
  bool has(int obstacle) const { return std::ranges::find(obstacles, obstacle) != obstacles.end(); }
};
using Pair = std::array<Group, 2>;

template <class One, class Other> bool is_pair(const Pair& pair, const One& one, const Other& other) {
  return (pair[0].has(one) && pair[1].has(other)) || (pair[1].has(one) && pair[0].has(other));
}

/// Which faces of a set touch each other, or an obstacle.
struct Choice {
  std::vector<Pair> except = {};
  std::optional<Pair> only = {};

  template <class Other> bool touch(const model::FaceReference& face, const Other& other) const {
    return (!only || is_pair(*only, face, other)) &&
           std::ranges::none_of(except, [&](const Pair& pair) { return is_pair(pair, face, other); });
  }
};

/// A pair of a set, a list of two at a stack index.
template <int D> Pair read_pair(const SceneBuilder<D>& builder, lua_State* L, int index, const std::string& path) {
  Pair pair;
  for (int side = 0; side < 2; ++side) {
    const std::string where = text(path, "[", side + 1, "]");
    lua_rawgeti(L, index, side + 1);
    const int list = lua_gettop(L), count = static_cast<int>(lua_rawlen(L, list));
    for (int i = 1; i <= count; ++i) {
      lua_rawgeti(L, list, i);
      if (const auto* body = test_object<Body<D>>(L, -1)) {
        pair[side].bodies.push_back(builder.index_of(*body, where));
      } else if (const auto* rigid = test_object<Rigid<D>>(L, -1)) {
        const auto found = std::ranges::find(builder.obstacles, *rigid);
        require(found != builder.obstacles.end(), where,
                " is an obstacle that no support holds, so that it is not in the set: add a support");
        pair[side].obstacles.push_back(static_cast<int>(found - builder.obstacles.begin()));
      } else {
        pair[side].faces.push_back(builder.face(L, lua_gettop(L), where));
      }
      lua_pop(L, 1);
    }
    lua_pop(L, 1);
  }
  return pair;
}

/// Adds the contacts of a set: of its faces with each other and, of all faces, with each obstacle.
template <int D>
void add_set(SceneBuilder<D>& builder, const Arguments& a, const std::string& base, const std::string& name,
             const Choice& choice) {
  model::Scene<D>& scene = builder.scene;
  const model::Contact<D> all = read_contact(builder, a, base);
  const auto add = [&](model::Contact<D> contact, const model::Faces& faces, const std::string& its_name) {
    if (faces.empty()) return;
    if (its_name != base) check_name(a, scene, its_name, a.path());
    contact.name = its_name;
    contact.slave = faces;
    scene.contacts.push_back(std::move(contact));
  };
  const auto touching = [&](const auto& touch) {
    model::Faces faces;
    std::ranges::copy_if(all.slave, std::back_inserter(faces), touch);
    return faces;
  };
  model::Contact<D> set = all;
  const model::Faces faces = touching([&](const model::FaceReference& face) {
    return !choice.only ||
           std::ranges::any_of(all.slave, [&](const auto& other) { return is_pair(*choice.only, face, other); });
  });
  set.master = faces;
  for (int i = 0; i < std::ssize(faces); ++i)
    for (int k = i; k < std::ssize(faces); ++k)
      if (!choice.touch(faces[i], faces[k])) set.apart.push_back({i, k});
  const bool alone = 2 * set.apart.size() == faces.size() * (faces.size() + 1);
  if (alone && choice.only && !faces.empty())
    fail(a.path(), ".between names only faces that except leaves out: remove one of the two");
  if (!alone) add(set, faces, name);
  if (!a.is("among", LUA_TSTRING)) return;
  for (int obstacle = 0; obstacle < std::ssize(scene.obstacles); ++obstacle) {
    const model::Contact<D> other = with_obstacle(scene, all, obstacle);
    const model::Faces slave = touching([&](const model::FaceReference& face) { return choice.touch(face, obstacle); });
    add(other, slave, faces.empty() && choice.only ? name : name + "." + other.name);
  }
}

/// Pushes the arguments of a set with those of one of its pairs in place of its own.
void push_merged(const Arguments& set, const Arguments& pair) {
  lua_State* L = set.state();
  lua_newtable(L);
  const int merged = lua_gettop(L);
  for (const Arguments* from : {&set, &pair}) {
    lua_pushnil(L);
    while (lua_next(L, from->index()) != 0) {
      lua_pushvalue(L, -2);
      lua_insert(L, -2);
      lua_rawset(L, merged);
    }
  }
}

/// Adds an entry of `contacts` with among: its pairs with laws of their own, and the rest.
template <int D> void add_sets(SceneBuilder<D>& builder, const Arguments& a, const std::string& name) {
  lua_State* L = a.state();
  const bool all = a.is("among", LUA_TSTRING);
  const model::Faces faces = all ? free_faces(builder.scene) : read_faces(builder, a, "among");
  const int obstacles = all ? static_cast<int>(builder.obstacles.size()) : 0;
  const auto read = [&](int index, const std::string& path) {
    Pair pair = read_pair(builder, L, index, path);
    const bool in_set = std::ranges::any_of(faces, [&](const model::FaceReference& face) {
      bool found = std::ranges::any_of(faces, [&](const auto& other) { return is_pair(pair, face, other); });
      for (int obstacle = 0; obstacle < obstacles; ++obstacle) found = found || is_pair(pair, face, obstacle);
      return found;
    });
    require(in_set, path,
            " names no two parts of the set: name bodies or faces that are in contact, or obstacles if among is "
            "\"all\"");
    return pair;
  };
  Choice rest;
  if (a.has("except"))
    a.list("except", [&](int, int index, const std::string& path) { rest.except.push_back(read(index, path)); });
  if (a.has("pairs"))
    a.each("pairs", [&](const std::string& key, int index, const std::string& path) {
      const Arguments pair(L, index, path);
      const Pair between = read(pair.push("between"), pair.name("between"));
      lua_pop(L, 1);
      push_merged(a, pair);
      add_set(builder, Arguments(L, lua_gettop(L), path), name, name + "." + key, Choice{rest.except, between});
      lua_pop(L, 1);
      rest.except.push_back(between);
    });
  add_set(builder, a, name, name, rest);
}

} // namespace

template <int D> model::Faces read_faces(const SceneBuilder<D>& builder, const Arguments& a, const char* key) {
  model::Faces faces;
  a.list(key,
         [&](int, int index, const std::string&) { faces.push_back(builder.face(a.state(), index, a.name(key))); });
  return faces;
}

template <int D> void add_contact(SceneBuilder<D>& builder, const Arguments& a, const std::string& name) {
  if (a.has("among")) return add_sets(builder, a, name);
  model::Scene<D>& scene = builder.scene;
  scene.contacts.push_back(read_contact(builder, a, name));
  if (scene.contacts.back().method.pass != contact::Pass::half) return;
  const auto first = static_cast<int>(scene.contacts.size()) - 1;
  model::Contact<D> other = swapped(builder, a, scene.contacts[first]);
  check_name(a, scene, other.name, text("the second pass '", other.name, "' of contacts.", name));
  scene.contacts.push_back(std::move(other));
  scene.contacts[first].other_pass = first + 1;
  scene.contacts[first + 1].other_pass = first;
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template void check_name(const Arguments&, const model::Scene<D>&, const std::string&, const std::string&);          \
  template model::Faces read_faces(const SceneBuilder<D>&, const Arguments&, const char*);                             \
  template void add_contact(SceneBuilder<D>&, const Arguments&, const std::string&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::bind
