#include "bind/geometry/geometry.hpp"

#include "bind/geometry/patch.hpp"

#include <algorithm>

namespace signorini::bind {

namespace {

std::string patch_face_name(const exchange::PatchFace& face) {
  return text(face.patch + 1, ".", nurbs::name_of(face.side));
}

std::vector<std::string> names_of_faces(const auto& faces) {
  std::vector<std::string> names;
  for (const exchange::PatchFace& face : faces) names.push_back(patch_face_name(face));
  return names;
}

/// The face of the patches that the text on top of the stack names, which is removed.
exchange::PatchFace read_patch_face(lua_State* L, const std::vector<nurbs::Patch>& patches, const std::string& where) {
  const auto name = to<std::string>(L, lua_gettop(L));
  lua_pop(L, 1);
  const std::size_t dot = name.find('.');
  for (std::size_t i = 0; i < patches.size(); ++i)
    for (const nurbs::Side side : nurbs::sides(patches[i].parametric_dimension()))
      if (const exchange::PatchFace face{static_cast<int>(i), side}; patch_face_name(face) == name) return face;
  fail(where, " must be a face of one of the patches 1 to ", patches.size(), ", such as '1.west', got '", name, "'",
       dot == std::string::npos ? ": write the number of the patch and a dot before the face" : "");
}

std::vector<exchange::PatchFace> read_patch_faces(lua_State* L, int index, const std::vector<nurbs::Patch>& patches,
                                                  const std::string& where) {
  std::vector<exchange::PatchFace> faces;
  for (lua_Integer i = 1, count = static_cast<lua_Integer>(lua_rawlen(L, index)); i <= count; ++i) {
    lua_rawgeti(L, index, i);
    faces.push_back(read_patch_face(L, patches, text(where, "[", i, "]")));
  }
  return faces;
}

} // namespace

void push_geometry(lua_State* L, const exchange::Geometry& geometry) {
  push(L, geometry.patches);
  if (geometry.interfaces) {
    push_list(L, *geometry.interfaces, [&](const exchange::Interface& one) { push(L, names_of_faces(one)); });
    lua_setfield(L, -2, "interfaces");
  }
  if (!geometry.boundaries.empty()) {
    lua_newtable(L);
    for (const exchange::Boundary& boundary : geometry.boundaries)
      set_field(L, boundary.name.c_str(), names_of_faces(boundary.faces));
    lua_setfield(L, -2, "boundaries");
  }
  push_table(L, "core.types");
  lua_getfield(L, -1, "patch_list"); // its methods
  lua_setmetatable(L, -3);
  lua_pop(L, 1);
}

exchange::Geometry read_geometry(lua_State* L, int index) {
  exchange::Geometry geometry;
  for (lua_Integer i = 1; lua_rawgeti(L, index, i) != LUA_TNIL; lua_pop(L, 1), ++i)
    geometry.patches.push_back(read_object<nurbs::Patch>(L, -1));
  lua_pop(L, 1);
  if (lua_getfield(L, index, "interfaces") == LUA_TTABLE) {
    geometry.interfaces.emplace();
    const int list = lua_gettop(L);
    for (lua_Integer i = 1; lua_rawgeti(L, list, i) != LUA_TNIL; lua_pop(L, 1), ++i) {
      const auto faces = read_patch_faces(L, lua_gettop(L), geometry.patches, text("interfaces[", i, "]"));
      geometry.interfaces->push_back({faces[0], faces[1]});
    }
    lua_pop(L, 1);
  }
  lua_pop(L, 1);
  if (lua_getfield(L, index, "boundaries") == LUA_TTABLE) {
    std::vector<std::string> names;
    for (lua_pushnil(L); lua_next(L, -2); lua_pop(L, 1)) names.emplace_back(lua_tostring(L, -2));
    std::sort(names.begin(), names.end());
    for (const std::string& name : names) {
      lua_getfield(L, -1, name.c_str());
      geometry.boundaries.push_back({name, read_patch_faces(L, lua_gettop(L), geometry.patches, "boundaries." + name)});
      lua_pop(L, 1);
    }
  }
  lua_pop(L, 1);
  return geometry;
}

} // namespace signorini::bind
