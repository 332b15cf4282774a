#include "bind/geometry/patch.hpp"

#include "bind/geometry/geometry.hpp"
#include "bind/lua/open.hpp"
#include "nurbs/directions.hpp"
#include "nurbs/transform.hpp"

namespace signorini::bind {

using nurbs::Patch;

namespace {

/// A parametric direction, from 1 in Lua, from 0 here.
int direction_at(lua_State* L, int index) {
  return to<int>(L, index) - 1;
}

int derivatives(const Patch& patch, const VectorX& xi, int order, lua_State* L) {
  push_list(L, nurbs::derivatives(patch, xi, order),
            [&](const auto& one) { push_fields(L, "orders", one.orders, "value", one.value); });
  return 1;
}

int basis(const Patch& patch, const VectorX& xi, lua_State* L) {
  push_list(L, nurbs::rational_basis(patch, xi),
            [&](const auto& one) { push_fields(L, "index", one.function + 1, "value", one.value); });
  return 1;
}

Patch refine(const Patch& patch, const Arguments& a) {
  const auto elements = a.get<std::vector<int>>("elements", {}), degree = a.get<std::vector<int>>("degree", {});
  auto gradings = gradings_of(a, "grading");
  gradings.resize(patch.directions().size());
  Patch refined = patch;
  for (std::size_t d = 0; d < gradings.size(); ++d) {
    const nurbs::KnotVector& own = patch.directions()[d];
    const auto knots = elements.empty() ? std::vector<double>{} : nurbs::element_knots(own, elements[d], gradings[d]);
    refined = nurbs::k_refine(refined, static_cast<int>(d), degree.empty() ? own.degree() : degree[d], knots);
  }
  return refined;
}

Patch face_of_patch(const Patch& patch, const std::string& name) {
  require(patch.parametric_dimension() > 1,
          "a curve has end points, but no faces: evaluate it at its first and last knot, as in curve(0)");
  return nurbs::face(patch, nurbs::side_of(name, patch.parametric_dimension()));
}

/// An integer per direction.
template <int (nurbs::KnotVector::*number)() const> std::vector<int> per_direction(const Patch& patch) {
  std::vector<int> values;
  for (const auto& direction : patch.directions()) values.push_back((direction.*number)());
  return values;
}

std::string patch_text(const Patch& patch) {
  const char* kinds[] = {"curve", "surface", "volume"};
  const auto each = [&](auto number) { return joined_by(" x ", patch.directions(), number); };
  return text("NURBS ", kinds[patch.parametric_dimension() - 1], " in ", patch.dimension(), "D: degree ",
              each(&nurbs::KnotVector::degree), ", elements ", each(&nurbs::KnotVector::elements), ", ",
              patch.functions(), " control points");
}

/// An argument that defaults to the origin of the patch's space.
VectorX point_of(const Arguments& a, const char* key, const Patch& patch) {
  return a.get<VectorX>(key, VectorX::Zero(patch.dimension()));
}

Patch rotate(const Patch& patch, const Arguments& a) {
  if (patch.dimension() == 3 && !a.has("axis")) a.refuse("axis", "a list of 3 numbers {x, y, z}, its direction");
  return nurbs::rotate(patch, a.get<double>("angle"), point_of(a, "center", patch), a.get<VectorX>("axis", {}));
}

Patch scale(const Patch& patch, const Arguments& a) {
  const bool each = a.is("factor", LUA_TTABLE);
  const VectorX factors =
      each ? a.get<VectorX>("factor") : VectorX::Constant(patch.dimension(), a.get<double>("factor"));
  return nurbs::scale(patch, factors, point_of(a, "center", patch));
}

Patch mirror(const Patch& patch, const Arguments& a) {
  return nurbs::mirror(patch, point_of(a, "point", patch), a.get<VectorX>("normal"));
}

int swap(const Patch& patch, lua_State* L) {
  require(patch.parametric_dimension() > 1, "a curve has only one parametric direction, two are needed");
  const int i = direction_at(L, 2), j = direction_at(L, 3);
  if (i == j) reject(L, 3, {"j"}, "another direction than i");
  push(L, nurbs::swap_directions(patch, i, j));
  return 1;
}

// ── Files of other programs ──────────────────────────────────────────────────────────────────────────────────────────

/// Writes to the file at a stack index, in the format given as third argument, by default that of the extension.
int write_to(lua_State* L, int file_index, const exchange::Geometry& geometry) {
  const auto file = to<std::string>(L, file_index);
  const auto form = lua_isnoneornil(L, 3) ? exchange::form_named_by(file) : to<std::string>(L, 3);
  if (form.empty())
    reject(L, file_index, {"file", "name of the file"}, "a name that ends with .xml, .txt or .mesh",
           "or give also the format: " + one_of(exchange::forms()));
  exchange::write_geometry(file, geometry, form);
  return 0;
}

int write_patches(lua_State* L) {
  const auto* patch = test_object<Patch>(L, 2);
  return write_to(L, 1, patch ? exchange::Geometry{{*patch}} : read_geometry(L, 2));
}

/// core.patch_sizes(patch): its number of parametric directions and of coordinates.
int patch_sizes(const Patch& patch, lua_State* L) {
  push(L, patch.parametric_dimension());
  push(L, patch.dimension());
  return 2;
}

int read_patches(const std::string& file, lua_State* L) {
  push_geometry(L, exchange::read_geometry(file));
  return 1;
}

constexpr Function patch_entries[] = {
    {"__call", call<nurbs::evaluate<nurbs::KnotVector>>},
    {"__tostring", call<patch_text>},
    {"evaluate", call<nurbs::evaluate<nurbs::KnotVector>>},
    {"derivatives", call<derivatives>},
    {"basis", call<basis>},
    {"insert", call<[](const Patch& patch, int d, const std::vector<double>& knots) {
       return nurbs::insert_knots(patch, d - 1, knots);
     }>},
    {"elevate", call<[](const Patch& patch, int d, int times) { return nurbs::elevate(patch, d - 1, times); }>},
    {"refine", call<refine>},
    {"face", call<face_of_patch>},
    {"degrees", call<per_direction<&nurbs::KnotVector::degree>>},
    {"elements", call<per_direction<&nurbs::KnotVector::elements>>},
    {"knots", call<[](const Patch& patch, int d) { return patch.direction(d - 1).knots(); }>},
    {"points", call<[](const Patch& patch) { return patch.points(); }>},
    {"weights", call<[](const Patch& patch) { return patch.weights(); }>},
    {"translate", call<nurbs::translate>},
    {"rotate", call<rotate>},
    {"scale", call<scale>},
    {"mirror", call<mirror>},
    {"reverse", call<[](const Patch& patch, int d) { return nurbs::reverse(patch, d - 1); }>},
    {"swap", call<swap>},
    {"to_plane", call<nurbs::to_plane>},
    {"to_space",
     call<[](const Patch& patch, const Arguments& a) { return nurbs::to_space(patch, a.get<double>("z")); }>},
    {"write", call<[](const Patch& patch, lua_State* L) { return write_to(L, 2, {{patch}}); }>},
};

} // namespace

std::vector<Patch> patches_of(const Arguments& a, const char* key) {
  std::vector<Patch> patches;
  a.list(key, [&](int, int index, const std::string& path) {
    patches.push_back(read_object<Patch>(a.state(), index));
    const int first = patches.front().dimension(), own = patches.back().dimension();
    require(own == first, path, " is in ", own, "D and patch[1] in ", first, "D: write them to separate files");
  });
  return patches;
}

std::vector<std::optional<nurbs::Grading>> gradings_of(const Arguments& a, const char* key) {
  std::vector<std::optional<nurbs::Grading>> gradings;
  if (!a.has(key)) return gradings;
  a.list(key, [&](int, int index, const std::string& path) {
    gradings.emplace_back();
    if (!lua_istable(a.state(), index)) return;
    const Arguments one(a.state(), index, path);
    gradings.back() = {one.get<double>("elements"), one.get<double>("length"), one.get<std::string>("at") == "end"};
  });
  return gradings;
}

void open_patch(lua_State* L) {
  register_type<Patch>(L, patch_entries);
  register_functions(L, "sg.nurbs", {{"read", call<read_patches>}, {"write", write_patches}});
  register_functions(L, "core", {{"patch_sizes", call<patch_sizes>}});
  push_table(L, "core");
  set_fields(L, "max_degree", nurbs::max_degree, "patch_forms", exchange::forms());
  lua_pop(L, 1);
}

} // namespace signorini::bind
