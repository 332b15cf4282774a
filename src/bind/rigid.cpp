#include "bind/rigid.hpp"
#include "base/words.hpp"
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

template <int D> int push_plane(lua_State* L, const VectorX& point, const VectorX& normal) {
  return push_obstacle<D>(L, RigidForm::plane, contact::make_plane<D>(point, normal));
}

int plane(lua_State* L) {
  const Options o(L, 1, {"point", "normal"});
  const VectorX point = o.point("point", "a point of the plane");
  const int dimension = static_cast<int>(point.size());
  const VectorX normal = o.point("normal", "direction out of the obstacle, towards the body", dimension, dimension);
  return dimension == 2 ? push_plane<2>(L, point, normal) : push_plane<3>(L, point, normal);
}

template <int D> int push_ball(lua_State* L, RigidForm form, const VectorX& centre, double radius) {
  return push_obstacle<D>(L, form, contact::make_ball<D>(centre, radius));
}

int cylinder(lua_State* L) {
  const Options o(L, 1, {"centre", "axis", "radius"});
  const VectorX centre = o.point("centre", "the centre");
  const double radius = o.positive("radius", "a length");
  if (centre.size() == 3)
    return push_obstacle<3>(L, RigidForm::cylinder,
                            contact::make_cylinder(centre, o.point("axis", "direction of the axis", 3, 3), radius));
  if (o.has("axis"))
    throw ArgumentError(text(function_name(L),
                             ": axis is for cylinders in 3D, whose centre is {x, y, z}: in the plane ",
                             "the axis is normal to it, leave axis out"));
  return push_ball<2>(L, RigidForm::cylinder, centre, radius);
}

int sphere(lua_State* L) {
  const Options o(L, 1, {"centre", "radius"});
  const VectorX centre = o.point("centre", "the centre");
  const double radius = o.positive("radius", "a length");
  return centre.size() == 2 ? push_ball<2>(L, RigidForm::sphere, centre, radius)
                            : push_ball<3>(L, RigidForm::sphere, centre, radius);
}

int rigid_surface(lua_State* L) {
  const Argument argument{"patch", "the obstacle's outline, its outside on the right of its direction, or its surface, "
                                   "its outside where xi1 x xi2 points"};
  const auto& patch = read_object<nurbs::Patch>(L, 1, argument);
  if (patch.parametric_dimension() != patch.dimension() - 1)
    reject(L, 1, argument, "a curve in the plane, or a surface in 3D");
  return patch.dimension() == 2 ? push_obstacle<2>(L, RigidForm::surface, patch)
                                : push_obstacle<3>(L, RigidForm::surface, patch);
}

struct InWords {
  RigidForm form;

  template <int D> std::string operator()(const contact::Plane<D>& plane) const {
    return text("rigid plane through ", coordinates(plane.point), ", normal ", coordinates(plane.normal));
  }
  template <int D> std::string operator()(const contact::Ball<D>& ball) const {
    return text("rigid ", name_of(form), " about ", coordinates(ball.centre), ", radius ", ball.radius);
  }
  std::string operator()(const contact::Cylinder& cylinder) const {
    return text("rigid cylinder about ", coordinates(cylinder.point), ", axis ", coordinates(cylinder.axis),
                ", radius ", cylinder.radius);
  }
  std::string operator()(const nurbs::Patch& patch) const {
    const bool curve = patch.parametric_dimension() == 1;
    const std::string first = text(patch.direction(0).degree());
    return curve ? "rigid curve of degree " + first
                 : text("rigid surface of degrees ", first, " and ", patch.direction(1).degree());
  }
};

template <int D> int rigid_tostring(lua_State* L) {
  const RigidShape<D>& rigid = *self<Rigid<D>>(L);
  push(L, std::visit(InWords{rigid.form}, rigid.shape));
  return 1;
}

constexpr Function rigid_functions[] = {
    {"plane", plane,
     "sg.rigid.plane{ point, normal }\n"
     "A rigid half space as obstacle: master of a contact. normal points out of it, towards the body. Two\n"
     "coordinates in the plane, three in 3D. A support drives it: see help \"obstacle\".\n"
     "Example: sg.rigid.plane{ point = {0, -1}, normal = {0, 1} }\n"
     "Example: sg.rigid.plane{ point = {0, 0, -1}, normal = {0, 0, 1} }"},
    {"cylinder", cylinder,
     "sg.rigid.cylinder{ centre, axis, radius }\n"
     "A rigid cylinder without ends. In plane strain its axis is normal to the plane, and it is a disc; in 3D it\n"
     "lies along the vector `axis` through `centre`. A support drives it: see help \"obstacle\".\n"
     "Example: sg.rigid.cylinder{ centre = {0, 2}, radius = 1 }\n"
     "Example: sg.rigid.cylinder{ centre = {0, 0, 2}, axis = {0, 1, 0}, radius = 1 }"},
    {"sphere", sphere,
     "sg.rigid.sphere{ centre, radius }\n"
     "A rigid sphere in 3D, or on the axis of an axisymmetric model. A support drives it: see help \"obstacle\".\n"
     "Example: sg.rigid.sphere{ centre = {0, 0, 2}, radius = 1 }"},
    {"surface", rigid_surface,
     "sg.rigid.surface(patch)\n"
     "A rigid obstacle bounded by any NURBS: a curve in the plane, its outside on the right of the curve's\n"
     "direction; or a surface in 3D, its outside where the product of its tangents along xi1 and xi2 points;\n"
     "patch:reverse(1) turns it to the other side.\n"
     "A support drives it: see help \"obstacle\".\n"
     "Example: sg.rigid.surface(sg.nurbs.arc{ centre = {0, 0}, radius = 1, from = 0, to = 180 })\n"
     "Example: sg.rigid.surface(sg.shapes.block{ size = {9, 9, 1}, corner = {0, 0, -1} }:face \"back\")"},
};

template <int D>
constexpr Function rigid_entries[] = {
    {"__tostring", rigid_tostring<D>,
     "obstacle\n"
     "What sg.rigid.* return: a master without unknowns; print(obstacle) tells its shape. It stands still unless a\n"
     "support drives it: supports = { push = { on = obstacle, drive = \"y\" } }; stages then give its displacement,\n"
     "push = {-0.1}, and run:column \"push.fy\" the force on it.\n"
     "Example: disc = sg.rigid.cylinder{ centre = {1.5, 2}, radius = 1 }\n"
     "         sg.model{ bodies = { slab = slab },\n"
     "           supports = { bed = { on = slab:face \"south\", fix = \"xy\" }, push = { on = disc, drive = \"y\" } "
     "},\n"
     "           contacts = { touch = { slave = slab:face \"north\", master = disc, penalty = 100 } } }"},
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
  register_functions(L, "sg.rigid", rigid_functions);
  register_type<Rigid<2>, Rigid<3>>(L, rigid_entries<2>, rigid_entries<3>);
}

} // namespace signorini::bind
