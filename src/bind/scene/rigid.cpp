#include "base/words.hpp"
#include "bind/geometry/patch.hpp"
#include "bind/lua/functions.hpp"
#include "bind/lua/open.hpp"
#include "bind/lua/wording/wording.hpp"
#include "bind/scene/scene.hpp"
#include "bind/scene/symbols.hpp"

namespace signorini::bind {

namespace {

template <int D> int push_obstacle(lua_State* L, RigidForm form, contact::Obstacle<D> shape) {
  push_object<Rigid<D>>(L, std::make_shared<const RigidShape<D>>(RigidShape<D>{form, std::move(shape)}));
  return 1;
}

int plane(const Arguments& a, lua_State* L) {
  const auto point = a.get<VectorX>("point"), normal = a.get<VectorX>("normal");
  return point.size() == 2 ? push_obstacle<2>(L, RigidForm::plane, contact::make_plane<2>(point, normal))
                           : push_obstacle<3>(L, RigidForm::plane, contact::make_plane<3>(point, normal));
}

/// A disc or a ball.
template <RigidForm form> int round(const Arguments& a, lua_State* L) {
  const auto center = a.get<VectorX>("center");
  const auto radius = a.get<double>("radius");
  const bool hollow = a.get<bool>("inside");
  return center.size() == 2 ? push_obstacle<2>(L, form, contact::make_ball<2>(center, radius, hollow))
                            : push_obstacle<3>(L, form, contact::make_ball<3>(center, radius, hollow));
}

int cylinder(const Arguments& a, lua_State* L) {
  const auto center = a.get<VectorX>("center"), axis = a.get<VectorX>("axis", {});
  const bool plane = center.size() == 2;
  if (plane && axis.size() > 0)
    a.fail("axis is for cylinders in 3D, whose center is {x, y, z}; a cylinder in the plane is a disc: omit axis");
  if (plane) return round<RigidForm::cylinder>(a, L);
  if (axis.size() == 0) a.refuse("axis", "a list of 3 numbers {x, y, z}, its direction");
  return push_obstacle<3>(L, RigidForm::cylinder,
                          contact::make_cylinder(center, axis, a.get<double>("radius"), a.get<bool>("inside")));
}

int torus(const Arguments& a, lua_State* L) {
  const auto center = a.get<VectorX>("center"), axis = a.get<VectorX>("axis", {});
  if (center.size() == 2) {
    if (axis.size() > 0 || a.has("ring"))
      a.fail("axis and ring are for tori in 3D, whose center is {x, y, z}; in an axisymmetric model center = {r, z} is "
             "the center of the circle: omit ",
             axis.size() > 0 ? "axis" : "ring");
    return round<RigidForm::torus>(a, L);
  }
  if (axis.size() == 0) a.refuse("axis", "a list of 3 numbers {x, y, z}, its direction");
  if (!a.has("ring")) a.refuse("ring", "a positive number, the distance of the circle's center from the axis");
  return push_obstacle<3>(
      L, RigidForm::torus,
      contact::make_torus(center, axis, a.get<double>("ring"), a.get<double>("radius"), a.get<bool>("inside")));
}

/// core.level_set{ f = symbol, low, high }
int level_set(const Arguments& a, lua_State* L) {
  const auto low = a.get<VectorX>("low"), high = a.get<VectorX>("high");
  const auto& f = a.object<Symbol>("f");
  bind::require((low.size() == 2 || low.size() == 3) && low.size() == high.size(), "the corners of a box are expected");
  try {
    return low.size() == 2
               ? push_obstacle<2>(L, RigidForm::level_set, contact::make_level_set<2>({*f.graph, f.node}, low, high))
               : push_obstacle<3>(L, RigidForm::level_set, contact::make_level_set<3>({*f.graph, f.node}, low, high));
  } catch (const Error& error) {
    throw ArgumentError(text("sg.rigid.level_set: ", worded(error)));
  }
}

int rigid_surface(const nurbs::Patch& patch, lua_State* L) {
  const int parameters = patch.parametric_dimension(), needed = patch.dimension() - 1;
  if (parameters > needed)
    reject(L, 1, {"patch"}, "a curve in the plane, or a surface in 3D",
           needed == 1 ? "an edge of it is a curve: patch:face \"north\""
                       : "a face of it is a surface: patch:face \"back\"");
  if (parameters != needed) reject(L, 1, {"patch"}, "a curve in the plane, or a surface in 3D");
  return patch.dimension() == 2 ? push_obstacle<2>(L, RigidForm::surface, patch)
                                : push_obstacle<3>(L, RigidForm::surface, patch);
}

const char* hollow(bool is) {
  return is ? "hollow " : "";
}

struct InWords {
  RigidForm form;

  template <int D> std::string operator()(const contact::Plane<D>& plane) const {
    return text("rigid plane through ", coordinates(plane.point), ", normal ", coordinates(plane.normal));
  }
  template <int D> std::string operator()(const contact::Ball<D>& ball) const {
    return text("rigid ", hollow(ball.hollow),
                form == RigidForm::sphere  ? "sphere"
                : form == RigidForm::torus ? "torus"
                                           : "cylinder",
                " about ", coordinates(ball.center), ", radius ", ball.radius);
  }
  std::string operator()(const contact::Torus& torus) const {
    return text("rigid ", hollow(torus.hollow), "torus about ", coordinates(torus.center), ", axis ",
                coordinates(torus.axis), ", ring ", torus.ring, ", radius ", torus.radius);
  }
  template <int D> std::string operator()(const contact::LevelSet<D>& level_set) const {
    const auto& [graph, node] = level_set.compiled->formula;
    return text("rigid level set of f(", D == 2 ? "x, y" : "x, y, z", ") = ", symbolic::text_of(graph, node),
                ", in the box from ", coordinates(level_set.compiled->low), " to ",
                coordinates(level_set.compiled->high));
  }
  std::string operator()(const contact::Cylinder& cylinder) const {
    return text("rigid ", hollow(cylinder.hollow), "cylinder about ", coordinates(cylinder.point), ", axis ",
                coordinates(cylinder.axis), ", radius ", cylinder.radius);
  }
  std::string operator()(const nurbs::Patch& patch) const {
    const bool curve = patch.parametric_dimension() == 1;
    const std::string first = text(patch.direction(0).degree());
    return curve ? "rigid curve of degree " + first
                 : text("rigid surface of degrees ", first, " and ", patch.direction(1).degree());
  }
};

template <int D> std::string rigid_text(const RigidShape<D>& rigid) {
  return std::visit(InWords{rigid.form}, rigid.shape);
}

constexpr Function rigid_functions[] = {
    {"plane", call<plane>}, {"cylinder", call<cylinder>},     {"sphere", call<round<RigidForm::sphere>>},
    {"torus", call<torus>}, {"surface", call<rigid_surface>},
};
template <int D> constexpr Function rigid_entries[] = {{"__tostring", call<rigid_text<D>>}};

} // namespace

void open_rigid(lua_State* L) {
  register_functions(L, "sg.rigid", rigid_functions);
  register_functions(L, "core", {{"level_set", call<level_set>}});
  register_type<Rigid<2>, Rigid<3>>(L, rigid_entries<2>, rigid_entries<3>);
}

} // namespace signorini::bind
