#pragma once
// A scene while sg.model reads it.

#include "bind/scene.hpp"

namespace signorini::bind {

/// What has been read so far. `where` names the argument that something stands in.
template <int D> struct Draft {
  model::Scene<D> scene;
  std::vector<Rigid<D>> obstacles = {}; ///< those that the scene has met

  /// Index of a place's body. Throws when the scene does not have it.
  int index_of(const Place<D>& place, const std::string& where) const;
  /// Index of an obstacle; a new one is appended. Throws when it does not fit the kind of scene.
  int index_of(const Rigid<D>& rigid, const std::string& where);
  /// The face at a stack index. Throws for anything else.
  model::FaceReference face(lua_State* L, int index, const std::string& where) const;
};

/// Throws as reject() does, for a place that is of the wrong kind.
template <int D>
[[noreturn]] void reject_place(const Place<D>& place, const std::string& where, const std::string& expected,
                               const std::string& cure) {
  fail(where, " must be ", expected, ", got the ", place.kind, " '", place.name, "': ", cure);
}

/// One entry of `supports` or `loads`, whose name the caller gives it. New obstacles go into the draft.
template <int D> model::Support<D> read_support(Draft<D>& draft, const Arguments& a);
template <int D> model::Load read_load(const Draft<D>& draft, const Arguments& a);

} // namespace signorini::bind
