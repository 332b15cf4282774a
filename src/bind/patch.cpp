#include "bind/patch.hpp"

#include "bind/open.hpp"
#include "nurbs/directions.hpp"
#include "nurbs/transform.hpp"

namespace signorini::bind {

using nurbs::Patch;

namespace {

int evaluate_at(lua_State* L) {
  return returned(L, nurbs::evaluate(self<Patch>(L), to<VectorX>(L, 2)));
}

/// Pushes a list with a table for each of some values, which `fill` sets the fields of.
template <class T, class Fill> int push_tables(lua_State* L, const std::vector<T>& values, Fill fill) {
  lua_createtable(L, static_cast<int>(values.size()), 0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    lua_createtable(L, 0, 2);
    fill(values[i]);
    lua_rawseti(L, -2, static_cast<lua_Integer>(i) + 1);
  }
  return 1;
}

int derivatives(lua_State* L) {
  return push_tables(L, nurbs::derivatives(self<Patch>(L), to<VectorX>(L, 2), to<int>(L, 3)), [&](const auto& one) {
    set_field(L, "orders", one.orders);
    set_field(L, "value", one.value);
  });
}

int basis(lua_State* L) {
  return push_tables(L, nurbs::rational_basis(self<Patch>(L), to<VectorX>(L, 2)), [&](const auto& one) {
    set_field(L, "index", one.function + 1);
    set_field(L, "value", one.value);
  });
}

int refine(lua_State* L) {
  const Patch& patch = self<Patch>(L);
  const Arguments a(L, 2);
  const auto elements = a.get<std::vector<int>>("elements", {}), degree = a.get<std::vector<int>>("degree", {});
  if (a.has("grading") && elements.empty()) a.fail("grading needs elements, the number of those that it distributes");
  auto gradings = gradings_of(a, "grading");
  gradings.resize(patch.directions().size());
  Patch refined = patch;
  for (std::size_t d = 0; d < gradings.size(); ++d) {
    const nurbs::KnotVector& own = patch.directions()[d];
    const auto knots = elements.empty() ? std::vector<double>{} : nurbs::element_knots(own, elements[d], gradings[d]);
    refined = nurbs::k_refine(refined, static_cast<int>(d), degree.empty() ? own.degree() : degree[d], knots);
  }
  return returned(L, refined);
}

int face(lua_State* L) {
  const Patch& patch = self<Patch>(L);
  if (patch.parametric_dimension() == 1)
    throw ArgumentError(text(function_name(L), ": a curve has two end points, and no faces: evaluate it at its first "
                                               "and last knot, as in curve(0)"));
  return returned(L, nurbs::face(patch, nurbs::side_of(to<std::string>(L, 2), patch.parametric_dimension())));
}

/// A whole number of each direction.
template <int (nurbs::KnotVector::*number)() const> int per_direction(lua_State* L) {
  std::vector<int> values;
  for (const auto& direction : self<Patch>(L).directions()) values.push_back((direction.*number)());
  return returned(L, values);
}

int patch_text(lua_State* L) {
  const Patch& patch = self<Patch>(L);
  const char* kinds[] = {"curve", "surface", "volume"};
  std::string degrees, elements;
  for (const auto& direction : patch.directions()) {
    degrees += text(degrees.empty() ? "" : " x ", direction.degree());
    elements += text(elements.empty() ? "" : " x ", direction.elements());
  }
  return returned(L, text("NURBS ", kinds[patch.parametric_dimension() - 1], " in ", patch.dimension(), "D: degree ",
                          degrees, ", elements ", elements, ", ", patch.functions(), " control points"));
}

/// An argument that is the origin of the patch's space by default.
VectorX point_of(const Arguments& a, const char* key, const Patch& patch) {
  return a.get<VectorX>(key, VectorX::Zero(patch.dimension()));
}

int rotate(lua_State* L) {
  const Patch& patch = self<Patch>(L);
  const Arguments a(L, 2);
  if (patch.dimension() == 3 && !a.has("axis")) a.refuse("axis", "a list of 3 numbers {x, y, z}, its direction");
  return returned(
      L, nurbs::rotate(patch, a.get<double>("angle"), point_of(a, "centre", patch), a.get<VectorX>("axis", {})));
}

int scale(lua_State* L) {
  const Patch& patch = self<Patch>(L);
  const Arguments a(L, 2);
  const bool each = lua_istable(L, a.push("factor"));
  return returned(
      L, nurbs::scale(patch,
                      each ? a.get<VectorX>("factor") : VectorX::Constant(patch.dimension(), a.get<double>("factor")),
                      point_of(a, "centre", patch)));
}

int mirror(lua_State* L) {
  const Patch& patch = self<Patch>(L);
  const Arguments a(L, 2);
  return returned(L, nurbs::mirror(patch, point_of(a, "point", patch), a.get<VectorX>("normal")));
}

int swap(lua_State* L) {
  const Patch& patch = self<Patch>(L);
  if (patch.parametric_dimension() == 1)
    throw ArgumentError(
        text(function_name(L), ": a curve has one parametric direction, and nothing to exchange it with"));
  const int i = direction_at(L, 2), j = direction_at(L, 3);
  if (i == j) reject(L, 3, {"j"}, "another direction than i");
  return returned(L, nurbs::swap_directions(patch, i, j));
}

/// How many parametric directions and coordinates a patch has.
int patch_sizes(lua_State* L) {
  const Patch& patch = read_object<Patch>(L, 1, {"patch"});
  push(L, patch.parametric_dimension());
  push(L, patch.dimension());
  return 2;
}

constexpr Function patch_entries[] = {
    {"__call", evaluate_at},
    {"__tostring", patch_text},
    {"evaluate", evaluate_at},
    {"derivatives", derivatives},
    {"basis", basis},
    {"insert",
     [](lua_State* L) {
       return returned(L, nurbs::insert_knots(self<Patch>(L), direction_at(L, 2), to<std::vector<double>>(L, 3)));
     }},
    {"elevate",
     [](lua_State* L) { return returned(L, nurbs::elevate(self<Patch>(L), direction_at(L, 2), to<int>(L, 3))); }},
    {"refine", refine},
    {"face", face},
    {"degrees", per_direction<&nurbs::KnotVector::degree>},
    {"elements", per_direction<&nurbs::KnotVector::elements>},
    {"knots", [](lua_State* L) { return returned(L, self<Patch>(L).direction(direction_at(L, 2)).knots()); }},
    {"points", [](lua_State* L) { return returned(L, MatrixX(self<Patch>(L).points())); }},
    {"weights", [](lua_State* L) { return returned(L, VectorX(self<Patch>(L).weights())); }},
    {"translate", [](lua_State* L) { return returned(L, nurbs::translate(self<Patch>(L), to<VectorX>(L, 2))); }},
    {"rotate", rotate},
    {"scale", scale},
    {"mirror", mirror},
    {"reverse", [](lua_State* L) { return returned(L, nurbs::reverse(self<Patch>(L), direction_at(L, 2))); }},
    {"swap", swap},
    {"to_plane", [](lua_State* L) { return returned(L, nurbs::to_plane(self<Patch>(L))); }},
    {"to_space",
     [](lua_State* L) { return returned(L, nurbs::to_space(self<Patch>(L), Arguments(L, 2).get<double>("z"))); }},
    {"write", write_patch},
};

constexpr Function patch_core_entries[] = {{"patch_sizes", patch_sizes}};

/// Throws ArgumentError unless a patch has the dimension of the first one.
void check_same_dimension(lua_State* L, const Patch& first, const Patch& other, const std::string& path) {
  if (other.dimension() != first.dimension())
    throw ArgumentError(text(function_name(L), ": ", path, " is in ", other.dimension(), "D and patch[1] in ",
                             first.dimension(), "D; keep them in files of their own"));
}

} // namespace

std::vector<Patch> patches_of(const Arguments& a, const char* key) {
  std::vector<Patch> patches;
  a.list(key, [&](int, int index, const std::string& path) {
    patches.push_back(*test_object<Patch>(a.state(), index));
    check_same_dimension(a.state(), patches.front(), patches.back(), path);
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
  register_functions(L, "core", patch_core_entries);
  push_table(L, "core");
  set_field(L, "max_degree", nurbs::max_degree);
  lua_pop(L, 1);
}

} // namespace signorini::bind
