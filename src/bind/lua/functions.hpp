#pragma once
// Registration of C++ functions in Lua by rows {name, function}.

#include "bind/lua/stack.hpp"

#include <span>

namespace signorini::bind {

/// One row. The function may throw std::exception, which becomes a Lua error. Arguments of public functions are checked
/// and completed by defaults according to their table in lua/signorini/pages.
struct Function {
  const char* name;
  lua_CFunction function;
};

/// Raises a Lua error with the message of a C++ exception and the position in the user's script.
int raise(lua_State* L, const std::exception& error);

/// A C++ function for Lua, if none of the registrations below is used. Catches only std::exception: Lua's own
/// exceptions must pass.
template <int (*function)(lua_State*)> int wrap(lua_State* L) {
  try {
    return function(L);
  } catch (const std::exception& error) {
    raise(L, error);
  }
  return lua_error(L);
}

/// Pushes the table of a dotted name, created if missing.
void push_table(lua_State* L, const std::string& name);

/// __gc: destroys the C++ object once and invalidates the userdata for remaining references.
template <class T> int collect(lua_State* L) {
  if (T* object = test_object<T>(L, 1)) {
    object->~T();
    lua_pushnil(L);
    lua_setmetatable(L, 1);
  }
  return 0;
}

/// One of the C++ types of a Lua type: the key of its metatable in the registry, its __gc, and its rows. Rows whose
/// name starts with two underscores are metamethods, all others methods.
struct Implementation {
  const char* key;
  lua_CFunction collect;
  std::span<const Function> rows;
};

/// Creates a Lua type for one C++ type, or for two with rows of the same names, which are one type for users: a method
/// is that of the object's C++ type. The table of methods is core.types[name], so that Lua code can extend it; a second
/// call for a type adds methods to it. An unknown method is an error that lists the known ones.
void register_type(lua_State* L, const char* name, std::span<const Implementation> implementations);

/// Registers functions under a dotted name, "sg.nurbs" or "core"; missing tables are created.
void register_functions(lua_State* L, const std::string& table, std::span<const Function> rows);
inline void register_functions(lua_State* L, const std::string& table, std::initializer_list<Function> rows) {
  register_functions(L, table, std::span(rows.begin(), rows.size()));
}
/// Calls the one of two implementations that fits the C++ type of its first argument; of a table, an object that
/// imitates a model, functions of core return nothing.
void register_functions(lua_State* L, const std::string& table, std::span<const Implementation> implementations);

template <class Plane, class Space>
void register_functions(lua_State* L, const std::string& table, std::span<const Function> plane,
                        std::span<const Function> space) {
  const Implementation both[] = {{key_of<Plane>(), nullptr, plane}, {key_of<Space>(), nullptr, space}};
  register_functions(L, table, both);
}

template <class T> void register_type(lua_State* L, std::span<const Function> rows) {
  const Implementation only[] = {{key_of<T>(), collect<T>, rows}};
  register_type(L, Type<T>::name, only);
}
template <class T> void register_type(lua_State* L, std::initializer_list<Function> rows) {
  register_type<T>(L, std::span(rows.begin(), rows.size()));
}

template <class Plane, class Space>
void register_type(lua_State* L, std::span<const Function> plane, std::span<const Function> space) {
  const Implementation both[] = {{key_of<Plane>(), collect<Plane>, plane}, {key_of<Space>(), collect<Space>, space}};
  register_type(L, Type<Plane>::name, both);
}

} // namespace signorini::bind
