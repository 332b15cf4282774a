#include "bind/functions.hpp"

#include <algorithm>

namespace signorini::bind {

namespace {

/// Gives the value on top of the stack (left there) its help page under a qualified name.
void document(lua_State* L, const std::string& name, const char* doc) {
  push_table(L, "core.docs");
  push(L, doc);
  lua_setfield(L, -2, name.c_str());
  lua_pop(L, 1);
  push_table(L, "core.names");
  lua_pushvalue(L, -2);
  push(L, name);
  lua_rawset(L, -3);
  lua_pop(L, 1);
}

/// The function as a closure that knows its qualified name.
void push_function(lua_State* L, const std::string& name, const Function& row) {
  push(L, name);
  lua_pushcclosure(L, row.function, 1);
  document(L, name, row.doc);
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

/// A method of two C++ types. Upvalues: its name, both functions, and the key of the second type.
int dispatch(lua_State* L) {
  const bool second = luaL_testudata(L, 1, lua_tostring(L, lua_upvalueindex(4)));
  return lua_tocfunction(L, lua_upvalueindex(second ? 3 : 2))(L);
}

/// The method of a type's row as one function.
void push_method(lua_State* L, const std::string& name, std::span<const Implementation> types, std::size_t row) {
  const Function& first = types[0].rows[row];
  if (types.size() == 1) return push_function(L, name, first);
  push(L, name);
  lua_pushcfunction(L, first.function);
  lua_pushcfunction(L, types[1].rows[row].function);
  push(L, types[1].key);
  lua_pushcclosure(L, dispatch, 4);
  document(L, name, first.doc);
}

bool is_metamethod(const Function& row) {
  return std::string_view(row.name).starts_with("__");
}

/// Pushes core.types[name] with the methods of a type.
void push_methods(lua_State* L, const char* name, std::span<const Implementation> types) {
  push_table(L, text("core.types.", name));
  for (std::size_t row = 0; row < types[0].rows.size(); ++row)
    if (const Function& first = types[0].rows[row]; !is_metamethod(first)) {
      push_method(L, text(name, ":", first.name), types, row);
      lua_setfield(L, -2, first.name);
    }
  lua_createtable(L, 0, 1);
  push(L, name);
  lua_pushcclosure(L, wrap<unknown_method>, 1);
  lua_setfield(L, -2, "__index");
  lua_setmetatable(L, -2);
}

/// The metatable of one of a type's implementations; the methods' table is on top of the stack and stays there.
void make_metatable(lua_State* L, const char* name, const Implementation& type) {
  luaL_newmetatable(L, type.key);
  set_field(L, "__name", name);
  for (const Function& row : type.rows)
    if (is_metamethod(row)) {
      push_function(L, name, row);
      lua_setfield(L, -2, row.name);
    }
  lua_pushvalue(L, -2);
  lua_setfield(L, -2, "__index");
  lua_pushcfunction(L, type.collect);
  lua_setfield(L, -2, "__gc");
  set_field(L, "__metatable", false); // getmetatable() shows nothing, so __gc cannot be called by hand
  lua_pop(L, 1);
}

} // namespace

int raise(lua_State* L, const std::exception& error) {
  std::string message = user_position(L), reason = error.what();
  if (!dynamic_cast<const ArgumentError*>(&error) && lua_isstring(L, lua_upvalueindex(1))) {
    // Errors of the rooms below name the C++ function ("face: …"); the name in the script takes its place.
    const std::string name = function_name(L), last = name.substr(name.find_last_of(".:") + 1) + ": ";
    message += name + ": ";
    if (reason.starts_with(last)) reason.erase(0, last.size());
  }
  push(L, message + reason);
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

void register_functions(lua_State* L, const std::string& table, std::span<const Function> rows) {
  push_table(L, table);
  for (const Function& row : rows) {
    push_function(L, table + "." + row.name, row);
    lua_setfield(L, -2, row.name);
  }
  lua_pop(L, 1);
}

void register_type(lua_State* L, const char* name, std::span<const Implementation> implementations) {
  push_methods(L, name, implementations);
  for (const Implementation& type : implementations) make_metatable(L, name, type);
  lua_pop(L, 1);
}

} // namespace signorini::bind
