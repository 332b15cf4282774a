#pragma once
// Typed interface to Lua's stack: pushes results, userdata of C++ types.

#include "base/eigen.hpp"
#include "bind/lua/message.hpp"

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
/// The name of a type in messages and help: template <> struct Type<Patch> { static constexpr auto name = "patch"; }; A
/// type for the plane and for space has one name for both and the `dimension` 2 or 3.
template <class T> struct Type;

template <class T>
concept Registered = requires {
  Type<T>::name;
};

template <Registered T> T& push_object(lua_State* L, T value);
template <Registered T> void push(lua_State* L, T object) {
  push_object(L, std::move(object));
}

/// An empty optional becomes nil.
template <class T> void push(lua_State* L, const std::optional<T>& value) {
  value ? push(L, *value) : lua_pushnil(L);
}

/// Pushes a list; push_one(value) pushes one entry.
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
/// A list of columns, each a list: points.
inline void push(lua_State* L, const MatrixX& points) {
  push_list(L, points.colwise(), [&](const auto& point) { push(L, VectorX(point)); });
}

/// Sets a field of the table on top of the stack.
template <class T> void set_field(lua_State* L, const char* name, const T& value) {
  push(L, value);
  lua_setfield(L, -2, name);
}

/// Sets fields of the table on top of the stack: alternating names and values.
template <class T, class... Rest> void set_fields(lua_State* L, const char* name, const T& value, const Rest&... rest) {
  set_field(L, name, value);
  if constexpr (sizeof...(rest) > 0) set_fields(L, rest...);
}

/// Pushes a table of fields: alternating names and values.
template <class... Parts> void push_fields(lua_State* L, const Parts&... parts) {
  lua_createtable(L, 0, sizeof...(parts) / 2);
  set_fields(L, parts...);
}

// ── Userdata ─────────────────────────────────────────────────────────────────────────────────────────────────────────
// A T is stored in its userdata: an immutable value (Patch) or a shared pointer (std::shared_ptr<Body>), whose other
// owners keep the object alive after Lua has collected it.

/// The name of a type's metatable in the registry.
template <Registered T> const char* key_of() {
  if constexpr (requires { Type<T>::dimension; }) {
    static const std::string key = text(Type<T>::name, " in ", Type<T>::dimension, "D");
    return key.c_str();
  } else
    return Type<T>::name;
}

/// The object at an index, or nullptr for other values.
template <class T> T* test_object(lua_State* L, int index) {
  return static_cast<T*>(luaL_testudata(L, index, key_of<T>()));
}

/// True if the value has a type of this name, in any dimension.
bool has_type(lua_State* L, int index, const char* name);

/// Throws: the value has the right type name, but the dimension of other scenes.
[[noreturn]] void reject_dimension(const Argument& argument, const char* name, int expected);

template <class T> T& read_object(lua_State* L, int index, const Argument& argument = {Type<T>::name}) {
  T* object = test_object<T>(L, index);
  if constexpr (requires { Type<T>::dimension; })
    if (!object && has_type(L, index, Type<T>::name)) reject_dimension(argument, Type<T>::name, Type<T>::dimension);
  if (!object) reject(L, index, argument, with_article(Type<T>::name));
  return *object;
}

/// The objects of a list.
template <class T> std::vector<T> read_objects(lua_State* L, int index) {
  luaL_checktype(L, index, LUA_TTABLE);
  std::vector<T> objects;
  for (lua_Integer i = 1; lua_rawgeti(L, index, i) != LUA_TNIL; lua_pop(L, 1), ++i)
    objects.push_back(read_object<T>(L, -1));
  lua_pop(L, 1);
  return objects;
}

/// The object of a method call: its first argument.
template <class T> T& self(lua_State* L) {
  return read_object<T>(L, 1);
}

template <Registered T> T& push_object(lua_State* L, T value) {
  void* memory = lua_newuserdatauv(L, sizeof(T), 0);
  luaL_getmetatable(L, key_of<T>()); // may raise out of memory, after which nothing would destroy the object
  T* object = new (memory) T(std::move(value));
  lua_setmetatable(L, -2);
  return *object;
}

/// Reports to Lua's collector that the object just pushed holds this much external memory, so that collection runs as
/// often as for memory allocated by Lua.
void count_memory(lua_State* L, double bytes);

} // namespace signorini::bind
