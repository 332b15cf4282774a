#include "bind/lua/arguments.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini::bind {

namespace {

// The check of arguments runs in Lua, where a script can replace functions that it uses, and functions of core have
// none: what follows is safe for any value.

/// The number of entries of a list, or of nil.
lua_Unsigned length(lua_State* L, int index) {
  require(lua_istable(L, index) || lua_isnoneornil(L, index), "a list is expected, got ", describe(L, index));
  return lua_rawlen(L, index);
}

template <class T> std::vector<T> to_list(lua_State* L, int index) {
  index = lua_absindex(L, index);
  const auto count = length(L, index);
  luaL_checkstack(L, 8, "nested lists");
  std::vector<T> values;
  values.reserve(count);
  for (lua_Unsigned i = 1; i <= count; ++i) {
    lua_rawgeti(L, index, static_cast<lua_Integer>(i));
    values.push_back(to<T>(L, -1));
    lua_pop(L, 1);
  }
  return values;
}

} // namespace

template <class T> std::array<T, 2> to_pair(lua_State* L, int index) {
  const auto values = to_list<T>(L, index);
  require(values.size() == 2, "a list of 2 numbers is expected, got ", describe(L, index));
  return {values[0], values[1]};
}

template <> double to(lua_State* L, int index) {
  const double value = lua_tonumber(L, index);
  return std::isfinite(value) ? value : std::numeric_limits<double>::quiet_NaN();
}

template <> int to(lua_State* L, int index) {
  constexpr lua_Integer most = std::numeric_limits<int>::max();
  return static_cast<int>(std::clamp(lua_tointeger(L, index), -most, most));
}

template <> bool to(lua_State* L, int index) {
  return lua_toboolean(L, index);
}

template <> std::string_view to(lua_State* L, int index) {
  std::size_t length = 0;
  const char* value = lua_tolstring(L, index, &length);
  return {value, length};
}

template <> std::string to(lua_State* L, int index) {
  return std::string(to<std::string_view>(L, index));
}

template <> std::vector<double> to(lua_State* L, int index) {
  return to_list<double>(L, index);
}

template <> std::vector<int> to(lua_State* L, int index) {
  return to_list<int>(L, index);
}

template <> std::vector<std::string> to(lua_State* L, int index) {
  return to_list<std::string>(L, index);
}

template <> std::array<double, 2> to(lua_State* L, int index) {
  return to_pair<double>(L, index);
}

template <> std::array<int, 2> to(lua_State* L, int index) {
  return to_pair<int>(L, index);
}

template <> VectorX to(lua_State* L, int index) {
  const auto values = to_list<double>(L, index);
  return Eigen::Map<const VectorX>(values.data(), static_cast<Eigen::Index>(values.size()));
}

template <> MatrixX to(lua_State* L, int index) {
  const auto columns = to_list<VectorX>(L, index);
  MatrixX points(columns.empty() ? 0 : columns.front().size(), static_cast<Eigen::Index>(columns.size()));
  for (std::size_t i = 0; i < columns.size(); ++i) {
    require(columns[i].size() == points.rows(), "points of equal dimension are expected, got ", describe(L, index));
    points.col(static_cast<Eigen::Index>(i)) = columns[i];
  }
  return points;
}

Arguments::Arguments(lua_State* L, int index, std::string path)
    : L_(L), index_(lua_absindex(L, index)), path_(std::move(path)) {
  bind::require(lua_istable(L, index_), "a table of named arguments is expected, got ", describe(L, index_));
}

int Arguments::push(const char* key) const {
  luaL_checkstack(L_, 16, "too many arguments");
  lua_getfield(L_, index_, key);
  return lua_gettop(L_);
}

std::string Arguments::name(const char* key) const {
  return path_.empty() ? key : text(path_, ".", key);
}

bool Arguments::has(const char* key) const {
  return !is(key, LUA_TNIL);
}

bool Arguments::is(const char* key, int type) const {
  const bool found = lua_type(L_, push(key)) == type;
  lua_pop(L_, 1);
  return found;
}

Arguments Arguments::table(const char* key) const {
  return Arguments(L_, push(key), name(key));
}

void Arguments::each(const char* key,
                     const std::function<void(const std::string&, int, const std::string&)>& visit) const {
  const int table = push(key);
  bind::require(lua_istable(L_, table), "a table is expected, got ", describe(L_, table));
  std::vector<std::string> names;
  for (lua_pushnil(L_); lua_next(L_, table); lua_pop(L_, 1))
    if (lua_type(L_, -2) == LUA_TSTRING) names.push_back(to<std::string>(L_, -2)); // may contain zeros
  std::sort(names.begin(), names.end());
  for (const auto& entry : names) {
    bind::push(L_, entry);
    lua_rawget(L_, table);
    visit(entry, table + 1, text(name(key), ".", entry));
    lua_settop(L_, table);
  }
  lua_settop(L_, table - 1);
}

void Arguments::list(const char* key, const std::function<void(int, int, const std::string&)>& visit) const {
  const int table = push(key);
  const auto count = static_cast<int>(length(L_, table));
  for (int i = 0; i < count; ++i) {
    lua_rawgeti(L_, table, i + 1);
    visit(i, table + 1, text(name(key), "[", i + 1, "]"));
    lua_settop(L_, table);
  }
  lua_settop(L_, table - 1);
}

void Arguments::refuse(const char* key, const std::string& expected, const std::string& cure) const {
  reject(L_, push(key), {name(key)}, expected, cure);
}

} // namespace signorini::bind
