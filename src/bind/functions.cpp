#include "bind/functions.hpp"

#include <algorithm>
#include <new>

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

/// The end of what a bracket opens.
std::size_t closing(std::string_view text, std::size_t open) {
  int depth = 0;
  for (std::size_t i = open; i < text.size(); ++i) {
    if (text[i] == '(' || text[i] == '{') ++depth;
    if ((text[i] == ')' || text[i] == '}') && --depth == 0) return i;
  }
  return text.size();
}

/// How a page's head says that a function is called: "p:elevate(dir, times = 1)", "sg.body{ … }"; and the most
/// arguments that Lua may hand over then, the object of a method with them. −1: it does not say, or takes any number.
struct Call {
  std::string head;
  int most;
};

Call read_call(std::string_view doc, bool method) {
  const std::size_t open = doc.find_first_not_of("abcdefghijklmnopqrstuvwxyz_0123456789.:");
  if (open == std::string_view::npos || (doc[open] != '(' && doc[open] != '{')) return {"", -1};
  const std::string name(doc.substr(0, open));
  if (doc[open] == '{') return {name + "{ … }", 1 + method};
  const std::size_t end = closing(doc, open);
  const std::string_view list = doc.substr(open + 1, end - open - 1);
  if (list.find("…)") != std::string_view::npos || list.ends_with("…")) return {"", -1};
  int count = list.empty() ? 0 : 1;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (list[i] == '{' || list[i] == '(') i = closing(list, i);
    if (i < list.size() && list[i] == ',') ++count;
  }
  return {std::string(doc.substr(0, end + 1)), count + method};
}

// What a function's closure knows: its qualified name, the most arguments, how it is called, the C++ function; and of a
// method of two C++ types the other function, and the key of its type.
enum Upvalue { name_of_function = 1, most_arguments, head_of_page, first_function, second_function, second_key };

int invoke(lua_State* L) {
  const int most = static_cast<int>(lua_tointeger(L, lua_upvalueindex(most_arguments)));
  if (most >= 0 && arguments_given(L) > most)
    refuse_excess(L, function_name(L), lua_tostring(L, lua_upvalueindex(head_of_page)), most);
  const bool two = !lua_isnone(L, lua_upvalueindex(second_key));
  const bool second = two && luaL_testudata(L, 1, lua_tostring(L, lua_upvalueindex(second_key)));
  return lua_tocfunction(L, lua_upvalueindex(second ? second_function : first_function))(L);
}

/// The function as a closure that knows its qualified name and how many arguments it takes. `method`: its object is one
/// of them. `types`: the C++ types of a method, or none.
void push_function(lua_State* L, const std::string& name, const Function& row, bool method,
                   std::span<const Implementation> types = {}, std::size_t place = 0) {
  const bool internal = name.starts_with("core.") || (row.name[0] == '_' && std::string_view(row.name) != "__call");
  const Call call = internal ? Call{"", -1} : read_call(row.doc, method);
  const bool two = types.size() == 2;
  push(L, name);
  push(L, call.most);
  push(L, call.head);
  lua_pushcfunction(L, row.function);
  if (two) {
    lua_pushcfunction(L, types[1].rows[place].function);
    push(L, types[1].key);
  }
  lua_pushcclosure(L, wrap<invoke>, two ? second_key : first_function);
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

bool is_metamethod(const Function& row) {
  return std::string_view(row.name).starts_with("__");
}

/// Pushes core.types[name] with the methods of a type.
void push_methods(lua_State* L, const char* name, std::span<const Implementation> types) {
  push_table(L, text("core.types.", name));
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

/// The metatable of one of a type's implementations; the methods' table is on top of the stack and stays there.
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
  set_field(L, "__metatable", false); // getmetatable() shows nothing, so __gc cannot be called by hand
  lua_pop(L, 1);
}

} // namespace

int arguments_given(lua_State* L) {
  int given = lua_gettop(L);
  while (given > 0 && lua_isnil(L, given)) --given;
  return given;
}

std::string head_of_call(std::string_view doc) {
  return read_call(doc, false).head;
}

void refuse_excess(lua_State* L, const std::string& name, const std::string& head, int most) {
  const bool named = head.ends_with("}"); // what stands there instead of the table is worth the better message
  if (named && !lua_istable(L, most)) return;
  const bool numbers = lua_type(L, most) == LUA_TNUMBER && lua_type(L, most + 1) == LUA_TNUMBER;
  throw ArgumentError(text(name, ": too many arguments: it is called as ", head, ", got ", describe(L, most + 1),
                           " beyond that",
                           numbers ? ": put numbers that belong together into braces, as in {1, 2}" : ""));
}

int raise(lua_State* L, const std::exception& error) {
  std::string message = user_position(L), reason = error.what();
  if (dynamic_cast<const std::bad_alloc*>(&error))
    reason =
        "what was asked for does not fit into the memory of this machine: ask for fewer elements, points or pixels";
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
    push_function(L, table + "." + row.name, row, false);
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
