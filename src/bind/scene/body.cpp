#include "base/words.hpp"
#include "bind/geometry/patch.hpp"
#include "bind/lua/functions.hpp"
#include "bind/lua/open.hpp"
#include "bind/lua/wording/wording.hpp"
#include "bind/scene/layer.hpp"
#include "bind/scene/material.hpp"
#include "bind/scene/scene.hpp"
#include "model/scene/coincident_faces.hpp"
#include "nurbs/coincident.hpp"
#include "nurbs/folds.hpp"
#include "os/machine.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::bind {

namespace {

using nurbs::Side;

// ── Places ───────────────────────────────────────────────────────────────────────────────────────────────────────────

/// The parts of a name: "south", "front" for "south-front".
std::vector<std::string> parts_of(const std::string& name) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= name.size();) {
    const std::size_t end = std::min(name.find('-', begin), name.size());
    parts.push_back(name.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

/// All names of places where `count` faces meet, by ascending direction: "west-south", "west-front", "south-front".
std::vector<std::string> meeting_names(int dimensions, int count) {
  std::vector<std::string> names;
  const auto extend = [&](auto& self, const std::string& begun, int direction, int missing) -> void {
    if (missing == 0) return names.push_back(begun);
    for (int d = direction; d <= dimensions - missing; ++d)
      for (bool at_end : {false, true})
        self(self, text(begun, begun.empty() ? "" : "-", nurbs::name_of({d, at_end})), d + 1, missing - 1);
  };
  extend(extend, "", 0, count);
  return names;
}

/// Corner names are accepted in any order of directions; in the plane they are printed with south or north first.
std::vector<std::string> corner_names(int dimensions) {
  if (dimensions == 2) return {"south-west", "south-east", "north-west", "north-east"};
  return meeting_names(dimensions, dimensions);
}

/// The sides in a name; empty unless they are `count` known ones of different directions.
std::vector<Side> read_sides(const std::string& name, int dimensions, int count) {
  const std::vector<std::string> known = meeting_names(dimensions, 1), parts = parts_of(name);
  std::vector<Side> sides;
  for (const std::string& part : parts) {
    if (std::find(known.begin(), known.end(), part) == known.end()) return {};
    const Side side = nurbs::side_of(part, dimensions);
    for (const Side& other : sides)
      if (other.direction == side.direction) return {};
    sides.push_back(side);
  }
  return std::ssize(sides) == count ? sides : std::vector<Side>{};
}

/// core.place_names(body or patch, count): the names of its places where `count` faces meet, 0: of its corners; without
/// an object those of solids.
int place_names(lua_State* L) {
  const auto* patch = test_object<nurbs::Patch>(L, 1);
  const int dimensions = patch ? patch->parametric_dimension() : test_object<Body<2>>(L, 1) ? 2 : 3;
  const int count = to<int>(L, 2);
  push(L, count == 0                        ? corner_names(dimensions)
          : count > 0 && count < dimensions ? meeting_names(dimensions, count)
                                            : std::vector<std::string>());
  return 1;
}

template <int D> BoundaryPart<D> face(const Body<D>& body, const std::string& name) {
  const Side side = nurbs::side_of(name, D);
  return {body, "face", name, side, body->space().face_functions(side)};
}

/// The place where the faces in a name meet, with the functions that all of them share.
template <int D> int push_meeting(lua_State* L, const char* kind, int count, const std::vector<std::string>& names) {
  const Body<D>& body = self<Body<D>>(L);
  const auto name = to<std::string>(L, 2);
  const std::vector<Side> sides = read_sides(name, D, count);
  if (sides.empty()) {
    const std::string near = nearest(name, names);
    reject(L, 2, {"name"}, one_of(names), near.empty() ? "" : "did you mean '" + near + "'?");
  }
  std::vector<int> common = body->space().face_functions(sides.front());
  for (const Side& side : sides) {
    const std::vector<int> others = body->space().face_functions(side);
    std::erase_if(common, [&](int f) { return std::find(others.begin(), others.end(), f) == others.end(); });
  }
  push_object(L, BoundaryPart<D>{body, kind, name, {}, std::move(common)});
  return 1;
}

template <int D> int edge(lua_State* L) {
  require(D == 3, "a plane body has faces and corners, but no edges: use b:face \"south\" or b:corner \"south-west\"");
  return push_meeting<D>(L, "edge", 2, meeting_names(D, 2));
}

template <int D> int corner(lua_State* L) {
  return push_meeting<D>(L, "corner", D, corner_names(D));
}

template <int D> std::string place_text(const BoundaryPart<D>& place) {
  return text(place.kind, " '", place.name, "' of a body, ", counted(place.functions.size(), "control point"));
}

// ── Bodies ───────────────────────────────────────────────────────────────────────────────────────────────────────────

/// The contact faces, if the body has any.
std::vector<Side> contact_of(const Arguments& a, int dimensions) {
  std::vector<Side> sides;
  const std::vector<std::string> known = meeting_names(dimensions, 1);
  for (const std::string& name : a.get<std::vector<std::string>>("contact", {})) {
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      const std::string meant = nurbs::meant_side(name, dimensions);
      a.fail("contact must be ", one_of(known), " (the face that carries the layer), got the string '", name, "'",
             meant.empty() ? "" : text(": did you mean '", meant, "'?"));
    }
    sides.push_back(nurbs::side_of(name, dimensions));
  }
  return sides;
}

/// One order label for each direction along the contact face, or one for all.
std::vector<nurbs::Label> labels_of(const Arguments& a, std::size_t directions) {
  std::vector<nurbs::Label> labels;
  for (const std::string& name : a.get<std::vector<std::string>>("order")) labels.push_back(nurbs::parse_label(name));
  if (labels.size() == 1) labels.resize(directions, labels.front());
  return labels;
}

/// 2 or 3. Throws ArgumentError when the patch cannot be the shape of a body.
int dimension_of(const Arguments& a, const nurbs::Patch& patch) {
  const int dimensions = patch.parametric_dimension();
  if (dimensions == patch.dimension()) return dimensions;
  const char* kinds[] = {"curve", "surface", "volume"};
  a.refuse("patch", "a surface in the plane, or a volume in 3D",
           text("this one is a ", kinds[dimensions - 1], patch.dimension() == 2 ? " in the plane" : " in 3D",
                dimensions == 2 ? ": make a volume with sg.nurbs.extrude, or convert a flat surface to the plane with "
                                  "patch:to_plane()"
                                : ""));
}

/// Checks the size of a body before it is created: refuses bodies that do not fit, warns of large ones.
void check_size(const nurbs::Plan& plan, int dimensions) {
  constexpr double most_unknowns = 20e6;
  double elements = 1, points = 1; // totals; `points`: unknowns per displacement component
  for (int d = 0, along = 0; d < dimensions; ++d) {
    elements *= plan.elements[d], points *= plan.elements[d] + 1.0;
    const bool cut = !plan.layer_knots.empty() && d != plan.contact.front().direction;
    if (cut) elements *= 1 + static_cast<double>(plan.layer_knots[along++].size()) / plan.elements[d];
  }
  const int thickness_degree = plan.thickness_degree.value_or(nurbs::bulk_space(plan.labels).full_degree());
  double functions = plan.contact.empty() ? 1 : thickness_degree + 1; // of an element, then times its Gauss points
  for (const nurbs::Label& label : plan.labels) functions *= label.bulk.full_degree() + 1;
  const double unknowns = dimensions * points, table = 8 * elements * functions * functions * dimensions; // bytes
  const std::string list = listed(plan.elements);
  const auto refuse = [&](const auto&... why) {
    fail("elements = {", list, "} make ", why..., ": use fewer elements");
  };
  const auto count = [](double value) { return text(static_cast<long long>(value)); };
  if (unknowns > most_unknowns)
    refuse("at least ", count(unknowns), " unknowns, more than the maximum of ", count(most_unknowns));
  if (table > main_memory())
    refuse("at least ", count(unknowns), " unknowns, and tables at Gauss points of ", count(std::ceil(table / 1e9)),
           " GB, more than the ", count(main_memory() / 1e9), " GB of this machine");
  constexpr double many_unknowns = 1e6;
  if (unknowns > many_unknowns)
    warn(text("sg.body: elements = {", list, "} make at least ", count(unknowns), " unknowns and tables of ",
              number(std::round(table / 1e8) / 10), " GB: making the body takes a while, solving takes much longer"));
}

template <int D> int push_body(lua_State* L, const nurbs::Patch& patch, const nurbs::Plan& plan, const Arguments& a) {
  const auto volumetric =
      choice<solid::Volumetric>(a.get("volumetric", std::string("pointwise")), {"pointwise", "projected"});
  const auto& made = push_object<Body<D>>(
      L, std::make_shared<const solid::Body<D>>(std::make_shared<const nurbs::Discretization>(patch, plan),
                                                a.object<solid::Material>("material"), solid::Kind::plane_strain,
                                                volumetric, a.get("density", 1.0)));
  nurbs::check_folds(patch);
  count_memory(L, static_cast<double>(made->memory()));
  return 1;
}

int body(const Arguments& a, lua_State* L) {
  const auto& patch = a.object<nurbs::Patch>("patch");
  const int dimensions = dimension_of(a, patch);
  nurbs::Plan plan;
  plan.elements = a.get<std::vector<int>>("elements");
  plan.grading = gradings_of(a, "grading");
  plan.contact = contact_of(a, dimensions);
  plan.labels = labels_of(a, static_cast<std::size_t>(plan.contact.empty() ? dimensions : dimensions - 1));
  if (a.has("thickness_degree")) plan.thickness_degree = a.get<int>("thickness_degree");
  check_size(plan, dimensions);
  read_layer(a, patch, plan);
  if (!plan.layer_knots.empty()) check_size(plan, dimensions);
  return dimensions == 2 ? push_body<2>(L, patch, plan, a) : push_body<3>(L, patch, plan, a);
}

template <int D> int dofs(const solid::Body<D>& body, lua_State* L) {
  const nurbs::Discretization& space = body.space();
  std::vector<int> interface;
  for (Side side : space.contact()) {
    const auto face = space.face_functions(side);
    interface.insert(interface.end(), face.begin(), face.end());
  }
  const int on_faces = D * static_cast<int>(interface.size()), total = D * space.functions();
  push_fields(L, "interface", on_faces, "bulk", total - on_faces, "total", total);
  return 1;
}

/// "2", or "2..4" if elements differ.
std::string degrees_of(const nurbs::Space1D& space) {
  int lowest = space.degree();
  for (int e = 0; e < space.elements(); ++e) lowest = std::min(lowest, space.degree(e));
  return lowest == space.degree() ? text(lowest) : text(lowest, "..", space.degree());
}

/// "2 x 1": the degrees of a row, with that of the thickness direction in its place.
std::string degrees_in_words(const nurbs::Discretization& space, const nurbs::Row& row) {
  std::string words;
  for (int d = 0; d < space.parametric_dimension(); ++d)
    words +=
        text(d == 0 ? "" : " x ", degrees_of(d == space.through() ? space.stack() : row.direction(space.in_row(d))));
  return words;
}

/// The degrees of all rows of control points, in order.
std::string all_degrees_in_words(const nurbs::Discretization& space) {
  std::string words, last;
  for (const nurbs::Row& row : space.rows())
    if (const std::string own = degrees_in_words(space, row); own != last) {
      words += (words.empty() ? "" : ", then ") + own;
      last = own;
    }
  return words;
}

template <int D> std::string body_text(const solid::Body<D>& body) {
  const nurbs::Discretization& space = body.space();
  std::string elements, closed;
  for (int d : nurbs::closed_directions(space)) closed += text(closed.empty() ? "closed along xi" : " and xi", d + 1);
  for (int d = 0; d < D; ++d) elements += text(d == 0 ? "" : " x ", space.elements(d));
  return text(D == 2 ? "plane" : "solid", " body: ", elements, " elements, degree ", all_degrees_in_words(space), ", ",
              D * space.functions(), " degrees of freedom, ", closed, closed.empty() ? "" : ", ",
              body.volumetric() == solid::Volumetric::projected ? "projected volume change, " : "",
              body.linear() ? "linear elastic, " : "", constants_in_words(body.material()));
}

// ── Bodies of several patches ────────────────────────────────────────────────────────────────────────────────────────

/// { 1, "east", 2, "west" }
void push_faces(lua_State* L, const model::FacePair& pair) {
  lua_createtable(L, 4, 0);
  lua_Integer i = 0;
  for (const model::FaceReference& face : pair) {
    push(L, face.body + 1);
    lua_rawseti(L, -2, ++i);
    push(L, nurbs::name_of(face.side));
    lua_rawseti(L, -2, ++i);
  }
}

/// True if the first argument is a list of plane bodies.
bool are_plane(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  lua_rawgeti(L, 1, 1);
  const bool plane = test_object<Body<2>>(L, -1) != nullptr;
  lua_pop(L, 1);
  return plane;
}

/// The pairs of coincident faces of a list of bodies: { { 1, "east", 2, "west" }, … }.
int coincident_faces(lua_State* L) {
  const auto found = are_plane(L) ? model::coincident_faces<2>(read_objects<Body<2>>(L, 1))
                                  : model::coincident_faces<3>(read_objects<Body<3>>(L, 1));
  push_list(L, found, [&](const model::FacePair& pair) { push_faces(L, pair); });
  return 1;
}

/// The closest faces of two lists of bodies, { 1, "east", 2, "west" }, and their distance.
template <int D> int push_smallest_gap(lua_State* L) {
  const model::FaceGap<D> gap = model::smallest_gap<D>(read_objects<Body<D>>(L, 1), read_objects<Body<D>>(L, 2));
  push_faces(L, gap.faces);
  push(L, gap.distance);
  return 2;
}

int smallest_gap(lua_State* L) {
  return are_plane(L) ? push_smallest_gap<2>(L) : push_smallest_gap<3>(L);
}

/// Number of the body in a list to which a face, edge or corner belongs, what it is, and its name: 2, "face", "south";
/// nothing if it belongs to none.
template <int D> int push_owner(lua_State* L, const BoundaryPart<D>& place) {
  const std::vector<Body<D>> bodies = read_objects<Body<D>>(L, 2);
  const auto own = std::find(bodies.begin(), bodies.end(), place.body);
  if (own == bodies.end()) return 0;
  push(L, static_cast<int>(own - bodies.begin()) + 1);
  push(L, place.kind);
  push(L, place.name);
  return 3;
}

int owner(lua_State* L) {
  if (const auto* plane = test_object<BoundaryPart<2>>(L, 1)) return push_owner(L, *plane);
  if (const auto* space = test_object<BoundaryPart<3>>(L, 1)) return push_owner(L, *space);
  return 0;
}

constexpr Function body_core_entries[] = {{"place_names", place_names},
                                          {"coincident_faces", coincident_faces},
                                          {"smallest_gap", smallest_gap},
                                          {"owner", owner}};

template <int D> constexpr Function place_entries[] = {{"__tostring", call<place_text<D>>}};
template <int D>
constexpr Function body_entries[] = {
    {"__tostring", call<body_text<D>>},
    {"dofs", call<dofs<D>>},
    {"face", call<face<D>>},
    {"edge", edge<D>},
    {"corner", corner<D>},
    {"points", call<[](const solid::Body<D>& body) { return body.space().points(); }>},
};

} // namespace

void open_body(lua_State* L) {
  register_functions(L, "sg", {{"body", call<body>}});
  register_functions(L, "core", body_core_entries);
  register_type<Body<2>, Body<3>>(L, body_entries<2>, body_entries<3>);
  register_type<BoundaryPart<2>, BoundaryPart<3>>(L, place_entries<2>, place_entries<3>);
}

} // namespace signorini::bind
