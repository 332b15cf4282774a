#include "bind/geometry/patch.hpp"
#include "bind/lua/functions.hpp"
#include "bind/lua/open.hpp"
#include "nurbs/shapes.hpp"
#include "nurbs/transform.hpp"

namespace signorini::bind {

using nurbs::KnotVector;
using nurbs::Patch;

namespace {

/// The patch with these directions and the points and weights of a call.
Patch with_points(const Arguments& a, std::vector<KnotVector> directions) {
  const auto weights = a.get<std::vector<double>>("weights", {});
  return nurbs::make_patch(std::move(directions), a.get<MatrixX>("points"),
                           Eigen::Map<const VectorX>(weights.data(), static_cast<Eigen::Index>(weights.size())));
}

Patch curve(const Arguments& a) {
  return with_points(a, {KnotVector(a.get<int>("degree"), a.get<std::vector<double>>("knots"))});
}

/// A surface or a volume.
Patch tensor_product(const Arguments& a) {
  const auto degrees = a.get<std::vector<int>>("degrees");
  std::vector<KnotVector> directions;
  a.list("knots", [&](int i, int index, const std::string&) {
    directions.emplace_back(degrees[i], to<std::vector<double>>(a.state(), index));
  });
  return with_points(a, std::move(directions));
}

Patch extrude(const Arguments& a) {
  const auto& patch = a.object<Patch>("patch");
  const auto along = a.get<VectorX>("along");
  if (patch.parametric_dimension() == 2 && patch.dimension() == 2 && along.size() == 2)
    a.refuse("along", "a list of 3 numbers {x, y, z}",
             "a plane surface lies in z = 0 and must be extruded out of its plane, for example by {0, 0, 1}");
  return nurbs::extrude(patch, along);
}

Patch revolve(const Arguments& a) {
  const auto& patch = a.object<Patch>("patch");
  const bool plane = patch.dimension() == 2;
  const auto vector = [&](const char* key, const VectorX& otherwise) {
    auto value = a.get<VectorX>(key, otherwise);
    value.conservativeResizeLike(VectorX::Zero(3));
    return value;
  };
  // A right-handed section at x > 0 gives a right-handed volume about −y.
  const VectorX axis = vector("axis", plane ? Vec<3>(0, -1, 0) : Vec<3>(0, 0, 1));
  if (plane && patch.parametric_dimension() == 2 && axis(0) == 0 && axis(1) == 0)
    a.fail("axis must not be normal to the plane of the patch, z = 0: give an axis in the plane, such as {0, -1}, or ",
           "omit it");
  return nurbs::revolve(plane ? nurbs::to_space(patch) : patch, vector("point", VectorX::Zero(3)), axis,
                        a.get<double>("angle"));
}

Patch coons(const Arguments& a) {
  std::vector<Patch> boundary;
  for (const char* side : {"west", "east", "south", "north"}) boundary.push_back(a.object<Patch>(side));
  if (a.has("front") || a.has("back"))
    for (const char* side : {"front", "back"}) boundary.push_back(a.object<Patch>(side));
  return nurbs::coons(boundary);
}

constexpr Function curves_entries[] = {
    {"curve", call<curve>},
    {"surface", call<tensor_product>},
    {"volume", call<tensor_product>},
    {"line", made<nurbs::line, "from", "to">},
    {"arc", made<nurbs::arc, "center", "radius", "from", "to">},
    {"circle", made<nurbs::circle, "center", "radius">},
    {"ruled", made<nurbs::ruled, "a", "b">},
    {"extrude", call<extrude>},
    {"revolve", call<revolve>},
    {"coons", call<coons>},
};

} // namespace

void open_curves(lua_State* L) {
  register_functions(L, "sg.nurbs", curves_entries);
}

} // namespace signorini::bind
