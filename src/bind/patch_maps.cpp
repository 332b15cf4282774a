// Patches moved, turned, scaled, mirrored, and with other parametric directions.
#include "bind/patch.hpp"
#include "nurbs/directions.hpp"
#include "nurbs/transform.hpp"

namespace signorini::bind {

using nurbs::Patch;

namespace {

int translate(lua_State* L) {
  const Patch& patch = self<Patch>(L);
  const int dimension = patch.dimension();
  push_object(L, nurbs::translate(patch, read_point(L, 2, {"by", "displacement"}, dimension, dimension)));
  return 1;
}

int rotate(lua_State* L) {
  const Patch& patch = self<Patch>(L);
  const int dimension = patch.dimension();
  const VectorX origin = VectorX::Zero(dimension);
  const bool spatial = dimension == 3;
  const Options o(L, 2,
                  spatial ? std::vector<std::string>{"angle", "centre", "axis"}
                          : std::vector<std::string>{"angle", "centre"});
  const double angle = o.number("angle", "degrees, counter-clockwise");
  const VectorX centre = o.point("centre", "the point that stays", dimension, dimension, origin);
  push_object(
      L, nurbs::rotate(patch, angle, centre, spatial ? o.point("axis", "direction of the axis", 3, 3) : VectorX()));
  return 1;
}

int scale(lua_State* L) {
  const Patch& patch = self<Patch>(L);
  const int dimension = patch.dimension();
  const Options o(L, 2, {"factor", "centre"});
  const int factor = o.push_value("factor");
  const Argument argument = o.argument("factor", "one for all coordinates, or a list of one each");
  const VectorX factors = lua_istable(L, factor) ? read_point(L, factor, argument, dimension, dimension)
                                                 : VectorX::Constant(dimension, read_positive(L, factor, argument));
  push_object(L,
              nurbs::scale(patch, factors,
                           o.point("centre", "the point that stays", dimension, dimension, VectorX::Zero(dimension))));
  return 1;
}

int mirror(lua_State* L) {
  const Patch& patch = self<Patch>(L);
  const int dimension = patch.dimension();
  const Options o(L, 2, {"normal", "point"});
  const VectorX normal = o.point("normal", "the direction across the mirror", dimension, dimension);
  push_object(
      L, nurbs::mirror(patch, o.point("point", "a point of the mirror", dimension, dimension, VectorX::Zero(dimension)),
                       normal));
  return 1;
}

int reverse(lua_State* L) {
  const Patch& patch = self<Patch>(L);
  push_object(L, nurbs::reverse(patch, read_direction(L, 2, patch)));
  return 1;
}

int swap(lua_State* L) {
  const Patch& patch = self<Patch>(L);
  if (patch.parametric_dimension() == 1)
    throw ArgumentError(
        text(function_name(L), ": a curve has one parametric direction, and nothing to exchange it with"));
  const int i = read_direction(L, 2, patch, "i"), j = read_direction(L, 3, patch, "j");
  if (i == j) reject(L, 3, {"j", "parametric direction, counted from 1"}, "another direction than i");
  push_object(L, nurbs::swap_directions(patch, i, j));
  return 1;
}

int to_plane(lua_State* L) {
  push_object(L, nurbs::to_plane(self<Patch>(L)));
  return 1;
}

int to_space(lua_State* L) {
  const Patch& patch = self<Patch>(L);
  const double z = lua_isnoneornil(L, 2) ? 0 : Options(L, 2, {"z"}).number("z", "of all its points", 0.0);
  push_object(L, nurbs::to_space(patch, z));
  return 1;
}

constexpr Function patch_maps_entries[] = {
    {"translate", translate,
     "p:translate{dx, dy}\nA new patch moved by a vector.\n"
     "Example: patch:translate{1, 0}{0, 0}  --> {1.0, 0.0}"},
    {"rotate", rotate,
     "p:rotate{ angle, centre = {0, 0} }, in 3D p:rotate{ angle, axis, centre = {0, 0, 0} }\n"
     "A new patch turned by an angle in degrees (counter-clockwise), in 3D about the axis through the centre.\n"
     "Example: patch:rotate{ angle = 30, centre = {1.5, 0.5} }"},
    {"scale", scale,
     "p:scale{ factor, centre = {0, 0} }\n"
     "A new patch scaled about a centre, by one factor or by a list of one factor per coordinate.\n"
     "Example: patch:scale{ factor = {2, 1} }{1, 1}  --> {6.0, 1.0}"},
    {"mirror", mirror,
     "p:mirror{ normal, point = {0, 0} }\n"
     "The mirror image across a line through the point, in 3D across a plane through it, with the given normal. The\n"
     "direction that runs most along the normal is reversed, so that the image of a body is right-handed again and\n"
     "the outside of an obstacle stays outside; curves in 3D keep their direction.\n"
     "Example: patch:mirror{ normal = {1, 0} }{0, 0}  --> {-3.0, 0.0}"},
    {"reverse", reverse,
     "p:reverse(dir)\n"
     "The same shape with direction dir (1, 2, 3) run backwards: its two faces exchange their names. A left-handed\n"
     "patch becomes right-handed, as sg.body wants it, and sg.rigid.surface has its outside on the other side.\n"
     "Source: as nrbreverse of the nurbs toolbox.\n"
     "Example: patch:reverse(1){0, 0}  --> {3.0, 0.0}"},
    {"swap", swap,
     "p:swap(i, j)\n"
     "The same shape with the directions i and j (1, 2, 3) exchanged. Whether it is right-handed changes: another\n"
     "p:reverse puts that right.\n"
     "Source: as nrbpermute and nrbtransp of the nurbs toolbox for two directions.\n"
     "Example: patch:swap(1, 2){1, 0}  --> {0.0, 1.0}"},
    {"to_plane", to_plane,
     "p:to_plane()\n"
     "A curve or surface in 3D whose z is the same everywhere as one in the plane, for plane bodies: programs such as\n"
     "G+Smo write flat patches with three coordinates. An error where z changes; a plane patch stays as it is.\n"
     "Example: sg.nurbs.line{ from = {0, 0, 4}, to = {3, 1, 4} }:to_plane()(1)  --> {3.0, 1.0}"},
    {"to_space", to_space,
     "p:to_space{ z = 0 }\n"
     "A curve or surface in the plane as one in 3D, all its points at one z.\n"
     "Example: patch:to_space{ z = 2 }{1, 1}  --> {3.0, 1.0, 2.0}"},
};

} // namespace

std::span<const Function> patch_map_rows() {
  return patch_maps_entries;
}

} // namespace signorini::bind
