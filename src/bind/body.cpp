#include "base/machine.hpp"
#include "base/warning.hpp"
#include "base/words.hpp"
#include "bind/functions.hpp"
#include "bind/material.hpp"
#include "bind/open.hpp"
#include "bind/patch.hpp"
#include "bind/place.hpp"
#include "nurbs/coincident.hpp"

#include <cmath>

namespace signorini::bind {

namespace {

using nurbs::Side;

/// The contact faces: a name or a list of names.
std::vector<Side> read_contact(lua_State* L, const Options& o, int dimensions) {
  std::vector<Side> sides;
  if (!o.has("contact")) return sides;
  const Argument argument = o.argument("contact", "the face that carries the layer, or a list of two opposite ones");
  const int index = o.push_value("contact");
  const std::vector<std::string> names = face_names(dimensions);
  const auto add = [&](int at) {
    const std::string name = lua_type(L, at) == LUA_TSTRING ? lua_tostring(L, at) : "";
    const std::string meant = nurbs::meant_side(name, dimensions);
    if (!meant.empty() && meant != name) reject(L, at, argument, one_of(names), text("did you mean '", meant, "'?"));
    sides.push_back(nurbs::side_of(read_choice(L, at, argument, names), dimensions));
  };
  if (!lua_istable(L, index)) {
    add(index);
    return sides;
  }
  for (int i = 1, count = read_list(L, index, argument); i <= count; ++i) {
    lua_rawgeti(L, index, i);
    add(-1);
    lua_pop(L, 1);
  }
  return sides;
}

/// One label for all directions that it speaks of, or a list of one for each: along the contact face, or all.
std::vector<nurbs::Label> read_labels(lua_State* L, const Options& o, int dimensions, bool contact) {
  const char* meaning = "a label such as \"N2\", \"N4\", \"N2-N4\", \"N2-N2.2\" or \"L1\"";
  const int index = o.push_value("order"), wanted = contact ? dimensions - 1 : dimensions;
  if (!lua_istable(L, index))
    return std::vector<nurbs::Label>(static_cast<std::size_t>(wanted), nurbs::parse_label(o.string("order", meaning)));
  const Argument argument = o.argument("order", contact ? "one per direction along the contact face"
                                                        : "one per parametric direction, for there is no contact face");
  const std::string expected = text("a label, or a list of ", wanted, wanted == 1 ? " label" : " labels");
  std::vector<nurbs::Label> labels;
  const int count = read_list(L, index, argument, expected.c_str());
  if (count != wanted) reject(L, index, argument, expected);
  for (int i = 1; i <= count; ++i) {
    lua_rawgeti(L, index, i);
    labels.push_back(nurbs::parse_label(read_string(L, -1, {text("order[", i, "]"), meaning})));
    lua_pop(L, 1);
  }
  return labels;
}

/// 2 or 3. Throws ArgumentError when the patch is no body's shape.
int read_dimension(lua_State* L, const Options& o, const nurbs::Patch& patch) {
  const int dimensions = patch.parametric_dimension();
  if (dimensions == patch.dimension()) return dimensions;
  const char* kinds[] = {"curve", "surface", "volume"};
  reject(
      L, o.push_value("patch"), o.argument("patch", "the reference geometry"),
      "a surface in the plane, or a volume in 3D",
      text("this one is a ", kinds[dimensions - 1], patch.dimension() == 2 ? " in the plane" : " in 3D",
           dimensions == 2
               ? ": make a volume of it with sg.nurbs.extrude, or bring a flat one with patch:to_plane() to the plane"
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

template <int D> void push_body(lua_State* L, const nurbs::Patch& patch, const nurbs::Plan& plan, const Options& o) {
  const auto& material =
      o.object<solid::Material>("material", "such as sg.neo_hookean{ E = 1, nu = 0.3 } or sg.linear_elastic{ … }");
  const auto& made =
      push_object<Body<D>>(L, std::make_shared<const solid::Body<D>>(nurbs::Discretisation(patch, plan), material));
  count_memory(L, static_cast<double>(made->memory()));
}

int body(lua_State* L) {
  const Options o(L, 1, {"patch", "elements", "order", "contact", "material", "through", "grading"});
  const auto& patch = o.object<nurbs::Patch>("patch", "the reference geometry");
  const int dimensions = read_dimension(L, o, patch);
  nurbs::Plan plan;
  plan.elements = read_per_direction(L, o.push_value("elements"), o.argument("elements", "knot spans per direction"),
                                     dimensions, 1, 1'000'000);
  if (o.has("grading")) plan.grading = read_gradings(L, o.push_value("grading"), o.argument("grading"), dimensions);
  plan.contact = read_contact(L, o, dimensions);
  plan.labels = read_labels(L, o, dimensions, !plan.contact.empty());
  if (o.has("through"))
    plan.through = o.integer("through", "degree in the thickness direction, from the contact face to the opposite one",
                             1, nurbs::max_degree);
  check_size(L, plan, dimensions);
  if (dimensions == 2)
    push_body<2>(L, patch, plan, o);
  else
    push_body<3>(L, patch, plan, o);
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

constexpr Function body_functions[] = {
    {"body", body,
     "sg.body{ patch, elements, order, contact, material, through, grading }\n"
     "A solid body. patch: its shape, a surface in the plane or a volume in 3D. elements: knot spans per parametric\n"
     "direction. order: a discretisation label, see help \"labels\", or a list of one per direction. contact: the\n"
     "face that carries the layer (\"south\"), or two opposite ones. through: the degree in the thickness direction, "
     "from\n"
     "the contact face to the opposite one, at least the geometry's own; by default that of the label's bulk, as\n"
     "without contact. Degree 1 takes about half of the unknowns and of the time, as the published studies do, but\n"
     "locks in bending and for nu near 0.5. print(body) shows the degrees. grading: as in patch:refine.\n"
     "Where a patch is folded so that two opposite faces are one, as in a full ring, the body is joined at that seam;\n"
     "print(body) says along which direction it is closed.\n"
     "Source: k-refinement 2.3.3, varying-order layers (5.1) to (5.6) of V. Agrawal, thesis, IIT Guwahati, 2020.\n"
     "Example: sg.body{ patch = sg.shapes.rectangle{ width = 3, height = 1 }, elements = {8, 3}, order = \"N2-N2.2\",\n"
     "                  contact = \"north\", material = sg.neo_hookean{ E = 1, nu = 0.3 } }\n"
     "Example: sg.body{ patch = sg.shapes.block{ size = {4, 4, 2} }, elements = {4, 4, 2}, order = {\"N2-N4\", "
     "\"N2\"},\n"
     "                  contact = \"back\", material = sg.neo_hookean{ E = 1, nu = 0.3 } }"},
};

template <int D>
constexpr Function body_entries[] = {
    {"__tostring", body_text<D>,
     "body\nWhat sg.body returns, an immutable value; print(body) tells its elements and degrees per direction, of its "
     "rows\nof control points one after the other where these differ, and its size; tostring(body) the first line of "
     "that.\nMethods: face, edge, corner, dofs, points."},
    {"dofs", dofs<D>,
     "b:dofs()\n"
     "Degrees of freedom { interface, bulk, total }: of the contact faces' control points, of all others, of all.\n"
     "Example: slab:dofs().total"},
    {"face", face<D>,
     "b:face(name)\n"
     "A face for supports and contacts: \"west\", \"east\" (xi1), \"south\", \"north\" (xi2), in 3D \"front\",\n"
     "\"back\" (xi3).\n"
     "Example: slab:face \"north\""},
    {"edge", edge<D>,
     "b:edge(name)\nThe control points where two faces of a solid body meet, for supports: \"south-front\" and so on.\n"
     "Example: cube:edge \"south-front\""},
    {"corner", corner<D>,
     "b:corner(name)\n"
     "The control point of a corner for supports: \"south-west\", in 3D \"west-south-front\" and so on.\n"
     "Example: slab:corner \"south-west\""},
    {"points", points<D>,
     "b:points()\n"
     "The control points {{x, y}, …}, row after row from south to north (west to east when the contact face is west\n"
     "or east); in 3D {{x, y, z}, …}, layer after layer from front to back, or along the direction of the contact\n"
     "face.\n"
     "Example: slab:points()[1]  --> {0.0, 0.0}"},
};

} // namespace

void open_body(lua_State* L) {
  register_functions(L, "sg", body_functions);
  register_type<Body<2>, Body<3>>(L, body_entries<2>, body_entries<3>);
  open_places(L);
}

} // namespace signorini::bind
