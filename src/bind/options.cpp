#include "bind/options.hpp"

#include <algorithm>

namespace signorini::bind {

Options::Options(lua_State* L, int index, std::vector<std::string> known, bool positional, std::string path)
    : L_(L), index_(lua_absindex(L, index)), known_(std::move(known)), path_(std::move(path)) {
  const auto reject = [&](const auto&... parts) {
    throw ArgumentError(text(function_name(L), path_.empty() ? "" : ": ", path_, parts...,
                             " known: ", known_.empty() ? "none" : listed(known_)));
  };
  luaL_checkstack(L, 16, "too many nested arguments");
  if (!lua_istable(L, index_))
    reject(" takes a table of named arguments, got ", describe(L, index_), ": write ",
           path_.empty() ? function_name(L) : path_ + " = ", "{ ", known_.empty() ? "" : known_.front() + " = …",
           " };");
  std::vector<std::string> unknown;
  for (lua_pushnil(L); lua_next(L, index_); lua_pop(L, 1)) {
    if (positional && lua_isinteger(L, -2)) continue;
    if (lua_type(L, -2) != LUA_TSTRING) reject(" takes named arguments, got ", describe(L, -1), " without a name;");
    const std::string key = lua_tostring(L, -2);
    if (std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
    unknown.push_back(key);
  }
  if (unknown.empty()) return;
  std::sort(unknown.begin(), unknown.end());
  constexpr std::size_t most = 3;
  unknown.resize(std::min(unknown.size(), most));
  std::string all;
  for (const std::string& key : unknown) {
    lua_getfield(L, index_, key.c_str());
    const std::string hint = did_you_mean(key, known_);
    all += text(all.empty() ? "" : "; ", "unknown argument '", key, "' (", describe(L, -1), ")", hint);
    lua_pop(L, 1);
  }
  reject(": ", all, all.ends_with('?') ? "" : ";");
}

int Options::push_value(const char* key) const {
  if (std::find(known_.begin(), known_.end(), key) == known_.end())
    throw std::logic_error(text("argument '", key, "' is read but not declared"));
  luaL_checkstack(L_, 16, "too many arguments");
  lua_getfield(L_, index_, key);
  return lua_gettop(L_);
}

Argument Options::argument(const char* key, const char* meaning) const {
  return {path_.empty() ? key : text(path_, ".", key), meaning};
}

bool Options::has(const char* key) const {
  const bool found = !lua_isnil(L_, push_value(key));
  lua_pop(L_, 1);
  return found;
}

template <class T, class Read>
T Options::read(const char* key, const char* meaning, const std::optional<T>& otherwise, Read reader) const {
  const int position = push_value(key);
  T value = otherwise && lua_isnil(L_, position) ? *otherwise : reader(position, argument(key, meaning));
  lua_settop(L_, position - 1);
  return value;
}

double Options::number(const char* key, const char* meaning, std::optional<double> otherwise) const {
  return read(key, meaning, otherwise, [this](int i, const Argument& a) { return read_number(L_, i, a); });
}

double Options::positive(const char* key, const char* meaning, std::optional<double> otherwise) const {
  return read(key, meaning, otherwise, [this](int i, const Argument& a) { return read_positive(L_, i, a); });
}

double Options::non_negative(const char* key, const char* meaning, std::optional<double> otherwise) const {
  return read(key, meaning, otherwise, [this](int i, const Argument& a) { return read_non_negative(L_, i, a); });
}

int Options::integer(const char* key, const char* meaning, int low, int high, std::optional<int> otherwise) const {
  return read(key, meaning, otherwise, [&](int i, const Argument& a) { return read_integer(L_, i, a, low, high); });
}

bool Options::flag(const char* key, const char* meaning, std::optional<bool> otherwise) const {
  return read(key, meaning, otherwise, [this](int i, const Argument& a) { return read_flag(L_, i, a); });
}

std::string Options::string(const char* key, const char* meaning, std::optional<std::string> otherwise) const {
  return read(key, meaning, otherwise, [this](int i, const Argument& a) { return read_string(L_, i, a); });
}

std::string Options::choice(const char* key, const char* meaning, const std::vector<std::string>& choices,
                            std::optional<std::string> otherwise) const {
  return read(key, meaning, otherwise, [&](int i, const Argument& a) { return read_choice(L_, i, a, choices); });
}

std::vector<double> Options::numbers(const char* key, const char* meaning,
                                     std::optional<std::vector<double>> otherwise) const {
  return read(key, meaning, otherwise, [this](int i, const Argument& a) { return read_numbers(L_, i, a); });
}

VectorX Options::point(const char* key, const char* meaning, int low, int high,
                       std::optional<VectorX> otherwise) const {
  return read(key, meaning, otherwise, [&](int i, const Argument& a) { return read_point(L_, i, a, low, high); });
}

MatrixX Options::points(const char* key, const char* meaning) const {
  return read(key, meaning, std::optional<MatrixX>{},
              [this](int i, const Argument& a) { return read_points(L_, i, a); });
}

Options Options::table(const char* key, std::vector<std::string> known) const {
  const int position = push_value(key);
  return Options(L_, position, std::move(known), false, argument(key).name);
}

void Options::each(const char* key, const char* meaning,
                   const std::function<void(const std::string& name, int index, const Argument& entry)>& visit) const {
  const int table = push_value(key);
  const Argument whole = argument(key, meaning);
  if (!lua_istable(L_, table)) reject(L_, table, whole, "a table of names", "write { name = … }");
  std::vector<std::string> names;
  for (lua_pushnil(L_); lua_next(L_, table); lua_pop(L_, 1)) {
    if (lua_type(L_, -2) != LUA_TSTRING)
      throw ArgumentError(text(function_name(L_), ": every entry of ", whole.name, " needs a name, got ",
                               describe(L_, -1), " without one: write name = …"));
    names.emplace_back(lua_tostring(L_, -2));
  }
  std::sort(names.begin(), names.end());
  for (const auto& name : names) {
    lua_getfield(L_, table, name.c_str());
    visit(name, table + 1, {text(whole.name, ".", name)});
    lua_settop(L_, table);
  }
  lua_settop(L_, table - 1);
}

} // namespace signorini::bind
