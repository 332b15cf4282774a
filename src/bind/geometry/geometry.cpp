#include "bind/geometry/geometry.hpp"

#include "bind/geometry/patch.hpp"

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

/// The face of the patches with this name.
exchange::PatchFace patch_face(const std::string& name, const std::vector<nurbs::Patch>& patches,
                               const std::string& where) {
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
  for (const auto& name : to<std::vector<std::string>>(L, index))
    faces.push_back(patch_face(name, patches, text(where, "[", faces.size() + 1, "]")));
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
  const Arguments a(L, index);
  exchange::Geometry geometry{read_objects<nurbs::Patch>(L, index)};
  if (a.has("interfaces")) {
    geometry.interfaces.emplace();
    a.list("interfaces", [&](int, int pair, const std::string& path) {
      const auto faces = read_patch_faces(L, pair, geometry.patches, path);
      geometry.interfaces->push_back({faces[0], faces[1]});
    });
  }
  if (a.has("boundaries"))
    a.each("boundaries", [&](const std::string& name, int faces, const std::string& path) {
      geometry.boundaries.push_back({name, read_patch_faces(L, faces, geometry.patches, path)});
    });
  return geometry;
}

} // namespace signorini::bind
