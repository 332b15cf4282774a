#include "base/words.hpp"
#include "bind/draft.hpp"
#include "bind/place.hpp"
#include "solid/load.hpp"

#include <algorithm>
#include <set>

namespace signorini::bind {

using model::Hold;

namespace {

/// Calls add(index on the stack) for one item, or for each of a list.
template <class Add> void each_item(lua_State* L, const Options& o, const Argument& argument, Add add) {
  const int value = o.push_value("on");
  if (!lua_istable(L, value)) return add(value);
  const int count = read_list(L, value, argument);
  if (count == 0) reject(L, value, argument, argument.meaning);
  for (int i = 1; i <= count; ++i) {
    lua_rawgeti(L, value, i);
    add(lua_gettop(L));
    lua_pop(L, 1);
  }
}

[[noreturn]] void reject_twice(lua_State* L, const Argument& argument, const std::string& what) {
  throw ArgumentError(
      text(function_name(L), ": ", argument.name, " lists ", what, " twice, expected once: take one of the two out"));
}

/// The components that "x", "xy" and so on name.
template <int D> std::string read_letters(lua_State* L, const Options& o, const char* key, const char* meaning) {
  static const std::vector<std::string> plane = {"x", "y", "xy"}, space = {"x", "y", "z", "xy", "xz", "yz", "xyz"};
  const int index = o.push_value(key);
  if (D == 2 && lua_type(L, index) == LUA_TSTRING && std::string(lua_tostring(L, index)).find('z') != std::string::npos)
    reject(L, index, o.argument(key, meaning), one_of(plane), "the bodies are plane, so nothing moves along z");
  return o.choice(key, meaning, D == 2 ? plane : space);
}

template <int D>
void read_components(lua_State* L, const Options& o, const char* key, const char* meaning, Hold hold,
                     model::Support<D>& support) {
  if (!o.has(key)) return;
  for (char letter : read_letters<D>(L, o, key, meaning)) {
    Hold& component = support.hold[static_cast<std::size_t>(letter - 'x')];
    if (component != Hold::free && hold == Hold::free)
      throw ArgumentError(text(function_name(L), ": ", o.path(), " frees ", letter, ", which it also ",
                               component == Hold::fixed ? "fixes" : "drives",
                               ": free names what neither fix nor drive does, take it out of one of the two"));
    if (component != Hold::free)
      throw ArgumentError(text(function_name(L), ": ", o.path(), " both fixes and drives ", letter,
                               ": a component is either fixed or driven, take it out of one of the two"));
    component = hold;
  }
}

/// The unit vector of rotate = "z" or {ax, ay, az}.
Vec<3> read_axis(lua_State* L, const Options& o) {
  const Argument argument = o.argument("rotate", "the axis through the face's centroid that it turns about");
  const int index = o.push_value("rotate");
  const char* expected = "'x', 'y', 'z', or a vector {x, y, z}";
  if (lua_istable(L, index)) {
    const Vec<3> axis = read_point(L, index, argument, 3, 3);
    if (!(axis.norm() > 0)) reject(L, index, argument, expected, "all of its components are 0, so it has no direction");
    return axis.normalized();
  }
  const std::string letter = lua_type(L, index) == LUA_TSTRING ? lua_tostring(L, index) : "";
  if (letter != "x" && letter != "y" && letter != "z")
    reject(L, index, argument, expected, "in 3D a face turns about an axis, as in rotate = \"z\"");
  return Vec<3>::Unit(letter[0] - 'x');
}

/// Whether a plane face turns.
bool read_turning(lua_State* L, const Options& o) {
  const char* meaning = "turn the face as a rigid line by the angle that stages give";
  const int index = o.push_value("rotate");
  if (lua_type(L, index) == LUA_TSTRING || lua_istable(L, index))
    reject(L, index, o.argument("rotate", meaning), "true or false",
           "the bodies are plane, so a face can only turn in the plane: write rotate = true");
  return o.flag("rotate", meaning, false);
}

template <int D> double face_area(const solid::Body<D>& body, nurbs::Side side) {
  return solid::traction_load(body, side, 0).sum(); // ∫ Σ_A R_A dA, Σ_A R_A = 1
}

/// Calls visit(place) for each of the faces that `on` lists; other things are errors.
template <int D, class Visit>
void each_face(lua_State* L, const Options& o, const Argument& on, const char* expected, const char* cure,
               Visit visit) {
  each_item(L, o, on, [&](int index) {
    const Place<D>* place = test_object<Place<D>>(L, index);
    if (!place) reject(L, index, on, expected, cure);
    if (!place->side) reject_place(L, *place, on, expected, cure);
    visit(*place);
  });
}

/// The face that a support turns, in space the faces, about their common centroid and an axis through it.
template <int D> void read_rotation(lua_State* L, const Options& o, const Argument& on, model::Support<D>& support) {
  if constexpr (D == 2) {
    support.rotates = read_turning(L, o);
  } else {
    support.rotates = o.has("rotate");
    if (support.rotates) support.axis = read_axis(L, o);
  }
  if (!support.rotates) return;
  const char* expected = D == 2 ? "one face" : "a face, or a list of faces";
  const char* cure = D == 2 ? "what rotates is one face of a body; give other faces a support of their own"
                            : "what rotates are faces of bodies; give other things a support of their own";
  const int value = o.push_value("on");
  if (D == 2 && lua_istable(L, value)) reject(L, value, on, expected, cure);
  double size = 0;
  each_face<D>(L, o, on, expected, cure, [&](const Place<D>& face) {
    const double area = face_area(*face.body, *face.side);
    support.centre += area * model::face_centroid(*face.body, *face.side);
    size += area;
  });
  support.centre /= size;
}

/// x, y or z = place.
struct AxisPlane {
  int axis;
  double place;
  std::string words() const { return text(model::component_name(axis), " = ", number(place)); }
};

/// The plane across an axis that all of a face's control points lie in, to `tolerance`; nothing for a face that is
/// curved, inclined or collapsed.
template <int D> std::optional<AxisPlane> plane_of(const MatrixX& points, double tolerance) {
  const Vec<D> low = points.rowwise().minCoeff(), extent = points.rowwise().maxCoeff() - low;
  if ((extent.array() <= tolerance).count() != 1) return std::nullopt;
  int axis = 0;
  extent.minCoeff(&axis);
  return AxisPlane{axis, low(axis)};
}

/// Holds the normal component on faces in a plane of symmetry.
template <int D>
void read_symmetry(lua_State* L, const Options& o, const Argument& on, const model::Scene<D>& scene,
                   model::Support<D>& support) {
  if (!o.flag("symmetry", "hold the normal component on a plane of symmetry", false)) return;
  constexpr double flat = 1e-9; // of a body's size: what rounding leaves of a plane
  const auto reject_symmetry = [&](const auto&... words) {
    throw ArgumentError(text(function_name(L), ": ", o.path(), ".symmetry ", words...));
  };
  if (support.rotates) reject_symmetry("holds a plane, which rotate turns: take one of the two out");
  std::optional<AxisPlane> plane;
  const char* cure = "what lies in a plane of symmetry are faces of bodies; give other things a support of their own";
  each_face<D>(L, o, on, "a face, or a list of faces", cure, [&](const Place<D>& face) {
    const std::string words = face_in_words(scene, {index_of(L, scene, face, on.name), *face.side});
    const MatrixX points = face.body->space().points();
    const double tolerance = flat * (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm();
    const std::optional<AxisPlane> found = plane_of<D>(points(Eigen::all, face.functions), tolerance);
    if (!found)
      reject_symmetry("needs a flat face across ", D == 2 ? "x or y" : "x, y or z", ", but ", words,
                      " is curved or inclined: turn an inclined plane across an axis by patch:rotate, of all bodies "
                      "alike");
    if (scene.kind == solid::Kind::axisymmetric && found->axis == 0 && std::abs(found->place) > tolerance)
      reject_symmetry("needs the axis x = 0 or a face across y, but ", words, " is a cylinder of radius ",
                      number(found->place), ": fix = \"x\" holds its radius");
    if (plane && (plane->axis != found->axis || std::abs(plane->place - found->place) > tolerance))
      reject_symmetry("needs faces in one plane, but ", words, " lies in ", found->words(), ", the one before in ",
                      plane->words(), ": give each plane a support of its own");
    plane = found;
  });
  const std::string normal = model::component_name(plane->axis);
  for (const char* key : {"drive", "free"})
    if (o.has(key) && o.string(key, "components").find(normal) != std::string::npos)
      reject_symmetry("holds ", normal, " on the plane ", plane->words(), ", but ", key, " names ", normal,
                      " as well: take one of the two out");
  support.hold[static_cast<std::size_t>(plane->axis)] = Hold::fixed;
}

} // namespace

template <int D>
model::Support<D> read_support(lua_State* L, Draft<D>& draft, const std::string& name, int index,
                               const Argument& entry) {
  const Options o(L, index, {"on", "fix", "drive", "free", "rotate", "symmetry"}, false, entry.name);
  model::Support<D> support;
  support.name = name;
  const Argument on = o.argument("on", D == 2 ? "a face, a list of faces, a corner, or an obstacle"
                                              : "a face, a list of faces, an edge, a corner, or an obstacle");
  std::set<std::string> listed;
  each_item(L, o, on, [&](int at) {
    if (has_type(L, at, Type<Rigid<D>>::name)) {
      const int obstacle = index_of(L, draft, read_object<Rigid<D>>(L, at, on), on.name);
      if (std::find(support.obstacles.begin(), support.obstacles.end(), obstacle) != support.obstacles.end())
        reject_twice(L, on, "an obstacle");
      support.obstacles.push_back(obstacle);
      return;
    }
    if (!has_type(L, at, Type<Place<D>>::name)) reject(L, at, on, on.meaning);
    const Place<D>& place = read_object<Place<D>>(L, at, on);
    const int body = index_of(L, draft.scene, place, on.name);
    const std::string words = text(kind_of(place), " '", place.name, "' of body '",
                                   draft.scene.bodies[static_cast<std::size_t>(body)].name, "'");
    if (!listed.insert(words).second) reject_twice(L, on, words);
    support.on.push_back({body, place.functions});
  });
  read_components<D>(L, o, "fix", "components that stay", Hold::fixed, support);
  read_components<D>(L, o, "drive", "components that stages move", Hold::driven, support);
  read_components<D>(L, o, "free", "components that move as they will", Hold::free, support);
  read_rotation(L, o, on, support);
  read_symmetry(L, o, on, draft.scene, support);
  if (support.hold == std::array<Hold, D>{} && !support.rotates)
    throw ArgumentError(text(function_name(L), ": ", entry.name, " holds nothing: add fix = \"xy\", drive = \"xy\", ",
                             D == 2 ? "rotate = true" : "rotate = \"z\"", " or symmetry = true"));
  return support;
}

template <int D>
model::Load read_load(lua_State* L, const model::Scene<D>& scene, const std::string& name, int index,
                      const Argument& entry) {
  const Options o(L, index, {"on", "traction", "pressure"}, false, entry.name);
  model::Load load;
  load.name = name;
  const Argument on = o.argument("on", "a face, or a list of faces");
  each_item(L, o, on, [&](int at) {
    const model::FaceReference face = face_of(L, scene, at, on);
    if (std::find(load.on.begin(), load.on.end(), face) != load.on.end())
      reject_twice(L, on, face_in_words(scene, face));
    load.on.push_back(face);
  });
  load.pressure = o.has("pressure");
  if (load.pressure == o.has("traction"))
    throw ArgumentError(text(function_name(L), ": ", entry.name, " must have one of traction = {tx, ty",
                             D == 2 ? "" : ", tz", "} and pressure = p"));
  if (load.pressure) {
    load.start = {o.number("pressure", "force per reference area, against the outward normal")};
  } else {
    const VectorX traction = o.point("traction", "force per reference area", D, D);
    load.start.assign(traction.begin(), traction.end());
  }
  return load;
}

template model::Support<2> read_support<2>(lua_State*, Draft<2>&, const std::string&, int, const Argument&);
template model::Load read_load<2>(lua_State*, const model::Scene<2>&, const std::string&, int, const Argument&);
template model::Support<3> read_support<3>(lua_State*, Draft<3>&, const std::string&, int, const Argument&);
template model::Load read_load<3>(lua_State*, const model::Scene<3>&, const std::string&, int, const Argument&);

} // namespace signorini::bind
