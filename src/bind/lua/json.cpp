#include "bind/lua/arguments.hpp"
#include "bind/lua/functions.hpp"
#include "bind/lua/open.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

namespace signorini::bind {

namespace {

using Json = nlohmann::json; // keys are sorted

constexpr int deepest = 100; // levels of tables: deeper ones are probably cyclic

/// True if JSON can hold a string as it is; it has UTF-8 alone.
bool is_utf8(const Json& string) {
  try {
    string.dump();
    return true;
  } catch (const Json::type_error&) {
    return false;
  }
}

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
  bool finite;       ///< report nan and infinity as errors
  bool utf8 = false; ///< report invalid UTF-8 as an error

  Json string(int index, const std::string& path) const {
    Json json = to<std::string>(L, index);
    if (utf8 && !is_utf8(json)) throw ArgumentError(text(path, " is not valid UTF-8, which JSON requires of strings"));
    return json;
  }

  Json table(int index, const std::string& path, int level) const {
    if (level > deepest)
      throw ArgumentError(
          text(path.substr(0, 40), "… is nested deeper than ", deepest, " tables: does one contain itself?"));
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
      if (utf8) string(lua_gettop(L), text("a name in ", path));
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
      return string(index, path);
    case LUA_TTABLE:
      return table(index, path, level);
    default:
      throw ArgumentError(text(path, " is ", describe(L, index),
                               ": only numbers, strings, true, false and tables of these can be written"));
    }
  }
};

void push_json(lua_State* L, const Json& json, int level = 0) {
  require(level < deepest || !json.is_structured(), "the data are nested deeper than ", deepest, " tables");
  luaL_checkstack(L, 4, "nested values");
  switch (json.type()) {
  case Json::value_t::boolean:
    return push(L, json.get<bool>());
  case Json::value_t::number_unsigned:
    if (json.get<lua_Unsigned>() > static_cast<lua_Unsigned>(LUA_MAXINTEGER)) return push(L, json.get<double>());
    return lua_pushinteger(L, json.get<lua_Integer>());
  case Json::value_t::number_integer:
    return lua_pushinteger(L, json.get<lua_Integer>());
  case Json::value_t::number_float:
    return push(L, json.get<double>());
  case Json::value_t::string:
    return push(L, json.get<std::string>());
  case Json::value_t::array:
    return push_list(L, json, [&](const Json& entry) { push_json(L, entry, level + 1); });
  case Json::value_t::object:
    lua_createtable(L, 0, static_cast<int>(json.size()));
    for (const auto& [name, value] : json.items()) {
      push(L, name);
      push_json(L, value, level + 1);
      lua_rawset(L, -3);
    }
    return;
  default:
    return lua_pushnil(L);
  }
}

/// core.write_json(value, name, exact): plain data as JSON text, names sorted; numbers read back bit-identical. An
/// empty table is an empty list. Errors for other values and non-finite numbers give the position; name: of the value
/// in messages. Invalid UTF-8 is replaced, because text quoted by a message must not prevent writing; exact: an error.
int write_json(lua_State* L) {
  luaL_checkany(L, 1);
  const std::string path = lua_isnoneornil(L, 2) ? "the value" : to<std::string>(L, 2);
  push(L, Reader{L, true, lua_toboolean(L, 3) != 0}.value(1, path).dump(2, ' ', false, Json::error_handler_t::replace) +
              "\n");
  return 1;
}

/// " at line 1, column 2": the place of a byte of a text.
std::string place_of(const std::string& json, std::size_t byte) {
  const auto begin = json.begin(), end = begin + static_cast<std::ptrdiff_t>(byte);
  const auto line_begin = std::find(std::make_reverse_iterator(end), json.rend(), '\n').base();
  return text(" at line ", std::count(begin, end, '\n') + 1, ", column ", end - line_begin + 1);
}

/// What is wrong with a JSON text, and where: " at line 1, column 2: unexpected …". nlohmann's messages:
///     [json.exception.parse_error.101] parse error at line 1, column 2: syntax error while parsing value - expected …
///     [json.exception.out_of_range.406] number overflow parsing '1e999'
std::string fault(const std::string& json, const std::string& message) {
  constexpr std::size_t longest = 120, digits = 20; // what is quoted of the text
  const auto place = message.find(" at line ");
  if (place == std::string::npos) {
    const auto quote = message.find('\'') + 1;
    const std::string number = message.substr(quote, message.rfind('\'') - quote);
    return text(place_of(json, json.find(number)), ": the number ", number.substr(0, digits),
                number.size() > digits ? "…" : "", " is too large");
  }
  const auto colon = message.find(": ", place), dash = message.find(" - ", colon);
  const std::string reason = message.substr(dash == std::string::npos ? colon + 2 : dash + 3);
  const auto end = reason.size() > longest ? reason.find("; last read: ") : std::string::npos;
  return text(message.substr(place, colon - place), ": ", reason.substr(0, end));
}

/// The value of a JSON text; an error says where the text is not valid.
Json parse(const std::string& json) {
  try {
    return Json::parse(json);
  } catch (const Json::exception& error) {
    require(false, "not valid JSON", fault(json, error.what()));
    return {};
  }
}

/// core.read_json(text): the value of a JSON text; null becomes nil, an integer beyond 64 bits a float.
int read_json(lua_State* L) {
  push_json(L, parse(to<std::string>(L, 1)));
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

} // namespace

void open_json(lua_State* L) {
  register_functions(L, "core",
                     {{"write_json", write_json}, {"read_json", read_json}, {"pack", pack}, {"unpack", unpack}});
}

} // namespace signorini::bind
