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

/// The face at a stack index. Throws ArgumentError for anything else; `where` names the argument.
template <int D>
model::FaceReference face_of(lua_State* L, const model::Scene<D>& scene, int index, const std::string& where);

/// One entry of `supports`, `loads` or `contacts`, whose name the caller gives it. New obstacles go into the draft.
template <int D> model::Support<D> read_support(lua_State* L, Draft<D>& draft, const Arguments& a);
template <int D> model::Load read_load(lua_State* L, const model::Scene<D>& scene, const Arguments& a);
/// `name`: under which sg.model's argument has it.
template <int D>
model::Contact<D> read_contact(lua_State* L, Draft<D>& draft, const Arguments& a, const std::string& name);

} // namespace signorini::bind
