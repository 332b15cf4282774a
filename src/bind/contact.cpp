#include "bind/draft.hpp"

#include <algorithm>

namespace signorini::bind {

namespace {

/// Gauss points per slave element and direction: 3(p+1), p the full degree along the slave face (thesis 7.1.1), the
/// higher one where its two directions differ.
template <int D> int default_points(const model::Scene<D>& scene, const model::FaceReference& slave) {
  const auto& space = scene.bodies[static_cast<std::size_t>(slave.body)].body->space();
  const nurbs::Row face = space.face(slave.side);
  int degree = 0;
  for (const nurbs::Space1D& direction : face.directions()) degree = std::max(degree, direction.degree());
  return 3 * (degree + 1);
}

template <int D> contact::Method<D> read_method(lua_State* L, const Options& o, const Argument& entry) {
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
  const Argument argument =
      o.argument("where", D == 2 ? "a function of the slave face's reference position X = {x, y}"
                                 : "a function of the slave face's reference position X = {x, y, z}");
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
    if (!lua_isboolean(L, -1))
      throw ArgumentError(text(function_name(L), ": ", argument.name, " must return true or false, it returned ",
                               describe(L, -1), ": write a comparison behind return, as in return X[1] <= 150"));
    const bool acts = lua_toboolean(L, -1) != 0;
    lua_settop(L, top);
    return acts;
  };
}

} // namespace

template <int D>
model::Contact<D> read_contact(lua_State* L, Draft<D>& draft, const std::string& name, int index,
                               const Argument& entry) {
  const Options o(L, index, {"slave", "master", "penalty", "friction", "points", "adhesion", "where"}, false,
                  entry.name);
  const Argument slave = o.argument("slave", "the face that is integrated over");
  const int slave_value = o.push_value("slave");
  if (has_type(L, slave_value, Type<Rigid<D>>::name))
    reject(L, slave_value, slave, "a face of a body", "an obstacle can only be the master: swap the two");
  const Argument master = o.argument("master", "the face or obstacle that is projected onto");
  const int master_value = o.push_value("master");
  model::Contact<D> contact{name, face_of(L, draft.scene, slave_value, slave), {}, {}, 0, {}};
  if (has_type(L, master_value, Type<Rigid<D>>::name)) {
    const auto& rigid = read_object<Rigid<D>>(L, master_value, master);
    contact.master = model::ObstacleReference{index_of(L, draft, rigid, master.name)};
  } else if (has_type(L, master_value, Type<Place<D>>::name))
    contact.master = face_of(L, draft.scene, master_value, master);
  else
    reject(L, master_value, master, "a face or an obstacle");
  const auto* face = std::get_if<model::FaceReference>(&contact.master);
  if (face && contact.slave == *face)
    throw ArgumentError(text(function_name(L), ": ", entry.name, ".master is the same face as ", entry.name,
                             ".slave; a face cannot touch itself: name a face of the other body"));
  contact.method = read_method<D>(L, o, entry);
  contact.points = o.integer("points", "Gauss points per slave element and direction", 1, 100,
                             default_points(draft.scene, contact.slave));
  contact.where = read_region<D>(L, o, name);
  return contact;
}

template model::Contact<2> read_contact<2>(lua_State*, Draft<2>&, const std::string&, int, const Argument&);
template model::Contact<3> read_contact<3>(lua_State*, Draft<3>&, const std::string&, int, const Argument&);

} // namespace signorini::bind
