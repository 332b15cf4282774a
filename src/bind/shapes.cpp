#include "nurbs/shapes.hpp"
#include "bind/arguments.hpp"
#include "bind/functions.hpp"
#include "bind/open.hpp"
#include "bind/patch.hpp"

namespace signorini::bind {

namespace {

nurbs::Patch block(const Arguments& a) {
  const auto size = a.get<VectorX>("size");
  return nurbs::block({size[0], size[1], size[2]}, a.get<VectorX>("corner"));
}

nurbs::Patch hollow_hemisphere(const Arguments& a) {
  const bool at_ends = a.get<std::string>("poles") == "ends";
  return nurbs::hollow_hemisphere(a.get<double>("inner"), a.get<double>("outer"), a.get<VectorX>("center"),
                                  at_ends ? nurbs::Poles::ends : nurbs::Poles::bottom);
}

constexpr Function shapes_rows[] = {
    {"rectangle", made<nurbs::rectangle, "width", "height", "corner">},
    {"half_annulus", made<nurbs::half_annulus, "inner", "outer", "center">},
    {"quarter_annulus", made<nurbs::quarter_annulus, "inner", "outer", "center", "start">},
    {"block", call<block>},
    {"half_cylinder_shell", made<nurbs::half_cylinder_shell, "inner", "outer", "width", "center">},
    {"sphere_octant", made<nurbs::sphere_octant, "inner", "outer", "center">},
    {"hollow_hemisphere", call<hollow_hemisphere>},
    {"spherical_indenter", made<nurbs::spherical_indenter, "width", "depth", "height", "radius", "elements", "corner">},
};

} // namespace

void open_shapes(lua_State* L) {
  register_functions(L, "sg.shapes", shapes_rows);
}

} // namespace signorini::bind
