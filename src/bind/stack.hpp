#pragma once
// The typed layer over Lua's stack: pushing results, userdata of C++ types.

#include "base/eigen.hpp"
#include "bind/message.hpp"

#include <memory>
#include <new>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace signorini::bind {

// ── Pushing ──────────────────────────────────────────────────────────────────────────────────────────────────────────

inline void push(lua_State* L, double value) {
  lua_pushnumber(L, value);
}
inline void push(lua_State* L, int value) {
  lua_pushinteger(L, value);
}
inline void push(lua_State* L, bool value) {
  lua_pushboolean(L, value);
}
inline void push(lua_State* L, const char* value) {
  lua_pushstring(L, value);
}
inline void push(lua_State* L, const std::string& value) {
  lua_pushlstring(L, value.data(), value.size());
}
/// The name of a type in messages and help: template <> struct Type<Patch> { static constexpr auto name = "patch"; };
/// A type that comes for the plane and for space has one name for both and the `dimension` 2 or 3.
template <class T> struct Type;

template <class T>
concept Registered = requires {
  Type<T>::name;
};

template <Registered T> T& push_object(lua_State* L, T value);
template <Registered T> void push(lua_State* L, T object) {
  push_object(L, std::move(object));
}

/// Nothing is nil.
template <class T> void push(lua_State* L, const std::optional<T>& value) {
  value ? push(L, *value) : lua_pushnil(L);
}

/// Pushes a list: push_one(value) pushes an entry.
template <class Values, class PushOne> void push_list(lua_State* L, const Values& values, PushOne push_one) {
  lua_newtable(L);
  lua_Integer i = 0;
  for (const auto& value : values) {
    push_one(value);
    lua_rawseti(L, -2, ++i);
  }
}
template <class T> void push(lua_State* L, const std::vector<T>& values) {
  push_list(L, values, [&](const T& value) { push(L, value); });
}
inline void push(lua_State* L, const VectorX& values) {
  push_list(L, values, [&](double value) { push(L, value); });
}
/// A list of the columns, each a list: points.
inline void push(lua_State* L, const MatrixX& points) {
  push_list(L, points.colwise(), [&](const auto& point) { push(L, VectorX(point)); });
}

/// Sets a field of the table on top of the stack.
template <class T> void set_field(lua_State* L, const char* name, const T& value) {
  push(L, value);
  lua_setfield(L, -2, name);
}

/// Sets fields of the table on top of the stack: names and values in turn.
template <class T, class... Rest> void set_fields(lua_State* L, const char* name, const T& value, const Rest&... rest) {
  set_field(L, name, value);
  if constexpr (sizeof...(rest) > 0) set_fields(L, rest...);
}

/// Pushes a table of fields: names and values in turn.
template <class... Parts> void push_fields(lua_State* L, const Parts&... parts) {
  lua_createtable(L, 0, sizeof...(parts) / 2);
  set_fields(L, parts...);
}

// ── Userdata ─────────────────────────────────────────────────────────────────────────────────────────────────────────
// A T lives inside its userdata: an immutable value (Patch) or a shared pointer (std::shared_ptr<Body>), whose other
// owners keep the object alive when Lua lets go of it.

/// The name of a type's metatable in the registry.
template <Registered T> const char* key_of() {
  if constexpr (requires { Type<T>::dimension; }) {
    static const std::string key = text(Type<T>::name, " in ", Type<T>::dimension, "D");
    return key.c_str();
  } else
    return Type<T>::name;
}

/// The object at an index, or nullptr when it is something else.
template <class T> T* test_object(lua_State* L, int index) {
  return static_cast<T*>(luaL_testudata(L, index, key_of<T>()));
}

/// Whether the value has a type of this name, whatever its dimension.
bool has_type(lua_State* L, int index, const char* name);

/// Throws: the value has the right name, but belongs to a scene of the other dimension.
[[noreturn]] void reject_dimension(const Argument& argument, const char* name, int expected);

template <class T> T& read_object(lua_State* L, int index, const Argument& argument = {Type<T>::name}) {
  T* object = test_object<T>(L, index);
  if constexpr (requires { Type<T>::dimension; })
    if (!object && has_type(L, index, Type<T>::name)) reject_dimension(argument, Type<T>::name, Type<T>::dimension);
  if (!object) reject(L, index, argument, with_article(Type<T>::name));
  return *object;
}

/// The object a method was called on: its first argument.
template <class T> T& self(lua_State* L) {
  return read_object<T>(L, 1);
}

template <Registered T> T& push_object(lua_State* L, T value) {
  void* memory = lua_newuserdatauv(L, sizeof(T), 0);
  T* object = new (memory) T(std::move(value));
  luaL_setmetatable(L, key_of<T>());
  return *object;
}

/// Tells Lua's collector that the object just pushed holds this much memory that Lua does not see, so that it works
/// as hard as if it had allocated that itself.
void count_memory(lua_State* L, double bytes);

} // namespace signorini::bind
