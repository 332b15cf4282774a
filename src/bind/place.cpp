#include "bind/place.hpp"
#include "bind/arguments.hpp"
#include "bind/functions.hpp"
#include "bind/patch.hpp"

#include <algorithm>

namespace signorini::bind {

namespace {

using nurbs::Side;

/// The names of a name's parts: "south", "front" of "south-front".
std::vector<std::string> parts_of(const std::string& name) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= name.size();) {
    const std::size_t end = std::min(name.find('-', begin), name.size());
    parts.push_back(name.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

/// All names of places where `count` faces meet, their directions in order: "west-south", "west-front", "south-front".
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

/// The directions' order of a corner's name does not matter; in the plane its names begin with south or north.
std::vector<std::string> corner_names(int dimensions) {
  if (dimensions == 2) return {"south-west", "south-east", "north-west", "north-east"};
  return meeting_names(dimensions, dimensions);
}

/// The sides that a name consists of; empty unless they are `count` known ones of different directions.
std::vector<Side> read_sides(const std::string& name, int dimensions, int count) {
  const std::vector<std::string> known = face_names(dimensions), parts = parts_of(name);
  std::vector<Side> sides;
  for (const std::string& part : parts) {
    if (std::find(known.begin(), known.end(), part) == known.end()) return {};
    const Side side = nurbs::side_of(part, dimensions);
    for (const Side& other : sides)
      if (other.direction == side.direction) return {};
    sides.push_back(side);
  }
  return static_cast<int>(sides.size()) == count ? sides : std::vector<Side>{};
}

/// The place where the faces of a name meet, its functions those of all of them.
template <int D> void push_meeting(lua_State* L, int count, const std::vector<std::string>& names) {
  const Body<D>& body = self<Body<D>>(L);
  const auto name = to<std::string>(L, 2);
  const std::vector<Side> sides = read_sides(name, D, count);
  if (sides.empty()) reject(L, 2, {"name"}, one_of(names), "did you mean '" + nearest(name, names) + "'?");
  std::vector<int> common = body->space().face_functions(sides.front());
  for (const Side& side : sides) {
    const std::vector<int> others = body->space().face_functions(side);
    std::erase_if(common, [&](int f) { return std::find(others.begin(), others.end(), f) == others.end(); });
  }
  push_object(L, Place<D>{body, name, {}, std::move(common)});
}

/// core.place_names(body or patch, count): the names of its places where so many faces meet, 0: of its corners; without
/// an object those of solids.
int place_names(lua_State* L) {
  const auto* patch = test_object<nurbs::Patch>(L, 1);
  const int dimensions = patch ? patch->parametric_dimension() : test_object<Body<2>>(L, 1) ? 2 : 3;
  const int count = to<int>(L, 2);
  push(L, count == 0           ? corner_names(dimensions)
          : count < dimensions ? meeting_names(dimensions, count)
                               : std::vector<std::string>());
  return 1;
}

template <int D> int place_text(lua_State* L) {
  const Place<D>& place = self<Place<D>>(L);
  push(L, text(kind_of(place), " '", place.name, "' of a body, ", place.functions.size(), " control point",
               place.functions.size() == 1 ? "" : "s"));
  return 1;
}

constexpr Function place_core_entries[] = {{"place_names", place_names}};

template <int D> constexpr Function place_entries[] = {{"__tostring", place_text<D>}};

} // namespace

std::vector<std::string> face_names(int dimensions) {
  return meeting_names(dimensions, 1);
}

template <int D> std::string kind_of(const Place<D>& place) {
  if (place.side) return "face";
  return static_cast<int>(parts_of(place.name).size()) == D ? "corner" : "edge";
}

template <int D> int face(lua_State* L) {
  const Body<D>& body = self<Body<D>>(L);
  const auto name = to<std::string>(L, 2);
  const Side side = nurbs::side_of(name, D);
  push_object(L, Place<D>{body, name, side, body->space().face_functions(side)});
  return 1;
}

template <int D> int edge(lua_State* L) {
  if (D == 2)
    throw ArgumentError(text(function_name(L),
                             ": a plane body has faces and corners, no edges: write b:face \"south\" ",
                             "or b:corner \"south-west\""));
  push_meeting<D>(L, 2, meeting_names(D, 2));
  return 1;
}

template <int D> int corner(lua_State* L) {
  push_meeting<D>(L, D, corner_names(D));
  return 1;
}

void open_places(lua_State* L) {
  register_type<Place<2>, Place<3>>(L, place_entries<2>, place_entries<3>);
  register_functions(L, "core", place_core_entries);
}

template std::string kind_of<2>(const Place<2>&);
template std::string kind_of<3>(const Place<3>&);
template int face<2>(lua_State*);
template int face<3>(lua_State*);
template int edge<2>(lua_State*);
template int edge<3>(lua_State*);
template int corner<2>(lua_State*);
template int corner<3>(lua_State*);

} // namespace signorini::bind
