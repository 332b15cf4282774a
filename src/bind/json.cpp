#include "bind/arguments.hpp"
#include "bind/functions.hpp"
#include "bind/open.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

namespace signorini::bind {

namespace {

using Json = nlohmann::json; // keys are sorted

constexpr int deepest = 100; // levels of tables: deeper ones are probably cyclic

/// The sorted names of a table's fields, without the indices 1…length of its list.
std::set<std::string> keys_of(lua_State* L, int index, lua_Integer length, const std::string& path) {
  std::set<std::string> names;
  lua_pushnil(L);
  while (lua_next(L, index)) {
    lua_pop(L, 1);
    if (lua_type(L, -1) == LUA_TSTRING)
      names.insert(to<std::string>(L, -1));
    else if (!lua_isinteger(L, -1) || lua_tointeger(L, -1) < 1 || lua_tointeger(L, -1) > length)
      throw ArgumentError(text(path, " has the key ", describe(L, -1), ", which is neither a name nor part of a list"));
  }
  return names;
}

/// Converts plain Lua data. Paths are the names of values in messages.
struct Reader {
  lua_State* L;
  bool finite; ///< report nan and infinity as errors

  Json table(int index, const std::string& path, int level) const {
    if (level > deepest) throw ArgumentError(text(path, " is nested deeper than ", deepest, " tables"));
    luaL_checkstack(L, 4, "nested tables");
    const auto length = static_cast<lua_Integer>(lua_rawlen(L, index));
    const std::set<std::string> names = keys_of(L, index, length, path);
    if (!names.empty() && length > 0)
      throw ArgumentError(text(path, " mixes names and a list in one table: put the list under a name"));
    Json json = names.empty() ? Json::array() : Json::object();
    for (lua_Integer i = 1; i <= length; ++i) {
      lua_rawgeti(L, index, i);
      json.push_back(value(lua_gettop(L), text(path, "[", i, "]"), level + 1));
      lua_pop(L, 1);
    }
    for (const std::string& name : names) {
      push(L, name);
      lua_rawget(L, index);
      json[name] = value(lua_gettop(L), text(path, ".", name), level + 1);
      lua_pop(L, 1);
    }
    return json;
  }

  Json value(int index, const std::string& path, int level = 1) const {
    switch (lua_type(L, index)) {
    case LUA_TBOOLEAN:
      return lua_toboolean(L, index) != 0;
    case LUA_TNUMBER:
      if (lua_isinteger(L, index)) return lua_tointeger(L, index);
      if (finite && !std::isfinite(lua_tonumber(L, index)))
        throw ArgumentError(text(path, " is ", describe(L, index), ": only finite numbers can be written"));
      return lua_tonumber(L, index);
    case LUA_TSTRING:
      return to<std::string>(L, index);
    case LUA_TTABLE:
      return table(index, path, level);
    default:
      throw ArgumentError(text(path, " is ", describe(L, index),
                               ": only numbers, strings, true, false and tables of these can be written"));
    }
  }
};

void push_json(lua_State* L, const Json& json) {
  luaL_checkstack(L, 4, "nested values");
  switch (json.type()) {
  case Json::value_t::boolean:
    return push(L, json.get<bool>());
  case Json::value_t::number_integer:
  case Json::value_t::number_unsigned:
    return lua_pushinteger(L, json.get<lua_Integer>());
  case Json::value_t::number_float:
    return push(L, json.get<double>());
  case Json::value_t::string:
    return push(L, json.get<std::string>());
  case Json::value_t::array:
    return push_list(L, json, [&](const Json& entry) { push_json(L, entry); });
  case Json::value_t::object:
    lua_createtable(L, 0, static_cast<int>(json.size()));
    for (const auto& [name, value] : json.items()) {
      push(L, name);
      push_json(L, value);
      lua_rawset(L, -3);
    }
    return;
  default:
    return lua_pushnil(L);
  }
}

/// core.write_json(value, name): plain data as JSON text, names sorted; numbers read back bit-identical. An empty table
/// is an empty list. Errors for other values and non-finite numbers give the position; name: of the value in messages.
int write_json(lua_State* L) {
  luaL_checkany(L, 1);
  const std::string path = lua_isnoneornil(L, 2) ? "the value" : to<std::string>(L, 2);
  // Invalid UTF-8 is replaced: text quoted by a message must not prevent writing.
  push(L, Reader{L, true}.value(1, path).dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
  return 1;
}

/// core.read_json(text): the value of a JSON text; null becomes nil.
int read_json(lua_State* L) {
  const Json json = Json::parse(to<std::string>(L, 1), nullptr, false);
  require(!json.is_discarded(), "the text is not valid JSON");
  push_json(L, json);
  return 1;
}

/// core.pack(value): plain data as bytes (MessagePack), names sorted; numbers may be nan or infinite, strings may
/// contain any bytes.
int pack(lua_State* L) {
  luaL_checkany(L, 1);
  std::string bytes;
  Json::to_msgpack(Reader{L, false}.value(1, "the value"), bytes);
  push(L, bytes);
  return 1;
}

/// core.unpack(bytes): the value of packed bytes.
int unpack(lua_State* L) {
  const Json json = Json::from_msgpack(to<std::string>(L, 1), true, false);
  require(!json.is_discarded(), "the bytes are damaged");
  push_json(L, json);
  return 1;
}

constexpr Function json_entries[] = {
    {"write_json", write_json}, {"read_json", read_json}, {"pack", pack}, {"unpack", unpack}};

} // namespace

void open_json(lua_State* L) {
  register_functions(L, "core", json_entries);
}

} // namespace signorini::bind
