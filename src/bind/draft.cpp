#include "bind/draft.hpp"
#include "bind/place.hpp"

#include <algorithm>

namespace signorini::bind {

template <int D>
int index_of(lua_State* L, const model::Scene<D>& scene, const Place<D>& place, const std::string& where) {
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    if (scene.bodies[b].body == place.body) return static_cast<int>(b);
  throw ArgumentError(text(function_name(L), ": ", where, " is on a body that is not in bodies: add it there"));
}

namespace {

/// In the plane a disc is a cylinder or, about the axis of a body of revolution, a sphere.
void check_disc(lua_State* L, const RigidShape<2>& rigid, bool revolved, const std::string& where) {
  if (rigid.form == RigidForm::sphere && !revolved)
    throw ArgumentError(text(function_name(L), ": ", where, " is a sphere in plane strain: use sg.rigid.cylinder, or ",
                             "kind = \"axisymmetric\" for the model"));
  if (rigid.form == RigidForm::cylinder && revolved)
    throw ArgumentError(text(function_name(L), ": ", where, " is a cylinder across an axisymmetric model: use ",
                             "sg.rigid.sphere with its center on the axis x = 0"));
  if (const auto* ball = std::get_if<contact::Ball<2>>(&rigid.shape); ball && revolved && ball->centre(0) != 0)
    throw ArgumentError(text(function_name(L), ": ", where, " has its center at x = ", ball->centre(0),
                             ": in an axisymmetric model a sphere's center lies on the axis, x = 0"));
}

} // namespace

template <int D> int index_of(lua_State* L, Draft<D>& draft, const Rigid<D>& rigid, const std::string& where) {
  const auto found = std::find(draft.obstacles.begin(), draft.obstacles.end(), rigid);
  if (found != draft.obstacles.end()) return static_cast<int>(found - draft.obstacles.begin());
  if constexpr (D == 2) check_disc(L, *rigid, draft.scene.kind == solid::Kind::axisymmetric, where);
  draft.obstacles.push_back(rigid);
  draft.scene.obstacles.push_back(rigid->shape);
  return static_cast<int>(draft.obstacles.size()) - 1;
}

template <int D>
model::FaceReference face_of(lua_State* L, const model::Scene<D>& scene, int index, const std::string& where) {
  const Place<D>& place = read_object<Place<D>>(L, index, {where});
  if (!place.side) reject_place(L, place, where, "a face", text(with_article(kind_of(place)), " has no surface"));
  return {index_of(L, scene, place, where), *place.side};
}

template int index_of<2>(lua_State*, const model::Scene<2>&, const Place<2>&, const std::string&);
template int index_of<2>(lua_State*, Draft<2>&, const Rigid<2>&, const std::string&);
template model::FaceReference face_of<2>(lua_State*, const model::Scene<2>&, int, const std::string&);
template int index_of<3>(lua_State*, const model::Scene<3>&, const Place<3>&, const std::string&);
template int index_of<3>(lua_State*, Draft<3>&, const Rigid<3>&, const std::string&);
template model::FaceReference face_of<3>(lua_State*, const model::Scene<3>&, int, const std::string&);

} // namespace signorini::bind
