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

template <int D> contact::Method<D> read_method(const Arguments& a) {
  if (a.has("adhesion")) {
    const Arguments adhesion = a.table("adhesion");
    return contact::Adhesion{adhesion.get<double>("hamaker"), adhesion.get<double>("r0")};
  }
  contact::PenaltyLaw law{a.get<double>("penalty")};
  if (a.has("friction")) {
    const Arguments friction = a.table("friction");
    law.friction = friction.get<double>("mu");
    law.tangential = friction.get<double>("penalty");
  }
  return law;
}

/// The user's function of the reference position. It is called while the model is made, not later: sg.model's argument,
/// at the bottom of the stack, holds it.
template <int D> contact::Region<D> read_region(lua_State* L, const Arguments& a, const std::string& contact) {
  if (!a.has("where")) return {};
  return [L, contact, name = a.name("where")](const Vec<D>& place) {
    const int top = lua_gettop(L);
    lua_getfield(L, 1, "contacts");
    lua_getfield(L, -1, contact.c_str());
    lua_getfield(L, -1, "where");
    push(L, VectorX(place));
    lua_call(L, 1, 1);
    if (!lua_isboolean(L, -1))
      throw ArgumentError(text(function_name(L), ": ", name, " must return true or false, it returned ",
                               describe(L, -1), ": write a comparison behind return, as in return X[1] <= 150"));
    const bool acts = lua_toboolean(L, -1) != 0;
    lua_settop(L, top);
    return acts;
  };
}

} // namespace

template <int D>
model::Contact<D> read_contact(lua_State* L, Draft<D>& draft, const Arguments& a, const std::string& name) {
  model::Contact<D> contact{{}, face_of(L, draft.scene, a.push("slave"), a.name("slave")), {}, {}, 0, {}};
  const int master = a.push("master");
  if (has_type(L, master, Type<Rigid<D>>::name))
    contact.master = model::ObstacleReference{index_of(L, draft, a.object<Rigid<D>>("master"), a.name("master"))};
  else
    contact.master = face_of(L, draft.scene, master, a.name("master"));
  const auto* face = std::get_if<model::FaceReference>(&contact.master);
  if (face && contact.slave == *face)
    throw ArgumentError(text(function_name(L), ": ", a.name("master"), " is the same face as ", a.name("slave"),
                             "; a face cannot touch itself: name a face of the other body"));
  contact.method = read_method<D>(a);
  contact.points = a.has("points") ? a.get<int>("points") : default_points(draft.scene, contact.slave);
  contact.where = read_region<D>(L, a, name);
  return contact;
}

template model::Contact<2> read_contact<2>(lua_State*, Draft<2>&, const Arguments&, const std::string&);
template model::Contact<3> read_contact<3>(lua_State*, Draft<3>&, const Arguments&, const std::string&);

} // namespace signorini::bind
