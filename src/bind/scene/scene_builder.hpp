#pragma once
// A scene while sg.model reads it.

#include "bind/scene/scene.hpp"

#include <algorithm>

namespace signorini::bind {

/// The parts read so far. `where`: name of the argument in messages.
template <int D> struct SceneBuilder {
  model::Scene<D> scene;
  std::vector<Rigid<D>> obstacles = {}; ///< those of the scene
  std::vector<Message> warnings = {};   ///< about what only functions of Lua know

  /// Index of the place's body, or of a body. Throws when it is not in the scene.
  int index_of(const BoundaryPart<D>& place, const std::string& where) const { return index_of(place.body, where); }
  int index_of(const Body<D>& body, const std::string& where) const;
  /// Index of an obstacle; new ones are appended. Throws when it does not fit the kind of scene.
  int index_of(const Rigid<D>& rigid, const std::string& where);
  /// The face at a stack index. Throws for other values.
  model::FaceReference face(lua_State* L, int index, const std::string& where) const;
};

/// "face 'north' of body 'slab'". `where`: name of the argument in messages.
template <int D>
std::string part_text(const SceneBuilder<D>& builder, const BoundaryPart<D>& place, const std::string& where) {
  const int body = builder.index_of(place, where);
  return text(place.kind, " '", place.name, "' of body '", builder.scene.bodies[body].name, "'");
}

/// "a list of 2 numbers {tx, ty}", for the letter t.
template <int D> std::string components_text(char letter) {
  std::string list;
  for (int c = 0; c < D; ++c) list += text(c == 0 ? "{" : ", ", letter, model::component_name(c));
  return text("a list of ", D, " numbers ", list, "}");
}

/// Throws like reject(), for a place of the wrong kind.
template <int D>
[[noreturn]] void reject_place(const BoundaryPart<D>& place, const std::string& where, const std::string& expected,
                               const std::string& cure) {
  fail(where, " must be ", expected, ", got the ", place.kind, " '", place.name, "': ", cure);
}

/// Throws for an entry of `on` that is listed twice.
[[noreturn]] inline void reject_twice(const Arguments& a, const std::string& what) {
  fail(a.name("on"), " lists ", what, " twice, expected once: remove one of the two");
}

/// Adds a place to those that `on` lists. Throws if the same control points are listed already, perhaps under another
/// name: the edge 'east-back' is 'back-east', too. `words`: the place in messages.
template <int D>
void list_once(const Arguments& a, std::vector<BoundaryPart<D>>& listed, const BoundaryPart<D>& place,
               const std::string& words) {
  for (const BoundaryPart<D>& other : listed)
    if (place.body == other.body && std::ranges::is_permutation(place.functions, other.functions))
      reject_twice(a, place.name == other.name ? words : text(words, ", also called '", other.name, "',"));
  listed.push_back(place);
}

/// What a user's function returns at reference positions, D × points. `list`: the expected list of D numbers in words;
/// if it is empty, a number is expected, and the result is 1 × points. Throws for other results.
template <int D>
MatrixX values_at(const Arguments& a, const char* key, const MatrixX& positions, const std::string& list);

/// "(1, 0.5)"
std::string position_text(const VectorX& x);

/// An entry of `supports` or `loads`; the caller sets its name. New obstacles are added to the scene.
template <int D> model::Support<D> read_support(SceneBuilder<D>& builder, const Arguments& a);
template <int D> model::Load read_load(SceneBuilder<D>& builder, const Arguments& a);

} // namespace signorini::bind
