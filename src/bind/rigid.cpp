#include "bind/rigid.hpp"
#include "base/words.hpp"
#include "bind/functions.hpp"
#include "bind/open.hpp"
#include "bind/patch.hpp"

namespace signorini::bind {

namespace {

template <int D> int push_obstacle(lua_State* L, RigidForm form, contact::Obstacle<D> shape) {
  push_object<Rigid<D>>(L, std::make_shared<const RigidShape<D>>(RigidShape<D>{form, std::move(shape)}));
  return 1;
}

int plane(lua_State* L) {
  const Arguments a(L);
  const auto point = a.get<VectorX>("point"), normal = a.get<VectorX>("normal");
  return point.size() == 2 ? push_obstacle<2>(L, RigidForm::plane, contact::make_plane<2>(point, normal))
                           : push_obstacle<3>(L, RigidForm::plane, contact::make_plane<3>(point, normal));
}

/// A disc or a ball.
int round(lua_State* L, RigidForm form) {
  const Arguments a(L);
  const auto centre = a.get<VectorX>("centre");
  const auto radius = a.get<double>("radius");
  return centre.size() == 2 ? push_obstacle<2>(L, form, contact::make_ball<2>(centre, radius))
                            : push_obstacle<3>(L, form, contact::make_ball<3>(centre, radius));
}

int cylinder(lua_State* L) {
  const Arguments a(L);
  const auto centre = a.get<VectorX>("centre"), axis = a.get<VectorX>("axis", {});
  const bool plane = centre.size() == 2;
  if (plane && axis.size() > 0)
    a.fail("axis is for cylinders in 3D, whose centre is {x, y, z}: in the plane the axis is normal to it, leave axis ",
           "out");
  if (plane) return round(L, RigidForm::cylinder);
  if (axis.size() == 0) a.refuse("axis", "a list of 3 numbers {x, y, z}, its direction");
  return push_obstacle<3>(L, RigidForm::cylinder, contact::make_cylinder(centre, axis, a.get<double>("radius")));
}

int sphere(lua_State* L) {
  return round(L, RigidForm::sphere);
}

int rigid_surface(lua_State* L) {
  const auto& patch = *test_object<nurbs::Patch>(L, 1);
  if (patch.parametric_dimension() != patch.dimension() - 1)
    reject(L, 1, {"patch"}, "a curve in the plane, or a surface in 3D");
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
    {"plane", plane}, {"cylinder", cylinder}, {"sphere", sphere}, {"surface", rigid_surface}};

template <int D> constexpr Function rigid_entries[] = {{"__tostring", rigid_tostring<D>}};

} // namespace

std::string name_of(RigidForm form) {
  const char* names[] = {"plane", "cylinder", "sphere", "surface"};
  return names[static_cast<int>(form)];
}

void open_rigid(lua_State* L) {
  register_functions(L, "sg.rigid", rigid_functions);
  register_type<Rigid<2>, Rigid<3>>(L, rigid_entries<2>, rigid_entries<3>);
}

} // namespace signorini::bind
