#include "base/machine.hpp"
#include "base/words.hpp"
#include "bind/functions.hpp"
#include "bind/material.hpp"
#include "bind/open.hpp"
#include "bind/patch.hpp"
#include "bind/place.hpp"
#include "bind/wording/wording.hpp"
#include "nurbs/coincident.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::bind {

namespace {

using nurbs::Side;

/// The contact faces, where a body has any.
std::vector<Side> contact_of(const Arguments& a, int dimensions) {
  std::vector<Side> sides;
  const std::vector<std::string> known = face_names(dimensions);
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

/// A label for each direction along the contact face, or for all.
std::vector<nurbs::Label> labels_of(const Arguments& a, std::size_t directions) {
  std::vector<nurbs::Label> labels;
  for (const std::string& name : a.get<std::vector<std::string>>("order")) labels.push_back(nurbs::parse_label(name));
  if (labels.size() == 1) labels.resize(directions, labels.front());
  return labels;
}

/// 2 or 3. Throws ArgumentError when the patch cannot be a body's shape.
int dimension_of(const Arguments& a, const nurbs::Patch& patch) {
  const int dimensions = patch.parametric_dimension();
  if (dimensions == patch.dimension()) return dimensions;
  const char* kinds[] = {"curve", "surface", "volume"};
  a.refuse("patch", "a surface in the plane, or a volume in 3D",
           text("this one is a ", kinds[dimensions - 1], patch.dimension() == 2 ? " in the plane" : " in 3D",
                dimensions == 2
                    ? ": make a volume of it with sg.nurbs.extrude, or bring a flat one into the plane with "
                      "patch:to_plane()"
                    : ""));
}

/// Refuses a body that cannot fit, and says what a large one takes: before anything of it is made.
void check_size(lua_State* L, const nurbs::Plan& plan, int dimensions) {
  constexpr double most_unknowns = 20e6;
  double elements = 1, points = 1; // all, and unknowns of one component
  for (int count : plan.elements) elements *= count, points *= count + 1.0;
  const int through = plan.through.value_or(nurbs::bulk_space(plan.labels).full_degree());
  double functions = plan.contact.empty() ? 1 : through + 1; // of an element, and its Gauss points
  for (const nurbs::Label& label : plan.labels) functions *= label.bulk.full_degree() + 1;
  const double unknowns = dimensions * points, table = 8 * elements * functions * functions * dimensions; // bytes
  std::string list;
  for (int count : plan.elements) list += text(list.empty() ? "" : ", ", count);
  const auto refuse = [&](const auto&... why) {
    throw ArgumentError(text(function_name(L), ": elements = {", list, "} make ", why..., ": take fewer elements"));
  };
  const auto count = [](double value) { return text(static_cast<long long>(value)); };
  if (unknowns > most_unknowns)
    refuse("at least ", count(unknowns), " unknowns, and ", count(most_unknowns), " is the most");
  if (table > main_memory())
    refuse("at least ", count(unknowns), " unknowns, and tables at Gauss points of ", count(std::ceil(table / 1e9)),
           " GB, more than the ", count(main_memory() / 1e9), " GB of this machine");
  constexpr double many_unknowns = 1e6;
  if (unknowns > many_unknowns)
    warn(text("sg.body: elements = {", list, "} make at least ", count(unknowns), " unknowns and tables of ",
              number(std::round(table / 1e8) / 10), " GB: making them takes a while, and solving much longer"));
}

template <int D> void push_body(lua_State* L, const nurbs::Patch& patch, const nurbs::Plan& plan, const Arguments& a) {
  const auto& made =
      push_object<Body<D>>(L, std::make_shared<const solid::Body<D>>(nurbs::Discretisation(patch, plan),
                                                                     a.object<solid::Material>("material")));
  count_memory(L, static_cast<double>(made->memory()));
}

int body(lua_State* L) {
  const Arguments a(L);
  const auto& patch = a.object<nurbs::Patch>("patch");
  const int dimensions = dimension_of(a, patch);
  nurbs::Plan plan;
  plan.elements = a.get<std::vector<int>>("elements");
  plan.grading = gradings_of(a, "grading");
  plan.contact = contact_of(a, dimensions);
  plan.labels = labels_of(a, static_cast<std::size_t>(plan.contact.empty() ? dimensions : dimensions - 1));
  if (a.has("through")) plan.through = a.get<int>("through");
  check_size(L, plan, dimensions);
  if (dimensions == 2)
    push_body<2>(L, patch, plan, a);
  else
    push_body<3>(L, patch, plan, a);
  return 1;
}

template <int D> int dofs(lua_State* L) {
  const nurbs::Discretisation& space = self<Body<D>>(L)->space();
  std::vector<int> interface;
  for (Side side : space.contact()) {
    const auto face = space.face_functions(side);
    interface.insert(interface.end(), face.begin(), face.end());
  }
  const int on_faces = D * static_cast<int>(interface.size()), total = D * space.functions();
  lua_createtable(L, 0, 3);
  set_field(L, "interface", on_faces);
  set_field(L, "bulk", total - on_faces);
  set_field(L, "total", total);
  return 1;
}

template <int D> int points(lua_State* L) {
  push(L, self<Body<D>>(L)->space().points());
  return 1;
}

/// "2 x 1" of a row's degrees, that of the direction through the body in its place.
std::string degrees_in_words(const nurbs::Discretisation& space, const nurbs::Row& row) {
  std::string words;
  for (int d = 0; d < space.parametric_dimension(); ++d)
    words +=
        text(d == 0 ? "" : " x ", (d == space.through() ? space.stack() : row.direction(space.in_row(d))).degree());
  return words;
}

/// The degrees of all rows of control points, in the order of the rows.
std::string all_degrees_in_words(const nurbs::Discretisation& space) {
  std::string words, last;
  for (const nurbs::Row& row : space.rows())
    if (const std::string own = degrees_in_words(space, row); own != last) {
      words += (words.empty() ? "" : ", then ") + own;
      last = own;
    }
  return words;
}

template <int D> int body_text(lua_State* L) {
  const solid::Body<D>& body = *self<Body<D>>(L);
  const nurbs::Discretisation& space = body.space();
  std::string elements, closed;
  for (int d : nurbs::closed_directions(space)) closed += text(closed.empty() ? "closed along xi" : " and xi", d + 1);
  for (int d = 0; d < D; ++d) elements += text(d == 0 ? "" : " x ", space.elements(d));
  push(L, text(D == 2 ? "plane" : "solid", " body: ", elements, " elements, degree ", all_degrees_in_words(space), ", ",
               D * space.functions(), " degrees of freedom, ", closed, closed.empty() ? "" : ", ",
               body.linear() ? "linear elastic, " : "", constants_in_words(body.material())));
  return 1;
}

constexpr Function body_functions[] = {{"body", body}};

template <int D>
constexpr Function body_entries[] = {
    {"__tostring", body_text<D>}, {"dofs", dofs<D>},     {"face", face<D>}, {"edge", edge<D>},
    {"corner", corner<D>},        {"points", points<D>},
};

} // namespace

void open_body(lua_State* L) {
  register_functions(L, "sg", body_functions);
  register_type<Body<2>, Body<3>>(L, body_entries<2>, body_entries<3>);
  open_places(L);
}

} // namespace signorini::bind
