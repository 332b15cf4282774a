#include "bind/rigid.hpp"
#include "bind/functions.hpp"
#include "bind/open.hpp"
#include "bind/options.hpp"
#include "bind/patch.hpp"

namespace signorini::bind {

namespace {

template <int D> int push_obstacle(lua_State* L, RigidForm form, contact::Obstacle<D> shape) {
  push_object<Rigid<D>>(L, std::make_shared<const RigidShape<D>>(RigidShape<D>{form, std::move(shape)}));
  return 1;
}

int plane(lua_State* L) {
  const Options o(L, 1, {"point", "normal"});
  const VectorX point = o.point("point", "a point of the plane", 2, 2);
  return push_obstacle<2>(
      L, RigidForm::plane,
      contact::make_plane<2>(point, o.point("normal", "direction out of the obstacle, towards the body", 2, 2)));
}

int ball(lua_State* L, RigidForm form) {
  const Options o(L, 1, {"centre", "radius"});
  const VectorX centre = o.point("centre", "the centre", 2, 2);
  return push_obstacle<2>(L, form, contact::make_ball<2>(centre, o.positive("radius", "a length")));
}

int cylinder(lua_State* L) {
  return ball(L, RigidForm::cylinder);
}

int sphere(lua_State* L) {
  return ball(L, RigidForm::sphere);
}

int surface(lua_State* L) {
  const Argument argument{"patch", "the obstacle's outline, its outside on the right of its direction"};
  const auto& patch = read_object<nurbs::Patch>(L, 1, argument);
  if (patch.parametric_dimension() != 1 || patch.dimension() != 2) reject(L, 1, argument, "a curve in the plane");
  return push_obstacle<2>(L, RigidForm::surface, patch);
}

template <int D> int rigid_tostring(lua_State* L) {
  const auto& [form, shape] = *self<Rigid<D>>(L);
  if (const auto* plane = std::get_if<contact::Plane<D>>(&shape))
    push(L, text("rigid plane through (", plane->point.transpose(), "), normal (", plane->normal.transpose(), ")"));
  else if (const auto* ball = std::get_if<contact::Ball<D>>(&shape))
    push(L, text("rigid ", name_of(form), " about (", ball->centre.transpose(), "), radius ", ball->radius));
  else
    push(L, text("rigid curve of degree ", std::get<nurbs::Patch>(shape).directions().front().degree()));
  return 1;
}

constexpr Function functions[] = {
    {"plane", wrap<plane>,
     "sg.rigid.plane{ point, normal }\n"
     "A rigid half space as obstacle: master of a contact. normal points out of it, towards the body.\n"
     "Example: sg.rigid.plane{ point = {0, -1}, normal = {0, 1} }"},
    {"cylinder", wrap<cylinder>,
     "sg.rigid.cylinder{ centre, radius }\n"
     "A rigid cylinder whose axis is normal to the plane of plane strain: a disc.\n"
     "Example: sg.rigid.cylinder{ centre = {0, 2}, radius = 1 }"},
    {"sphere", wrap<sphere>,
     "sg.rigid.sphere{ centre, radius }\n"
     "A rigid sphere on the axis of an axisymmetric model.\n"
     "Example: sg.rigid.sphere{ centre = {0, 2}, radius = 1 }"},
    {"surface", wrap<surface>,
     "sg.rigid.surface(patch)\n"
     "A rigid obstacle bounded by any NURBS curve in the plane; its outside is on the right of the curve's direction.\n"
     "Example: sg.rigid.surface(sg.nurbs.arc{ centre = {0, 0}, radius = 1, from = 0, to = 180 })"},
};

template <int D>
constexpr Function rows[] = {
    {"__tostring", wrap<rigid_tostring<D>>, "tostring(obstacle)\nThe shape in words."},
};

} // namespace

std::string name_of(RigidForm form) {
  switch (form) {
  case RigidForm::plane:
    return "plane";
  case RigidForm::cylinder:
    return "cylinder";
  case RigidForm::sphere:
    return "sphere";
  case RigidForm::surface:
    return "surface";
  }
  return "";
}

void open_rigid(lua_State* L) {
  register_functions(L, "sg.rigid", functions);
  register_type<Rigid<2>>(L, rows<2>);
}

} // namespace signorini::bind
