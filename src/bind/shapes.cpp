#include "nurbs/shapes.hpp"
#include "bind/functions.hpp"
#include "bind/open.hpp"
#include "bind/patch.hpp"

namespace signorini::bind {

namespace {

VectorX origin(int dimension) {
  return VectorX::Zero(dimension);
}

int rectangle(lua_State* L) {
  const Options o(L, 1, {"width", "height", "corner"});
  push_object(L, nurbs::rectangle(o.positive("width", "size along x"), o.positive("height", "size along y"),
                                  o.point("corner", "lower left corner", 2, 2, origin(2))));
  return 1;
}

int half_annulus(lua_State* L) {
  const Options o(L, 1, {"inner", "outer", "centre"});
  push_object(L, nurbs::half_annulus(o.positive("inner", "inner radius"), o.positive("outer", "outer radius"),
                                     o.point("centre", "centre of the circles", 2, 2, origin(2))));
  return 1;
}

int quarter_annulus(lua_State* L) {
  const Options o(L, 1, {"inner", "outer", "centre", "start"});
  push_object(L, nurbs::quarter_annulus(o.positive("inner", "inner radius"), o.positive("outer", "outer radius"),
                                        o.point("centre", "centre of the circles", 2, 2, origin(2)),
                                        o.number("start", "angle of the first end, degrees", 270.0)));
  return 1;
}

int block(lua_State* L) {
  const Options o(L, 1, {"size", "corner"});
  const VectorX size = o.point("size", "sizes along x, y, z", 3, 3);
  push_object(L,
              nurbs::block({size[0], size[1], size[2]}, o.point("corner", "corner of least x, y, z", 3, 3, origin(3))));
  return 1;
}

int half_cylinder_shell(lua_State* L) {
  const Options o(L, 1, {"inner", "outer", "width", "centre"});
  push_object(L, nurbs::half_cylinder_shell(o.positive("inner", "inner radius"), o.positive("outer", "outer radius"),
                                            o.positive("width", "size along y"),
                                            o.point("centre", "start of the axis", 3, 3, origin(3))));
  return 1;
}

int sphere_octant(lua_State* L) {
  const Options o(L, 1, {"inner", "outer", "centre"});
  push_object(L, nurbs::sphere_octant(o.positive("inner", "inner radius"), o.positive("outer", "outer radius"),
                                      o.point("centre", "centre of the spheres", 3, 3, origin(3))));
  return 1;
}

int hollow_hemisphere(lua_State* L) {
  const Options o(L, 1, {"inner", "outer", "centre", "poles"});
  const double inner = o.positive("inner", "inner radius"), outer = o.positive("outer", "outer radius");
  const VectorX centre = o.point("centre", "centre of the spheres", 3, 3, origin(3));
  const std::string poles =
      o.has("poles") ? o.choice("poles", "where the degenerate edges lie", {"ends", "bottom"}) : "ends";
  push_object(
      L, nurbs::hollow_hemisphere(inner, outer, centre, poles == "ends" ? nurbs::Poles::ends : nurbs::Poles::bottom));
  return 1;
}

int spherical_indenter(lua_State* L) {
  const Options o(L, 1, {"width", "depth", "height", "radius", "elements", "corner"});
  push_object(L, nurbs::spherical_indenter(
                     o.positive("width", "size along x"), o.positive("depth", "size along y"),
                     o.positive("height", "from the cap's lowest point to the flat top"),
                     o.positive("radius", "radius of the cap"), o.integer("elements", "spans of the cap", 1),
                     o.point("corner", "x, y of the corner and z of the lowest point", 3, 3, origin(3))));
  return 1;
}

constexpr Function shapes_entries[] = {
    {"rectangle", rectangle,
     "sg.shapes.rectangle{ width, height, corner = {0, 0} }\n"
     "Rectangle with its lower left corner at `corner`, degree 1; xi1 along x, xi2 along y.\n"
     "Example: sg.shapes.rectangle{ width = 3, height = 1 }"},
    {"half_annulus", half_annulus,
     "sg.shapes.half_annulus{ inner, outer, centre = {0, 0} }\n"
     "Half ring below its centre: xi1 along the arc from the left end over the bottom to the right end (two quarter\n"
     "arcs, degree 2), xi2 from the outer (south) to the inner radius (north). The flat ends are west and east.\n"
     "Example: sg.shapes.half_annulus{ inner = 0.3, outer = 0.5, centre = {0.75, 1.5} }"},
    {"quarter_annulus", quarter_annulus,
     "sg.shapes.quarter_annulus{ inner, outer, centre = {0, 0}, start = 270 }\n"
     "Quarter ring from the angle `start` (degrees) counter-clockwise by 90: xi1 along the arc (degree 2), xi2 from "
     "the\n"
     "outer (south) to the inner radius (north).\n"
     "Example: sg.shapes.quarter_annulus{ inner = 0.5, outer = 1, start = 0 }"},
    {"block", block,
     "sg.shapes.block{ size = {a, b, c}, corner = {0, 0, 0} }\n"
     "Block with its corner of least coordinates at `corner`, degree 1; xi1, xi2, xi3 along x, y, z.\n"
     "Example: sg.shapes.block{ size = {6, 4, 2} }"},
    {"half_cylinder_shell", half_cylinder_shell,
     "sg.shapes.half_cylinder_shell{ inner, outer, width, centre = {0, 0, 0} }\n"
     "Lower half of a pipe along y: xi1 along the arc (degree 2), xi2 along y, xi3 from the outer (front) to the "
     "inner\n"
     "radius (back). With its centre at the origin west (x < 0) and east (x > 0) lie in z = 0, south in y = 0, north "
     "in\n"
     "y = width.\n"
     "Example: sg.shapes.half_cylinder_shell{ inner = 0.3, outer = 0.5, width = 2 }"},
    {"sphere_octant", sphere_octant,
     "sg.shapes.sphere_octant{ inner, outer, centre = {0, 0, 0} }\n"
     "Lower octant of a hollow sphere: xi1 around the z axis, xi2 from the equator to the pole, xi3 from the outer\n"
     "(front) to the inner radius (back). With its centre at the origin it fills x, y > 0 and z < 0: west lies in y = "
     "0,\n"
     "east in x = 0, south in z = 0; north is the axis x = y = 0, where the map is degenerate. Symmetry needs west\n"
     "fixed along y and east along x.\n"
     "Example: sg.shapes.sphere_octant{ inner = 0.5, outer = 1 }"},
    {"hollow_hemisphere", hollow_hemisphere,
     "sg.shapes.hollow_hemisphere{ inner, outer, centre = {0, 0, 0}, poles = \"ends\" | \"bottom\" }\n"
     "Lower half of a hollow sphere, exact, degree 2; xi3 from the outer (front) to the inner radius (back). The map\n"
     "has poles, where an edge is one point:\n"
     "poles = \"ends\" (default): at both ends of the ring's diameter along y, none where it touches a plane below. "
     "xi1\n"
     "from -x over the bottom to x, xi2 from -y to y; the flat ring on top, in z = 0 with the centre at the origin, is "
     "two\n"
     "faces, west (x < 0) and east (x > 0); south and north are degenerate, on the line x = z = 0.\n"
     "poles = \"bottom\": one, at the lowest point. xi1 once around the z axis (at least 4 elements), xi2 from the "
     "ring\n"
     "down to the pole; the flat ring in z = 0 is one face, south, and the mesh the same at every angle; north is the\n"
     "axis x = y = 0, west and east are the seam in y = 0.\n"
     "Example: sg.shapes.hollow_hemisphere{ inner = 2/3, outer = 1, centre = {0, 0, 3} }"},
    {"spherical_indenter", spherical_indenter,
     "sg.shapes.spherical_indenter{ width, depth, height, radius, elements, corner = {0, 0, 0} }\n"
     "Block with a flat top whose bottom (front) bulges down as a spherical cap of the given radius, approximated by\n"
     "elements x elements biquadratic spans that pass through the sphere. `height` is measured at the lowest point.\n"
     "west, east, south and north lie in x = 0, x = width, y = 0 and y = depth, back in z = height.\n"
     "The cap's own knots keep their continuity under every label: with elements = 1 labels count as on a block.\n"
     "Example: sg.shapes.spherical_indenter{ width = 1, depth = 1, height = 0.6, radius = 2, elements = 4 }"},
};

} // namespace

void open_shapes(lua_State* L) {
  register_functions(L, "sg.shapes", shapes_entries);
}

} // namespace signorini::bind
