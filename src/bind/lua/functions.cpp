#include "bind/lua/functions.hpp"
#include "bind/lua/limits.hpp"
#include "bind/lua/wording/wording.hpp"

#include "os/limits.hpp"

#include <algorithm>
#include <new>

namespace signorini::bind {

namespace {

/// Assigns a qualified name to the value on top of the stack, which stays there.
void name_value(lua_State* L, const std::string& name) {
  push_table(L, "core.names");
  lua_pushvalue(L, -2);
  push(L, name);
  lua_rawset(L, -3);
  lua_pop(L, 1);
}

// Upvalues of a function's closure: its qualified name, the kind of argument check, the C++ function; of two C++ types
// also the other function and the key of its type.
enum Upvalue { name_of_function = 1, check_of_arguments, first_function, second_function, second_key };

enum Check { unchecked, of_function, of_method };

/// Pushes the function that checks the arguments of calls.
void push_checker(lua_State* L) {
  constexpr const char* key = "signorini.checker";
  if (lua_getfield(L, LUA_REGISTRYINDEX, key) == LUA_TFUNCTION) return;
  lua_pop(L, 1);
  push_require(L);
  lua_pushliteral(L, "signorini.call.check");
  lua_call(L, 1, 1);
  lua_getfield(L, -1, "call");
  lua_remove(L, -2);
  lua_pushvalue(L, -1);
  lua_setfield(L, LUA_REGISTRYINDEX, key);
}

/// Throws ArgumentError unless a method, "patch:face", is called on an object of its type.
void check_owner(lua_State* L) {
  const std::string name = function_name(L), owner = name.substr(0, name.find(':'));
  if (!has_type(L, 1, owner.c_str()))
    throw ArgumentError(text(name, " must be called on ", with_article(owner), ", not on ", describe(L, 1),
                             ": write object:method(…) with a colon"));
}

/// Replaces the arguments from `first` to the top of the stack by checked ones, according to the function's table; the
/// object of a method precedes them.
void check_arguments(lua_State* L, const char* name, int first) {
  const int before = lua_gettop(L), given = before - first + 1;
  luaL_checkstack(L, given + 8, "too many arguments");
  push_checker(L);
  lua_pushstring(L, name);
  if (first == 1) lua_pushnil(L);
  for (int i = 1; i <= before; ++i) lua_pushvalue(L, i);
  lua_call(L, given + 2, LUA_MULTRET);
  for (int i = before; i >= first; --i) lua_remove(L, i);
}

int invoke(lua_State* L) {
  const auto check = static_cast<Check>(lua_tointeger(L, lua_upvalueindex(check_of_arguments)));
  if (check == of_method) check_owner(L);
  if (check != unchecked) check_arguments(L, function_name(L), check == of_method ? 2 : 1);
  const bool two = !lua_isnone(L, lua_upvalueindex(second_key));
  if (two && check == unchecked && lua_istable(L, 1)) return 0; // core.* of an object that imitates a model
  const bool second = two && luaL_testudata(L, 1, lua_tostring(L, lua_upvalueindex(second_key)));
  return lua_tocfunction(L, lua_upvalueindex(second ? second_function : first_function))(L);
}

/// Pushes a function as a closure with its qualified name. `method`: its first argument is the object. `types`: its C++
/// types, or empty.
void push_function(lua_State* L, const std::string& name, const Function& row, bool method,
                   std::span<const Implementation> types = {}, std::size_t place = 0) {
  const bool internal = name.starts_with("core.") || (row.name[0] == '_' && std::string_view(row.name) != "__call");
  const bool two = types.size() == 2;
  push(L, name);
  push(L, static_cast<int>(internal ? unchecked : method ? of_method : of_function));
  lua_pushcfunction(L, row.function);
  if (two) {
    lua_pushcfunction(L, types[1].rows[place].function);
    push(L, types[1].key);
  }
  lua_pushcclosure(L, wrap<invoke>, two ? second_key : first_function);
  name_value(L, name);
}

int unknown_method(lua_State* L) {
  const std::string type = lua_tostring(L, lua_upvalueindex(1));
  std::vector<std::string> known;
  lua_pushnil(L);
  while (lua_next(L, 1)) {
    lua_pop(L, 1);
    known.emplace_back(lua_tostring(L, -1));
  }
  std::sort(known.begin(), known.end());
  const bool named = lua_type(L, 2) == LUA_TSTRING;
  const std::string hint = named ? did_you_mean(lua_tostring(L, 2), known) : "";
  throw ArgumentError(text(with_article(type), " has no method ",
                           named ? text("'", lua_tostring(L, 2), "'") : describe(L, 2), hint,
                           hint.empty() ? "; it has " : " It has ", listed(known)));
}

bool is_metamethod(const Function& row) {
  return std::string_view(row.name).starts_with("__");
}

/// Pushes core.types[name] with the methods of a type.
void push_methods(lua_State* L, const char* name, std::span<const Implementation> types) {
  push_table(L, text("core.types.", name));
  name_value(L, name);
  for (std::size_t row = 0; row < types[0].rows.size(); ++row)
    if (const Function& first = types[0].rows[row]; !is_metamethod(first)) {
      push_function(L, text(name, ":", first.name), first, true, types, row);
      lua_setfield(L, -2, first.name);
    }
  lua_createtable(L, 0, 1);
  push(L, name);
  lua_pushcclosure(L, wrap<unknown_method>, 1);
  lua_setfield(L, -2, "__index");
  lua_setmetatable(L, -2);
}

/// Creates the metatable of one implementation of a type; the table of methods on top of the stack stays there.
void make_metatable(lua_State* L, const char* name, const Implementation& type) {
  luaL_newmetatable(L, type.key);
  set_field(L, "__name", name);
  for (const Function& row : type.rows)
    if (is_metamethod(row)) {
      push_function(L, name, row, true);
      lua_setfield(L, -2, row.name);
    }
  lua_pushvalue(L, -2);
  lua_setfield(L, -2, "__index");
  lua_pushcfunction(L, type.collect);
  lua_setfield(L, -2, "__gc");
  set_field(L, "__metatable", false); // hides the metatable, so that scripts cannot call __gc
  lua_pop(L, 1);
}

} // namespace

int raise(lua_State* L, const std::exception& error) {
  const MemoryReserve reserve;
  std::string message = user_position(L), reason = worded(error);
  if (dynamic_cast<const std::bad_alloc*>(&error)) reason = missing_memory();
  if (!dynamic_cast<const ArgumentError*>(&error) && lua_isstring(L, lua_upvalueindex(1))) {
    // Errors of lower modules lack the name of the function.
    message += std::string(function_name(L)) + ": ";
  }
  push(L, printable(message + reason));
  return 1;
}

void push_table(lua_State* L, const std::string& name) {
  lua_pushvalue(L, LUA_REGISTRYINDEX);
  for (std::size_t begin = 0; begin <= name.size();) {
    const std::size_t end = std::min(name.find('.', begin), name.size());
    const std::string part = (begin == 0 ? "signorini." : "") + name.substr(begin, end - begin);
    luaL_getsubtable(L, -1, part.c_str());
    lua_remove(L, -2);
    begin = end + 1;
  }
}

void register_functions(lua_State* L, const std::string& table, std::span<const Implementation> implementations) {
  push_table(L, table);
  for (std::size_t i = 0; i < implementations[0].rows.size(); ++i) {
    const Function& row = implementations[0].rows[i];
    push_function(L, table + "." + row.name, row, false, implementations, i);
    lua_setfield(L, -2, row.name);
  }
  lua_pop(L, 1);
}

void register_functions(lua_State* L, const std::string& table, std::span<const Function> rows) {
  const Implementation only[] = {{nullptr, nullptr, rows}};
  register_functions(L, table, only);
}

void register_type(lua_State* L, const char* name, std::span<const Implementation> implementations) {
  push_methods(L, name, implementations);
  for (const Implementation& type : implementations) make_metatable(L, name, type);
  lua_pop(L, 1);
}

} // namespace signorini::bind
