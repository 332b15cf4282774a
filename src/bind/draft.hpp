#pragma once
// A scene while sg.model reads it, and its readers.

#include "bind/scene.hpp"

namespace signorini::bind {

/// What has been read so far, with the obstacles that it has met.
template <int D> struct Draft {
  model::Scene<D> scene;
  std::vector<Rigid<D>> obstacles;
};

/// Index of a place's body. Throws ArgumentError when the scene does not have it; `where` names the argument.
template <int D>
int index_of(lua_State* L, const model::Scene<D>& scene, const Place<D>& place, const std::string& where);
/// Index of an obstacle; a new one is appended. Throws ArgumentError when it does not fit the kind of scene.
template <int D> int index_of(lua_State* L, Draft<D>& draft, const Rigid<D>& rigid, const std::string& where);

/// The face at a stack index. Throws ArgumentError for anything else.
template <int D>
model::FaceReference face_of(lua_State* L, const model::Scene<D>& scene, int index, const Argument& argument);

/// One entry of `supports`, `loads` or `contacts`. New obstacles go into the draft, what is read does not.
template <int D>
model::Support<D> read_support(lua_State* L, Draft<D>& draft, const std::string& name, int index,
                               const Argument& entry);
template <int D>
model::Load read_load(lua_State* L, const model::Scene<D>& scene, const std::string& name, int index,
                      const Argument& entry);
template <int D>
model::Contact<D> read_contact(lua_State* L, Draft<D>& draft, const std::string& name, int index,
                               const Argument& entry);

} // namespace signorini::bind
