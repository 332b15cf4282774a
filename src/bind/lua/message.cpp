#include "bind/lua/message.hpp"
#include "base/words.hpp"
#include "bind/lua/functions.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace signorini::bind {

namespace {

constexpr const char* folder_key = "signorini.folder";

/// Levenshtein distance, row by row; a swap of neighboring letters counts as one edit.
std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before, previous(b.size() + 1), row(b.size() + 1);
  std::iota(previous.begin(), previous.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({previous[j] + 1, row[j - 1] + 1, previous[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before = previous;
    std::swap(previous, row);
  }
  return previous.back();
}

/// The longest beginning of at most so many bytes that does not cut a character of UTF-8.
std::string_view beginning(std::string_view string, std::size_t most) {
  if (string.size() <= most) return string;
  while (most > 0 && (static_cast<unsigned char>(string[most]) & 0xC0) == 0x80) --most;
  return string.substr(0, most);
}

/// A string in quotes, of a long one its beginning.
std::string quoted(lua_State* L, int index) {
  constexpr std::size_t longest = 200;
  std::size_t size = 0;
  const char* bytes = lua_tolstring(L, index, &size);
  const std::string_view shown = beginning({bytes, size}, longest);
  return text("'", shown, shown.size() < size ? "…'" : "'");
}

std::string describe_table(lua_State* L, int index) {
  const auto length = lua_rawlen(L, index);
  bool empty = true;
  std::string key;
  for (lua_pushnil(L); lua_next(L, index); lua_pop(L, 1)) {
    empty = false;
    if (key.empty() && lua_type(L, -2) == LUA_TSTRING) key = text("the key ", quoted(L, -2));
  }
  if (length > 0) return text("a list of ", counted(length, "value"), key.empty() ? "" : " with ", key);
  return empty ? "an empty table" : text("a table with ", key.empty() ? "keys" : key);
}

std::string describe_number(lua_State* L, int index) {
  if (lua_isinteger(L, index)) return text("the number ", lua_tointeger(L, index));
  const double value = lua_tonumber(L, index);
  if (std::isnan(value)) return "nan (not a number)";
  if (std::isinf(value)) return value > 0 ? "infinity" : "minus infinity";
  return text("the number ", value);
}

/// Pushes the prompt's text for a table; nothing when that fails. Returns whether it succeeded.
bool push_shown(lua_State* L, int index) {
  push_require(L);
  lua_pushliteral(L, "signorini.prompt.show");
  if (lua_pcall(L, 1, 1, 0) == LUA_OK) {
    lua_getfield(L, -1, "text");
    lua_remove(L, -2);
    lua_pushvalue(L, index);
    if (lua_pcall(L, 1, 1, 0) == LUA_OK) return true;
  }
  lua_pop(L, 1);
  return false;
}

} // namespace

void set_library_folder(lua_State* L, const std::string& folder) {
  lua_pushlstring(L, folder.data(), folder.size());
  lua_setfield(L, LUA_REGISTRYINDEX, folder_key);
}

bool in_library(lua_State* L, const lua_Debug& frame) {
  lua_getfield(L, LUA_REGISTRYINDEX, folder_key);
  const std::string folder = lua_isstring(L, -1) ? lua_tostring(L, -1) : "";
  lua_pop(L, 1);
  return !folder.empty() && std::string(frame.source).starts_with(text("@", folder, "/"));
}

std::string user_position(lua_State* L) {
  lua_Debug frame;
  for (int level = 0; lua_getstack(L, level, &frame); ++level) {
    lua_getinfo(L, "Sl", &frame);
    if (frame.currentline > 0 && !in_library(L, frame)) return text(frame.short_src, ":", frame.currentline, ": ");
  }
  return "";
}

const char* function_name(lua_State* L) {
  return lua_tostring(L, lua_upvalueindex(1));
}

std::string describe(lua_State* L, int index) {
  index = lua_absindex(L, index);
  switch (lua_type(L, index)) {
  case LUA_TNONE:
  case LUA_TNIL:
    return "nothing";
  case LUA_TBOOLEAN:
    return lua_toboolean(L, index) ? "true" : "false";
  case LUA_TNUMBER:
    return describe_number(L, index);
  case LUA_TSTRING:
    return text("the string ", quoted(L, index));
  case LUA_TTABLE:
  case LUA_TUSERDATA: {
    if (const int type = luaL_getmetafield(L, index, "__name"); type != LUA_TNIL) {
      const bool named = type == LUA_TSTRING && lua_rawlen(L, -1) > 0;
      const std::string name = named ? std::string(lua_tostring(L, -1)) : luaL_typename(L, index);
      lua_pop(L, 1);
      return with_article(std::string(beginning(name, 40)));
    }
    return lua_istable(L, index) ? describe_table(L, index) : "userdata";
  }
  default:
    return text("a ", luaL_typename(L, index));
  }
}

std::string printable(const std::string& message) {
  constexpr std::size_t longest = 4000, start = 3000, end = 600;
  std::string whole(message);
  if (whole.size() > longest) {
    std::size_t last = whole.size() - end;
    while ((static_cast<unsigned char>(whole[last]) & 0xC0) == 0x80) ++last;
    whole = text(beginning(whole, start), "…", whole.substr(last));
  }
  std::string shown;
  for (const char c : whole) {
    const auto code = static_cast<unsigned char>(c);
    if ((code >= 0x20 && code != 0x7F) || c == '\n' || c == '\t') {
      shown += c;
      continue;
    }
    constexpr const char* digits = "0123456789abcdef";
    shown += text("\\x", digits[code / 16], digits[code % 16]);
  }
  return shown;
}

std::string with_article(const std::string& noun) {
  return text(std::string_view("aeiou").find(noun.front()) == std::string_view::npos ? "a " : "an ", noun);
}

std::string nearest(const std::string& word, const std::vector<std::string>& words) {
  std::string best;
  constexpr std::size_t most_edits = 2; // three letters turn wear into near, pretension into retention
  std::size_t least = std::clamp<std::size_t>(word.size() / 3, 1, most_edits) + 1;
  for (const auto& candidate : words)
    if (const auto d = distance(word, candidate); d < least && d < candidate.size()) {
      least = d;
      best = candidate;
    }
  if (!best.empty()) return best;
  // Too many edits, but one is a prefix of the other: h or tol for height or tolerance, fixed for fix.
  const auto begins = [&](const std::string& candidate) { return candidate.starts_with(word); };
  if (!word.empty() && std::count_if(words.begin(), words.end(), begins) == 1)
    return *std::find_if(words.begin(), words.end(), begins);
  constexpr std::size_t telling = 3;
  for (const auto& candidate : words)
    if (candidate.size() >= telling && word.starts_with(candidate)) return candidate;
  // mises for von_mises
  const auto ends = [&](const std::string& candidate) { return candidate.ends_with(word); };
  if (word.size() >= telling && std::count_if(words.begin(), words.end(), ends) == 1)
    return *std::find_if(words.begin(), words.end(), ends);
  return best;
}

std::string one_of(const std::vector<std::string>& words) {
  std::string list;
  for (std::size_t i = 0; i < words.size(); ++i)
    list += (i == 0 ? "'" : i + 1 == words.size() ? " or '" : ", '") + words[i] + "'";
  return list;
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& words) {
  const std::string best = nearest(word, words);
  return best.empty() ? "" : text("; did you mean '", best, "'?");
}

void reject(lua_State* L, int index, const Argument& argument, const std::string& expected, const std::string& cure) {
  const std::string meaning =
      *argument.meaning && argument.meaning != expected ? text(" (", argument.meaning, ")") : "";
  const std::string ending = cure.empty() ? "" : text(": ", cure);
  if (lua_isnoneornil(L, index)) fail(argument.name, meaning, " is missing: it must be ", expected);
  fail(argument.name, " must be ", expected, meaning, ", got ", describe(L, index), ending);
}

void push_require(lua_State* L) {
  push_table(L, "core");
  lua_getfield(L, -1, "require");
  lua_remove(L, -2);
}

void push_error_text(lua_State* L, int index) {
  index = lua_absindex(L, index);
  const int type = lua_type(L, index);
  if (type == LUA_TNIL) {
    lua_pushliteral(L, "error without a message");
    return;
  }
  const bool bare = type == LUA_TTABLE && luaL_getmetafield(L, index, "__tostring") == LUA_TNIL;
  if (bare && push_shown(L, index)) {
    lua_pushfstring(L, "error: %s", lua_tostring(L, -1));
    lua_remove(L, -2);
    return;
  }
  if (type == LUA_TTABLE && !bare) lua_pop(L, 1);
  luaL_tolstring(L, index, nullptr);
}

} // namespace signorini::bind
