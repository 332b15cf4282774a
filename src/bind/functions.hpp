#pragma once
// How C++ functions get into Lua: rows {name, function}.

#include "bind/stack.hpp"

#include <span>

namespace signorini::bind {

/// One row. The function may throw std::exception: registration makes a Lua error of it. Public functions get their
/// arguments as their table in lua/signorini/pages says: checked, with defaults.
struct Function {
  const char* name;
  lua_CFunction function;
};

/// Raises a Lua error with the message of a C++ exception, at the user's own script line.
int raise(lua_State* L, const std::exception& error);

/// A C++ function as Lua calls it, where none of the registrations below does. Only std::exception is caught: Lua's own
/// throw must pass.
template <int (*function)(lua_State*)> int wrap(lua_State* L) {
  try {
    return function(L);
  } catch (const std::exception& error) {
    raise(L, error);
  }
  return lua_error(L);
}

/// Registers rows below a dotted name, "sg.nurbs" or "core"; tables are made where missing.
void register_functions(lua_State* L, const std::string& table, std::span<const Function> rows);

/// Pushes the table of a dotted name, made where missing.
void push_table(lua_State* L, const std::string& name);

/// __gc: ends the C++ object's life once, and makes the userdata useless for whoever still holds it.
template <class T> int collect(lua_State* L) {
  if (T* object = test_object<T>(L, 1)) {
    object->~T();
    lua_pushnil(L);
    lua_setmetatable(L, 1);
  }
  return 0;
}

/// One of the C++ types behind a Lua type: the registry's name of its metatable, its __gc, and its rows. Rows whose
/// name begins with two underscores are metamethods, all others methods.
struct Implementation {
  const char* key;
  lua_CFunction collect;
  std::span<const Function> rows;
};

/// Makes a Lua type of one C++ type, or of two with rows of the same names: the first and the second are then the same
/// to users, and a method is that of the object it is called on. The methods' table is core.types[name], so that Lua
/// code can add to it. An unknown method is an error that lists the known ones.
void register_type(lua_State* L, const char* name, std::span<const Implementation> implementations);

template <class T> void register_type(lua_State* L, std::span<const Function> rows) {
  const Implementation only[] = {{key_of<T>(), collect<T>, rows}};
  register_type(L, Type<T>::name, only);
}

template <class Plane, class Space>
void register_type(lua_State* L, std::span<const Function> plane, std::span<const Function> space) {
  const Implementation both[] = {{key_of<Plane>(), collect<Plane>, plane}, {key_of<Space>(), collect<Space>, space}};
  register_type(L, Type<Plane>::name, both);
}

} // namespace signorini::bind
