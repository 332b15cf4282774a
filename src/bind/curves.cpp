#include "bind/functions.hpp"
#include "bind/open.hpp"
#include "bind/patch.hpp"
#include "nurbs/shapes.hpp"
#include "nurbs/transform.hpp"

namespace signorini::bind {

using nurbs::KnotVector;
using nurbs::Patch;

namespace {

/// Points and weights of a patch with the given directions.
Patch read_patch(const Options& o, std::vector<KnotVector> directions) {
  const MatrixX points = o.points("points", "control points, fastest in xi1");
  const auto weights = o.numbers("weights", "one per control point", std::vector<double>{});
  return nurbs::make_patch(std::move(directions), points,
                           Eigen::Map<const VectorX>(weights.data(), static_cast<Eigen::Index>(weights.size())));
}

int curve(lua_State* L) {
  const Options o(L, 1, {"degree", "knots", "points", "weights"});
  const int degree = o.integer("degree", "polynomial degree", 1, nurbs::max_degree);
  push_object(L, read_patch(o, {KnotVector(degree, o.numbers("knots", "open knot vector"))}));
  return 1;
}

int tensor(lua_State* L, int directions) {
  const Options o(L, 1, {"degrees", "knots", "points", "weights"});
  const auto degrees = read_per_direction(L, o.push_value("degrees"), o.argument("degrees", "polynomial degrees"),
                                          directions, 1, nurbs::max_degree);
  const int knots = o.push_value("knots");
  const auto argument = o.argument("knots", "one open knot vector per direction");
  const auto expected = text("a list of ", directions, " knot vectors");
  if (read_list(L, knots, argument, expected.c_str()) != directions) reject(L, knots, argument, expected);
  std::vector<KnotVector> all;
  for (int d = 0; d < directions; ++d) {
    lua_rawgeti(L, knots, d + 1);
    all.emplace_back(degrees[static_cast<std::size_t>(d)], read_numbers(L, -1, {text("knots[", d + 1, "]")}));
    lua_pop(L, 1);
  }
  push_object(L, read_patch(o, std::move(all)));
  return 1;
}

int patch_surface(lua_State* L) {
  return tensor(L, 2);
}
int volume(lua_State* L) {
  return tensor(L, 3);
}

int line(lua_State* L) {
  const Options o(L, 1, {"from", "to"});
  const VectorX from = o.point("from", "first end");
  const int dimension = static_cast<int>(from.size());
  push_object(L, nurbs::line(from, o.point("to", "other end", dimension, dimension)));
  return 1;
}

int arc(lua_State* L) {
  const Options o(L, 1, {"radius", "from", "to", "centre"});
  const VectorX centre = o.point("centre", "centre of the circle", 2, 3, VectorX::Zero(2));
  const double radius = o.positive("radius", "radius"), from = o.number("from", "first angle, degrees");
  push_object(L, nurbs::arc(centre, radius, from, o.number("to", "last angle, degrees")));
  return 1;
}

int circle(lua_State* L) {
  const Options o(L, 1, {"radius", "centre"});
  const VectorX centre = o.point("centre", "centre", 2, 3, VectorX::Zero(2));
  push_object(L, nurbs::circle(centre, o.positive("radius", "radius")));
  return 1;
}

int ruled(lua_State* L) {
  const Options o(L, 1, {"a", "b"});
  const Patch& a = o.object<Patch>("a", "first patch");
  push_object(L, nurbs::ruled(a, o.object<Patch>("b", "second patch")));
  return 1;
}

int extrude(lua_State* L) {
  const Options o(L, 1, {"patch", "along"});
  const Patch& patch = o.object<Patch>("patch", "what is swept");
  const VectorX along = o.point("along", "the vector of the sweep");
  if (patch.parametric_dimension() == 2 && patch.dimension() == 2 && along.size() == 2)
    reject(L, o.push_value("along"), o.argument("along", "the vector of the sweep"), "a list of 3 numbers {x, y, z}",
           "a plane surface lies in z = 0 and is swept out of its plane, as by {0, 0, 1}");
  push_object(L, nurbs::extrude(patch, along));
  return 1;
}

int revolve(lua_State* L) {
  const Options o(L, 1, {"patch", "point", "axis", "angle"});
  const Patch& patch = o.object<Patch>("patch", "what is revolved");
  const bool plane = patch.dimension() == 2;
  const auto vector = [&](const char* key, const char* meaning, const VectorX& otherwise) {
    VectorX value = o.point(key, meaning, patch.dimension(), 3, otherwise);
    value.conservativeResizeLike(VectorX::Zero(3));
    return value;
  };
  const VectorX point = vector("point", "a point of the axis", VectorX::Zero(3));
  // A right-handed section at x > 0 makes a right-handed volume about −y.
  const VectorX axis = vector("axis", "direction of the axis", plane ? Vec<3>(0, -1, 0) : Vec<3>(0, 0, 1));
  if (plane && patch.parametric_dimension() == 2 && axis(0) == 0 && axis(1) == 0)
    throw ArgumentError(text(function_name(L), ": axis is normal to the plane of the patch, z = 0, which would only ",
                             "turn in it: give an axis in the plane, as {0, -1}, or leave it out"));
  push_object(L,
              nurbs::revolve(plane ? nurbs::to_space(patch) : patch, point, axis, o.number("angle", "degrees", 360.0)));
  return 1;
}

int coons(lua_State* L) {
  const std::vector<std::string> names = {"west", "east", "south", "north", "front", "back"};
  const Options o(L, 1, names);
  const std::size_t sides = o.has("front") || o.has("back") ? 6 : 4;
  std::vector<Patch> boundary;
  for (std::size_t i = 0; i < sides; ++i)
    boundary.push_back(o.object<Patch>(names[i].c_str(), sides == 4 ? "boundary curve" : "boundary surface"));
  push_object(L, nurbs::coons(boundary));
  return 1;
}

constexpr Function curves_entries[] = {
    {"curve", curve,
     "sg.nurbs.curve{ degree, knots, points, weights = {1, …} }\n"
     "A NURBS curve in 2D or 3D. The knot vector is open (its ends are repeated degree + 1 times) and has as many "
     "knots\n"
     "as points + degree + 1.\n"
     "Example: sg.nurbs.curve{ degree = 2, knots = {0, 0, 0, 1, 1, 1}, points = {{0, 0}, {1, 2}, {2, 0}} }"},
    {"surface", patch_surface,
     "sg.nurbs.surface{ degrees = {p, q}, knots = {U, V}, points, weights = {1, …} }\n"
     "A tensor-product NURBS surface in 2D or 3D; points run fastest in xi1.\n"
     "Example: sg.nurbs.surface{ degrees = {1, 1}, knots = {{0, 0, 1, 1}, {0, 0, 1, 1}},\n"
     "                           points = {{0, 0}, {1, 0}, {0, 1}, {1, 1}} }"},
    {"volume", volume,
     "sg.nurbs.volume{ degrees = {p, q, r}, knots = {U, V, W}, points, weights = {1, …} }\n"
     "A tensor-product NURBS volume; points run fastest in xi1, then xi2.\n"
     "Example: sg.nurbs.volume{ degrees = {1, 1, 1}, knots = {{0, 0, 1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1}},\n"
     "                          points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, "
     "{1, 1, 2}} }"},
    {"line", line,
     "sg.nurbs.line{ from, to }\n"
     "A straight line, degree 1.\n"
     "Example: sg.nurbs.line{ from = {0, 0}, to = {3, 0} }"},
    {"arc", arc,
     "sg.nurbs.arc{ radius, from, to, centre = {0, 0} }\n"
     "A circular arc from one angle to another (degrees, counter-clockwise when rising), exact, degree 2, one segment\n"
     "per started quarter turn. A centre in 3D gives an arc parallel to the x-y plane.\n"
     "Example: sg.nurbs.arc{ radius = 0.5, from = 180, to = 360 }"},
    {"circle", circle,
     "sg.nurbs.circle{ radius, centre = {0, 0} }\n"
     "A full circle of four quarter arcs, exact, degree 2.\n"
     "Example: sg.nurbs.circle{ radius = 1 }"},
    {"ruled", ruled,
     "sg.nurbs.ruled{ a, b }\n"
     "Straight lines between two curves or two surfaces, which are brought to common degrees and knots first; the new\n"
     "direction is the last one.\n"
     "Example: sg.nurbs.ruled{ a = sg.nurbs.circle{ radius = 2 }, b = sg.nurbs.circle{ radius = 1 } }"},
    {"extrude", extrude,
     "sg.nurbs.extrude{ patch, along }\n"
     "Sweeps a curve or a surface along a vector; the new direction is the last one, degree 1. A plane patch lies\n"
     "in z = 0 where the vector is one in 3D.\n"
     "Example: sg.nurbs.extrude{ patch = sg.nurbs.line{ from = {0, 0}, to = {1, 0} }, along = {0, 2} }\n"
     "Example: sg.nurbs.extrude{ patch = sg.shapes.quarter_annulus{ inner = 1, outer = 2 }, along = {0, 0, 1} }"},
    {"revolve", revolve,
     "sg.nurbs.revolve{ patch, point = {0, 0, 0}, axis = {0, 0, 1}, angle = 360 }\n"
     "Revolves a curve or a surface about an axis by an angle in degrees, exact; the new direction is the last one.\n"
     "A plane patch lies in z = 0; its axis is {0, -1, 0} unless another is given: as in axisymmetric models, x is\n"
     "the radius, and what is right-handed at x > 0 gives a right-handed volume.\n"
     "Example: sg.nurbs.revolve{ patch = sg.nurbs.line{ from = {1, 0, 0}, to = {1, 0, 2} }, angle = 180 }\n"
     "Example: sg.nurbs.revolve{ patch = sg.shapes.rectangle{ width = 1, height = 2, corner = {3, 0} }, angle = 90 }"},
    {"coons", coons,
     "sg.nurbs.coons{ west, east, south, north, front, back }\n"
     "Coons patch: the surface between four boundary curves or the volume between six boundary surfaces "
     "(then with front\n"
     "and back), whose corners meet. west and east run along xi2, south and north along xi1.\n"
     "Example: sg.nurbs.coons{ west = sg.nurbs.line{ from = {0, 0}, to = {0, 1} }, east = sg.nurbs.line{ from = {1, "
     "0}, to = {1, 2} },\n"
     "                         south = sg.nurbs.line{ from = {0, 0}, to = {1, 0} }, north = sg.nurbs.line{ from = {0, "
     "1}, to = {1, 2} } }"},
};

} // namespace

void open_curves(lua_State* L) {
  register_functions(L, "sg.nurbs", curves_entries);
}

} // namespace signorini::bind
