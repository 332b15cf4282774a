// Values of a user's function of the reference position, in loads and supports.
#include "base/words.hpp"
#include "bind/scene/scene_builder.hpp"
#include "os/interrupt.hpp"

#include <cmath>

namespace signorini::bind {

namespace {

bool is_number(lua_State* L, int index) {
  return lua_type(L, index) == LUA_TNUMBER && std::isfinite(lua_tonumber(L, index));
}

bool is_list_of_numbers(lua_State* L, int index, int size) {
  if (!lua_istable(L, index) || static_cast<int>(lua_rawlen(L, index)) != size) return false;
  bool numbers = true;
  for (int i = 1; i <= size; ++i) {
    lua_rawgeti(L, index, i);
    numbers = numbers && is_number(L, lua_gettop(L));
    lua_pop(L, 1);
  }
  return numbers;
}

/// The result of a user's function in words; of a list with the right length its first entry that is not a number.
std::string describe_result(lua_State* L, int index, int size) {
  if (lua_istable(L, index) && static_cast<int>(lua_rawlen(L, index)) == size)
    for (int i = 1; i <= size; ++i) {
      lua_rawgeti(L, index, i);
      const bool bad = !is_number(L, lua_gettop(L));
      const std::string words = describe(L, -1);
      lua_pop(L, 1);
      if (bad) return text("a list with ", words, " as entry ", i);
    }
  return describe(L, index);
}

/// Calls the function below `count` numbers on the stack, for one result. Errors inside it say how it is called.
void call_course(lua_State* L, int count, const std::string& name) {
  if (lua_pcall(L, count, 1, 0) == LUA_OK) return;
  if (lua_isstring(L, -1) && !interrupted()) {
    push(L, text(": ", name, " is called as function(x, y", count == 3 ? ", z" : "", ") with numbers"));
    lua_concat(L, 2);
  }
  lua_error(L);
}

} // namespace

std::string position_text(const VectorX& x) {
  std::string list;
  for (const double value : x) list += text(list.empty() ? "(" : ", ", number(value));
  return list + ")";
}

template <int D>
MatrixX values_at(const Arguments& a, const char* key, const MatrixX& positions, const std::string& list) {
  lua_State* L = a.state();
  const int function = a.push(key);
  MatrixX values(list.empty() ? 1 : D, positions.cols());
  for (Eigen::Index k = 0; k < positions.cols(); ++k) {
    lua_pushvalue(L, function);
    for (int c = 0; c < D; ++c) lua_pushnumber(L, positions(c, k));
    call_course(L, D, a.name(key));
    const int found = lua_gettop(L);
    if (!(list.empty() ? is_number(L, found) : is_list_of_numbers(L, found, D)))
      fail(a.name(key), " must return ", list.empty() ? "a finite number" : list, ", got ",
           list.empty() ? describe(L, found) : describe_result(L, found, D),
           " at X = ", position_text(positions.col(k)), ": it is called with the coordinates of reference positions");
    if (list.empty())
      values(0, k) = lua_tonumber(L, found);
    else
      values.col(k) = to<VectorX>(L, found);
    lua_pop(L, 1);
  }
  lua_pop(L, 1);
  return values;
}

template MatrixX values_at<2>(const Arguments&, const char*, const MatrixX&, const std::string&);
template MatrixX values_at<3>(const Arguments&, const char*, const MatrixX&, const std::string&);

} // namespace signorini::bind
