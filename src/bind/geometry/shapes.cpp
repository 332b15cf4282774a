#include "nurbs/shapes.hpp"
#include "bind/geometry/geometry.hpp"
#include "bind/geometry/patch.hpp"
#include "bind/lua/arguments.hpp"
#include "bind/lua/functions.hpp"
#include "bind/lua/open.hpp"

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

template <auto function, Name... names> int made_several(lua_State* L) {
  auto [patches, boundaries] = result_of(+function, Arguments(L), names...);
  push_geometry(L, {std::move(patches), std::nullopt, std::move(boundaries)});
  return 1;
}

constexpr Function shapes_rows[] = {
    {"rectangle", made<nurbs::rectangle, "width", "height", "corner">},
    {"half_annulus", made<nurbs::half_annulus, "inner", "outer", "center">},
    {"quarter_annulus", made<nurbs::quarter_annulus, "inner", "outer", "center", "start">},
    {"ring", made<nurbs::ring, "inner", "outer", "center">},
    {"disc", made_several<nurbs::disc, "radius", "center">},
    {"polar_disc", made<nurbs::polar_disc, "radius", "center">},
    {"hook", made<nurbs::hook, "length", "thickness", "nose", "land", "insertion", "retention", "corner">},
    {"block", call<block>},
    {"half_cylinder_shell", made<nurbs::half_cylinder_shell, "inner", "outer", "width", "center">},
    {"tube", made<nurbs::tube, "inner", "outer", "width", "center">},
    {"cylinder", made_several<nurbs::cylinder, "radius", "width", "center">},
    {"polar_cylinder", made<nurbs::polar_cylinder, "radius", "width", "center">},
    {"torus", made_several<nurbs::torus, "radius", "section", "center">},
    {"ball", made_several<nurbs::ball, "radius", "center">},
    {"polar_ball", made<nurbs::polar_ball, "radius", "center">},
    {"sphere_octant", made<nurbs::sphere_octant, "inner", "outer", "center">},
    {"hollow_hemisphere", call<hollow_hemisphere>},
    {"spherical_indenter", made<nurbs::spherical_indenter, "width", "depth", "height", "radius", "elements", "corner">},
};

} // namespace

void open_shapes(lua_State* L) {
  register_functions(L, "sg.shapes", shapes_rows);
}

} // namespace signorini::bind
