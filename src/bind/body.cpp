#include "bind/functions.hpp"
#include "bind/open.hpp"
#include "bind/patch.hpp"
#include "bind/scene.hpp"

#include <algorithm>

namespace signorini::bind {

namespace {

using nurbs::Side;

template <auto make> int material(lua_State* L) {
  const Options o(L, 1, {"E", "nu"});
  const double modulus = o.positive("E", "Young's modulus, force per area");
  push_object<solid::Material>(L, make(modulus, o.number("nu", "Poisson's ratio")));
  return 1;
}

std::string constants_in_words(const solid::Material& material) {
  const solid::ElasticConstants& law = solid::constants(material);
  return text("E = ", law.youngs_modulus, ", nu = ", law.poissons_ratio);
}

int material_tostring(lua_State* L) {
  const auto& material = self<solid::Material>(L);
  const bool linear = std::holds_alternative<solid::LinearElastic>(material);
  push(L, text(linear ? "linear elastic: " : "neo-Hooke: ", constants_in_words(material)));
  return 1;
}

/// The contact faces: a name or a list of names.
std::vector<Side> read_contact(lua_State* L, const Options& o, int dimensions) {
  std::vector<Side> sides;
  if (!o.has("contact")) return sides;
  const Argument argument = o.argument("contact", "the face that carries the layer, or a list of two opposite ones");
  const int index = o.push_value("contact");
  const std::vector<std::string> names = {"west", "east", "south", "north"};
  const auto add = [&](int at) { sides.push_back(nurbs::side_of(read_choice(L, at, argument, names), dimensions)); };
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

int body(lua_State* L) {
  const Options o(L, 1, {"patch", "elements", "order", "contact", "material", "through", "grading"});
  const auto& patch = o.object<nurbs::Patch>("patch", "the reference geometry");
  const int dimensions = patch.parametric_dimension();
  if (dimensions != 2 || patch.dimension() != 2)
    reject(L, o.push_value("patch"), o.argument("patch", "the reference geometry"), "a surface in the plane",
           "bodies are plane (2D)");
  nurbs::Plan plan;
  plan.elements = read_per_direction(L, o.push_value("elements"), o.argument("elements", "knot spans per direction"),
                                     dimensions, 1, 1'000'000);
  if (o.has("grading")) plan.grading = read_gradings(L, o.push_value("grading"), o.argument("grading"), dimensions);
  plan.contact = read_contact(L, o, dimensions);
  const nurbs::Label label =
      nurbs::parse_label(o.string("order", "a label such as \"N2\", \"N4\", \"N2-N4\", \"N2-N2.2\" or \"L1\""));
  plan.labels.assign(plan.contact.empty() ? 2 : 1, label);
  if (o.has("through"))
    plan.through = o.integer("through", "degree through the body, normal to the contact face", 1, nurbs::max_degree);
  const auto& material =
      o.object<solid::Material>("material", "made by sg.neo_hookean{ E, nu } or sg.linear_elastic{ E, nu }");
  push_object<Body<2>>(L, std::make_shared<const solid::Body<2>>(nurbs::Discretisation(patch, plan), material));
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

template <int D> int face(lua_State* L) {
  const Body<D>& body = self<Body<D>>(L);
  const std::string name = read_string(L, 2, {"name", "a face, such as \"south\""});
  const Side side = nurbs::side_of(name, D);
  push_object(L, Place<D>{body, name, side, body->space().face_functions(side)});
  return 1;
}

template <int D> int corner(lua_State* L) {
  const Body<D>& body = self<Body<D>>(L);
  const std::vector<std::string> corners = {"south-west", "south-east", "north-west", "north-east"};
  const std::string name = read_choice(L, 2, {"name", "a corner"}, corners);
  const std::size_t dash = name.find('-');
  const auto first = body->space().face_functions(nurbs::side_of(name.substr(0, dash), 2));
  const auto second = body->space().face_functions(nurbs::side_of(name.substr(dash + 1), 2));
  std::vector<int> both;
  for (int function : first)
    if (std::find(second.begin(), second.end(), function) != second.end()) both.push_back(function);
  push_object(L, Place<D>{body, name, {}, std::move(both)});
  return 1;
}

template <int D> int points(lua_State* L) {
  push(L, self<Body<D>>(L)->space().points());
  return 1;
}

template <int D> int body_tostring(lua_State* L) {
  const solid::Body<D>& body = *self<Body<D>>(L);
  const nurbs::Discretisation& space = body.space();
  push(L, text("plane body: ", space.elements(0), " x ", space.elements(1), " elements, ", 2 * space.functions(),
               " degrees of freedom, ", body.linear() ? "linear elastic, " : "", constants_in_words(body.material())));
  return 1;
}

template <int D> int place_tostring(lua_State* L) {
  const Place<D>& place = self<Place<D>>(L);
  push(L, text(place.side ? "face" : "corner", " '", place.name, "' of a body, ", place.functions.size(),
               " control point", place.functions.size() == 1 ? "" : "s"));
  return 1;
}

constexpr Function functions[] = {
    {"neo_hookean", wrap<material<solid::neo_hookean>>,
     "sg.neo_hookean{ E, nu }\n"
     "Compressible neo-Hooke material, W = lambda/2 (ln J)^2 + mu/2 (tr C - 3) - mu ln J. E: Young's modulus (force "
     "per\n"
     "area), nu: Poisson's ratio in (-1, 0.5). Plane strain in 2D, unless the model is axisymmetric.\n"
     "Example: sg.neo_hookean{ E = 1, nu = 0.3 }"},
    {"linear_elastic", wrap<material<solid::linear_elastic>>,
     "sg.linear_elastic{ E, nu }\n"
     "Hooke's law of small strains, sigma = lambda tr(eps) I + 2 mu eps; contact still follows the deformed surface. "
     "E:\n"
     "Young's modulus (force per area), nu: Poisson's ratio in (-1, 0.5). Plane strain in 2D, unless the model is "
     "axisymmetric.\n"
     "Example: sg.linear_elastic{ E = 1, nu = 0.3 }"},
    {"body", wrap<body>,
     "sg.body{ patch, elements, order, contact, material, through, grading }\n"
     "A solid body. patch: its shape. elements: knot spans per parametric direction. order: a discretisation label, "
     "see\n"
     "help \"labels\". contact: the face that carries the layer (\"south\"), or two opposite ones; along it the label "
     "holds,\n"
     "through the body the geometry's own degree, unless `through` says another. Without contact the label holds in "
     "both\n"
     "directions. grading: as in patch:refine.\n"
     "Example: sg.body{ patch = sg.shapes.rectangle{ width = 3, height = 1 }, elements = {8, 3}, order = \"N2-N2.2\",\n"
     "                  contact = \"north\", material = sg.neo_hookean{ E = 1, nu = 0.3 } }"},
};

constexpr Function material_rows[] = {
    {"__tostring", wrap<material_tostring>, "tostring(material)\nThe law and its constants in words."},
};

template <int D>
constexpr Function body_rows[] = {
    {"__tostring", wrap<body_tostring<D>>, "tostring(b)\nThe body's size in words."},
    {"dofs", wrap<dofs<D>>,
     "b:dofs()\nDegrees of freedom { interface, bulk, total }: of the contact faces' control points, of all others, of "
     "all."},
    {"face", wrap<face<D>>,
     "b:face(name)\nA face for supports and contacts: \"west\", \"east\" (xi1), \"south\", \"north\" (xi2)."},
    {"corner", wrap<corner<D>>,
     "b:corner(name)\nThe control point of a corner for supports: \"south-west\" and so on."},
    {"points", wrap<points<D>>,
     "b:points()\nThe control points {{x, y}, …}, row after row from south to north (west to "
     "east when the contact face is west or east)."},
};

template <int D>
constexpr Function place_rows[] = {
    {"__tostring", wrap<place_tostring<D>>, "tostring(f)\nWhich face or corner it is."},
};

} // namespace

void open_body(lua_State* L) {
  register_functions(L, "sg", functions);
  register_type<solid::Material>(L, material_rows);
  register_type<Body<2>>(L, body_rows<2>);
  register_type<Place<2>>(L, place_rows<2>);
}

} // namespace signorini::bind
