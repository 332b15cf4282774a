#include "bind/stack.hpp"
#include <algorithm>

#include <cmath>
#include <limits>

namespace signorini::bind {

namespace {

std::string element(const Argument& argument, int i) {
  return text(argument.name, "[", i, "]");
}

/// What helps most when something else came where a number belongs.
std::string number_cure(lua_State* L, int index) {
  if (lua_type(L, index) == LUA_TSTRING && lua_isnumber(L, index)) return "remove the quotes";
  if (lua_istable(L, index)) return "write a plain number without braces";
  return "";
}

std::string list_cure(lua_State* L, int index) {
  if (lua_type(L, index) == LUA_TNUMBER) return "put it into braces, as in {1, 2}";
  if (lua_istable(L, index)) return "write its values one after the other, as in {1, 2}, without names or gaps";
  return "";
}

double read_value(lua_State* L, int index, const Argument& argument, bool gaps_allowed) {
  if (gaps_allowed && lua_type(L, index) == LUA_TNUMBER && !std::isfinite(lua_tonumber(L, index)))
    return std::numeric_limits<double>::quiet_NaN();
  return read_number(L, index, argument);
}

} // namespace

double read_number(lua_State* L, int index, const Argument& argument, const char* expected) {
  if (lua_type(L, index) != LUA_TNUMBER) reject(L, index, argument, expected, number_cure(L, index));
  const double value = lua_tonumber(L, index);
  if (!std::isfinite(value))
    reject(L, index, argument, "a finite number", "look for a division by zero in what computes it");
  return value;
}

double read_positive(lua_State* L, int index, const Argument& argument) {
  const double value = read_number(L, index, argument, "a positive number");
  if (!(value > 0)) reject(L, index, argument, "a positive number", "give a value above 0");
  return value;
}

double read_non_negative(lua_State* L, int index, const Argument& argument) {
  const double value = read_number(L, index, argument, "a number, 0 or more");
  if (!(value >= 0)) reject(L, index, argument, "a number, 0 or more", "give 0 or a positive value");
  return value;
}

int read_integer(lua_State* L, int index, const Argument& argument, int low, int high) {
  const std::string expected = high == std::numeric_limits<int>::max() ? text("a whole number, ", low, " or more")
                               : low == high                           ? text("the number ", low)
                                             : text("a whole number from ", low, " to ", high);
  if (lua_type(L, index) != LUA_TNUMBER) reject(L, index, argument, expected, number_cure(L, index));
  int whole = 0;
  const lua_Integer value = lua_tointegerx(L, index, &whole);
  if (!whole || value < low || value > high)
    reject(L, index, argument, expected,
           whole ? text("give a value ", value < low ? "from " : "up to ", value < low ? low : high)
                 : "give a value without a fraction");
  return static_cast<int>(value);
}

bool read_flag(lua_State* L, int index, const Argument& argument) {
  if (!lua_isboolean(L, index)) reject(L, index, argument, "true or false");
  return lua_toboolean(L, index);
}

std::string read_string(lua_State* L, int index, const Argument& argument) {
  if (lua_type(L, index) != LUA_TSTRING) reject(L, index, argument, "a string", "write it in quotes");
  std::size_t length = 0;
  const char* value = lua_tolstring(L, index, &length);
  return {value, length};
}

std::string read_choice(lua_State* L, int index, const Argument& argument, const std::vector<std::string>& choices) {
  if (lua_type(L, index) != LUA_TSTRING) reject(L, index, argument, one_of(choices), "write it in quotes");
  const std::string value = lua_tostring(L, index);
  for (const auto& choice : choices)
    if (value == choice) return value;
  const std::string best = nearest(value, choices);
  reject(L, index, argument, one_of(choices), best.empty() ? "take one of these" : text("did you mean '", best, "'?"));
}

int read_list(lua_State* L, int index, const Argument& argument, const char* expected) {
  if (!lua_istable(L, index)) reject(L, index, argument, expected, list_cure(L, index));
  index = lua_absindex(L, index);
  lua_Unsigned keys = 0;
  for (lua_pushnil(L); lua_next(L, index); lua_pop(L, 1)) ++keys;
  const auto length = lua_rawlen(L, index);
  if (keys != length) reject(L, index, argument, expected, list_cure(L, index));
  return static_cast<int>(length);
}

std::vector<double> read_numbers(lua_State* L, int index, const Argument& argument, bool gaps_allowed) {
  const int count = read_list(L, index, argument, "a list of numbers");
  std::vector<double> values(static_cast<std::size_t>(count));
  for (int i = 1; i <= count; ++i) {
    if (lua_rawgeti(L, index, i) == LUA_TNUMBER && std::isfinite(lua_tonumber(L, -1)))
      values[static_cast<std::size_t>(i - 1)] = lua_tonumber(L, -1);
    else
      values[static_cast<std::size_t>(i - 1)] =
          read_value(L, -1, {element(argument, i), argument.meaning}, gaps_allowed);
    lua_pop(L, 1);
  }
  return values;
}

std::vector<int> read_integers(lua_State* L, int index, const Argument& argument, int low, int high) {
  const int count = read_list(L, index, argument, "a list of whole numbers");
  std::vector<int> values;
  for (int i = 1; i <= count; ++i) {
    lua_rawgeti(L, index, i);
    values.push_back(read_integer(L, -1, {element(argument, i), argument.meaning}, low, high));
    lua_pop(L, 1);
  }
  return values;
}

VectorX read_point(lua_State* L, int index, const Argument& argument, int low, int high) {
  const char* expected = low == high ? (low == 1   ? "a list of 1 number"
                                        : low == 2 ? "a list of 2 numbers {x, y}"
                                                   : "a list of 3 numbers {x, y, z}")
                                     : "a list of 2 or 3 numbers";
  const int count = read_list(L, index, argument, expected);
  if (count < low || count > high) reject(L, index, argument, expected);
  const std::vector<double> values = read_numbers(L, index, argument);
  return Eigen::Map<const VectorX>(values.data(), count);
}

MatrixX read_points(lua_State* L, int index, const Argument& argument) {
  const int count = read_list(L, index, argument, "a list of points {{x, y}, …}");
  if (count == 0) reject(L, index, argument, "a list of at least one point {{x, y}, …}");
  MatrixX points;
  for (int i = 1; i <= count; ++i) {
    lua_rawgeti(L, index, i);
    const int dimension = static_cast<int>(points.rows());
    const VectorX point = i == 1 ? read_point(L, -1, {element(argument, i), argument.meaning})
                                 : read_point(L, -1, {element(argument, i), argument.meaning}, dimension, dimension);
    if (i == 1) points.resize(point.size(), count);
    points.col(i - 1) = point;
    lua_pop(L, 1);
  }
  return points;
}

bool has_type(lua_State* L, int index, const char* name) {
  if (!lua_isuserdata(L, index) || luaL_getmetafield(L, index, "__name") != LUA_TSTRING) return false;
  const bool same = lua_tostring(L, -1) == std::string_view(name);
  lua_pop(L, 1);
  return same;
}

void reject_dimension(lua_State* L, const Argument& argument, const char* name, int expected) {
  const char *plane = "in the plane", *space = "in 3D";
  throw ArgumentError(text(function_name(L), ": ", argument.name, " must be ", with_article(name), " ",
                           expected == 2 ? plane : space, ", got one ", expected == 2 ? space : plane,
                           ": the parts of a model are all in the plane, or all in 3D"));
}

void push(lua_State* L, const VectorX& values) {
  lua_createtable(L, static_cast<int>(values.size()), 0);
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    lua_pushnumber(L, values[i]);
    lua_rawseti(L, -2, i + 1);
  }
}

void push(lua_State* L, const MatrixX& points) {
  lua_createtable(L, static_cast<int>(points.cols()), 0);
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    push(L, VectorX(points.col(i)));
    lua_rawseti(L, -2, i + 1);
  }
}

void count_memory(lua_State* L, double bytes) {
  lua_gc(L, LUA_GCSTEP, static_cast<int>(std::min(bytes / 1024, 1e6)));
}

} // namespace signorini::bind
