#include "bind/patch.hpp"

#include "bind/functions.hpp"
#include "bind/open.hpp"
#include "nurbs/shapes.hpp"

namespace signorini::bind {

using nurbs::Patch;

VectorX read_parameters(lua_State* L, int index, const Patch& patch) {
  const int directions = patch.parametric_dimension();
  const Argument argument{"xi", "parametric coordinates"};
  if (directions == 1 && lua_type(L, index) == LUA_TNUMBER)
    return VectorX::Constant(1, read_number(L, index, argument));
  const char* expected = directions == 1   ? "a number"
                         : directions == 2 ? "a list of 2 numbers {xi1, xi2}"
                                           : "a list of 3 numbers {xi1, xi2, xi3}";
  if (!lua_istable(L, index))
    reject(L, index, argument, expected,
           directions > 1                      ? "put the coordinates into braces"
           : lua_type(L, index) == LUA_TSTRING ? "remove the quotes"
                                               : "");
  const std::vector<double> xi = read_numbers(L, index, argument);
  if (static_cast<int>(xi.size()) != directions) reject(L, index, argument, expected);
  return Eigen::Map<const VectorX>(xi.data(), directions);
}

std::vector<int> read_per_direction(lua_State* L, int index, const Argument& argument, int directions, int low,
                                    int high) {
  if (directions == 1 && lua_type(L, index) == LUA_TNUMBER) return {read_integer(L, index, argument, low, high)};
  const std::string expected = text("a list of ", directions, " whole numbers, one per direction");
  if (!lua_istable(L, index)) reject(L, index, argument, expected, "put them into braces");
  std::vector<int> values = read_integers(L, index, argument, low, high);
  if (static_cast<int>(values.size()) != directions) reject(L, index, argument, expected);
  return values;
}

int read_direction(lua_State* L, int index, const Patch& patch, const char* name) {
  return read_index(L, index, {name, "parametric direction, counted from 1"}, patch.parametric_dimension());
}

namespace {

nurbs::Grading read_grading(lua_State* L, int index, const Argument& argument) {
  const Options o(L, index, {"elements", "length", "at"}, false, argument.name);
  const auto share = [&](const char* key, const char* meaning) {
    const double value = o.positive(key, meaning);
    if (value >= 1)
      throw ArgumentError(
          text(function_name(L), ": ", o.argument(key).name, " (", meaning, ") must be a share below 1, got ", value));
    return value;
  };
  return {share("elements", "share of the elements"), share("length", "share of the knot length they fill"),
          o.choice("at", "the end where they crowd", {"start", "end"}) == "end"};
}

int call(lua_State* L) {
  const Patch& patch = self<Patch>(L);
  push(L, nurbs::evaluate(patch, read_parameters(L, 2, patch)));
  return 1;
}

int derivatives(lua_State* L) {
  const Patch& patch = self<Patch>(L);
  const auto all = nurbs::derivatives(patch, read_parameters(L, 2, patch),
                                      read_integer(L, 3, {"n", "highest total order"}, 0, nurbs::max_degree));
  lua_createtable(L, static_cast<int>(all.size()), 0);
  for (std::size_t i = 0; i < all.size(); ++i) {
    lua_createtable(L, 0, 2);
    set_field(L, "orders", all[i].orders);
    set_field(L, "value", all[i].value);
    lua_rawseti(L, -2, static_cast<lua_Integer>(i) + 1);
  }
  return 1;
}

int basis(lua_State* L) {
  const Patch& patch = self<Patch>(L);
  const auto values = nurbs::rational_basis(patch, read_parameters(L, 2, patch));
  lua_createtable(L, static_cast<int>(values.size()), 0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    lua_createtable(L, 0, 2);
    set_field(L, "index", values[i].function + 1);
    set_field(L, "value", values[i].value);
    lua_rawseti(L, -2, static_cast<lua_Integer>(i) + 1);
  }
  return 1;
}

int insert(lua_State* L) {
  const Patch& patch = self<Patch>(L);
  const int d = read_direction(L, 2, patch);
  push_object(L, nurbs::insert_knots(patch, d, read_numbers(L, 3, {"knots", "knots to insert"})));
  return 1;
}

int elevate(lua_State* L) {
  const Patch& patch = self<Patch>(L);
  const int d = read_direction(L, 2, patch);
  const int times = lua_isnoneornil(L, 3) ? 1 : read_integer(L, 3, {"times", "how often"}, 1, nurbs::max_degree);
  push_object(L, nurbs::elevate(patch, d, times));
  return 1;
}

int refine(lua_State* L) {
  const Patch& patch = self<Patch>(L);
  const Options o(L, 2, {"elements", "degree", "grading"});
  const int directions = patch.parametric_dimension();
  const auto given = [&](const char* key, int high) {
    return o.has(key) ? read_per_direction(L, o.push_value(key), o.argument(key), directions, 1, high)
                      : std::vector<int>{};
  };
  const auto elements = given("elements", 1'000'000), degree = given("degree", nurbs::max_degree);
  std::vector<std::optional<nurbs::Grading>> gradings(static_cast<std::size_t>(directions));
  if (o.has("grading")) {
    if (elements.empty())
      throw ArgumentError(text(function_name(L), ": grading needs elements: say how many there are to share out"));
    gradings = read_gradings(L, o.push_value("grading"), o.argument("grading"), directions);
  }
  Patch refined = patch;
  for (int d = 0; d < directions; ++d) {
    const auto i = static_cast<std::size_t>(d);
    const nurbs::KnotVector& own = patch.direction(d);
    const auto knots = elements.empty() ? std::vector<double>{} : nurbs::element_knots(own, elements[i], gradings[i]);
    refined = nurbs::k_refine(refined, d, degree.empty() ? own.degree() : degree[i], knots);
  }
  push_object(L, std::move(refined));
  return 1;
}

int face(lua_State* L) {
  const Patch& patch = self<Patch>(L);
  const std::string name = read_string(L, 2, {"name", "a face, such as \"south\""});
  if (patch.parametric_dimension() == 1)
    throw ArgumentError(text(function_name(L), ": a curve has two end points, and no faces: evaluate it at its first "
                                               "and last knot, as in curve(0)"));
  push_object(L, nurbs::face(patch, nurbs::side_of(name, patch.parametric_dimension())));
  return 1;
}

int degrees(lua_State* L) {
  std::vector<int> values;
  for (const auto& direction : self<Patch>(L).directions()) values.push_back(direction.degree());
  push(L, values);
  return 1;
}

int elements(lua_State* L) {
  std::vector<int> values;
  for (const auto& direction : self<Patch>(L).directions()) values.push_back(direction.elements());
  push(L, values);
  return 1;
}

int knots(lua_State* L) {
  const Patch& patch = self<Patch>(L);
  push(L, patch.direction(read_direction(L, 2, patch)).knots());
  return 1;
}

int patch_points(lua_State* L) {
  push(L, self<Patch>(L).points());
  return 1;
}

int weights(lua_State* L) {
  push(L, self<Patch>(L).weights());
  return 1;
}

int patch_text(lua_State* L) {
  const Patch& patch = self<Patch>(L);
  const char* kinds[] = {"curve", "surface", "volume"};
  std::string degrees, elements;
  for (const auto& direction : patch.directions()) {
    degrees += text(degrees.empty() ? "" : " x ", direction.degree());
    elements += text(elements.empty() ? "" : " x ", direction.elements());
  }
  push(L, text("NURBS ", kinds[patch.parametric_dimension() - 1], " in ", patch.dimension(), "D: degree ", degrees,
               ", elements ", elements, ", ", patch.functions(), " control points"));
  return 1;
}

constexpr const char* call_doc = "p(xi) or p:evaluate(xi)\n"
                                 "The point at xi: a number on a curve, {xi1, xi2} on a surface, {xi1, xi2, xi3} in a "
                                 "volume. Returns {x, y} or {x, y, z}.\n"
                                 "Example: sg.shapes.rectangle{ width = 3, height = 1 }{0.5, 0.5}  --> {1.5, 0.5}";

constexpr Function patch_entries[] = {
    {"__call", call, call_doc},
    {"__tostring", patch_text,
     "patch\n"
     "A NURBS curve, surface or volume: an immutable value. Methods that change something return a new patch.\n"
     "Make one with sg.nurbs.* or sg.shapes.*; methods: p(xi), evaluate, derivatives, basis, insert, elevate, refine,\n"
     "face, degrees, elements, knots, points, weights, translate, rotate, scale, mirror, reverse, swap, to_plane,\n"
     "to_space, write. help \"patch:refine\" tells more."},
    {"evaluate", call, call_doc},
    {"derivatives", derivatives,
     "p:derivatives(xi, n)\n"
     "All partial derivatives of the map at xi up to total order n, as a list of { orders = {1, 0}, value = {x, y} },\n"
     "by total order, then falling in xi1. Source: Piegl & Tiller, The NURBS Book, eq. (4.20).\n"
     "Example: patch:derivatives({0.5, 0.5}, 1)[2].value  --> {3.0, 0.0}"},
    {"basis", basis,
     "p:basis(xi)\n"
     "The rational functions that do not vanish at xi, as a list of { index = , value = }; index counts the control\n"
     "points from 1, fastest in xi1. The values add up to 1.\n"
     "Example: patch:basis({0.5, 0.5})[1].value  --> 0.25"},
    {"insert", insert,
     "p:insert(dir, {knots})\n"
     "A new patch of the same shape with knots inserted in direction dir (1, 2, 3); a repeated knot counts as often.\n"
     "Example: patch:insert(1, {0.25, 0.5}):elements()  --> {3, 1}"},
    {"elevate", elevate,
     "p:elevate(dir, times = 1)\n"
     "A new patch of the same shape whose degree in direction dir is higher by `times`; continuity is kept.\n"
     "Example: patch:elevate(1, 2):degrees()  --> {3, 1}"},
    {"refine", refine,
     "p:refine{ elements = {…}, degree = {…}, grading = {…} }\n"
     "k-refinement, the same shape: elevates to `degree` first, then inserts knots until each direction has "
     "`elements`\n"
     "spans (the patch's own knots stay). One value per direction; a curve takes plain numbers. "
     "grading,\n"
     "one entry per direction: grading = { { elements = 0.8, length = 0.1, at = \"start\" or \"end\" }, false } puts "
     "80 % "
     "of\n"
     "the elements of the first one into a tenth of the length at that end and leaves the second one uniform.\n"
     "Example: patch:refine{ elements = {8, 3}, degree = {2, 2} }"},
    {"face", face,
     "p:face(name)\n"
     "The side as a patch of one direction less: west/east (xi1), south/north (xi2), front/back (xi3).\n"
     "Example: patch:face \"south\""},
    {"degrees", degrees,
     "p:degrees()\nThe list of degrees, one per direction.\n"
     "Example: patch:degrees()  --> {1, 1}"},
    {"elements", elements,
     "p:elements()\nThe list of the numbers of non-empty knot spans, one per direction.\n"
     "Example: patch:elements()  --> {1, 1}"},
    {"knots", knots,
     "p:knots(dir)\nThe knot vector of direction dir (1, 2, 3).\n"
     "Example: patch:knots(1)  --> {0.0, 0.0, 1.0, 1.0}"},
    {"points", patch_points,
     "p:points()\nThe control points {{x, y}, …}, fastest in xi1.\n"
     "Example: patch:points()[4]  --> {3.0, 1.0}"},
    {"weights", weights,
     "p:weights()\nThe weights of the control points, in the order of p:points().\n"
     "Example: patch:weights()[1]  --> 1.0"},
    {"write", write_patch,
     "p:write(file, form)\n"
     "Writes the patch to a file of its own for other programs, as sg.nurbs.write does.\n"
     "Example: patch:write \"slab.xml\""},
};

} // namespace

std::vector<Patch> read_patches(lua_State* L, const Options& o) {
  const Argument argument = o.argument("patch", "in the place of a model");
  const int value = o.push_value("patch");
  if (lua_type(L, value) != LUA_TTABLE) return {read_object<Patch>(L, value, argument)};
  const int count = read_list(L, value, argument, "a patch or a list of patches");
  if (count == 0) reject(L, value, argument, "a list of at least one patch");
  std::vector<Patch> patches;
  for (int i = 1; i <= count; ++i) {
    lua_rawgeti(L, value, i);
    patches.push_back(read_object<Patch>(L, -1, {text("patch[", i, "]"), argument.meaning}));
    if (patches.back().dimension() != patches.front().dimension())
      throw ArgumentError(text(function_name(L), ": patch[", i, "] is in ", patches.back().dimension(),
                               "D and patch[1] in ", patches.front().dimension(),
                               "D; keep them in files of their own"));
    lua_pop(L, 1);
  }
  return patches;
}

std::vector<std::optional<nurbs::Grading>> read_gradings(lua_State* L, int index, const Argument& argument,
                                                         int directions) {
  const auto expected = text("a list of ", directions, " entries, { elements, length, at } or false per direction");
  if (!lua_istable(L, index)) reject(L, index, argument, expected);
  index = lua_absindex(L, index);
  if (directions == 1 && lua_rawlen(L, index) == 0) return {read_grading(L, index, argument)};
  if (read_list(L, index, argument, expected.c_str()) != directions) reject(L, index, argument, expected);
  std::vector<std::optional<nurbs::Grading>> gradings;
  for (int i = 1; i <= directions; ++i) {
    lua_rawgeti(L, index, i);
    const Argument entry{text(argument.name, "[", i, "]")};
    if (lua_isboolean(L, -1) && !lua_toboolean(L, -1))
      gradings.emplace_back();
    else
      gradings.emplace_back(read_grading(L, -1, entry));
    lua_pop(L, 1);
  }
  return gradings;
}

void open_patch(lua_State* L) {
  std::vector<Function> all(std::begin(patch_entries), std::end(patch_entries));
  const auto maps = patch_map_rows();
  all.insert(all.end(), maps.begin(), maps.end());
  register_type<Patch>(L, all);
}

} // namespace signorini::bind
