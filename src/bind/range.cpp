#include "bind/range.hpp"

namespace signorini::bind {

std::array<double, 2> read_range(lua_State* L, const Options& o) {
  const Argument argument = o.argument("range", "lowest and highest value");
  constexpr const char* expected = "a list of 2 numbers {low, high}";
  const int value = o.push_value("range");
  if (lua_type(L, value) == LUA_TNUMBER) reject(L, value, argument, expected, "put both into braces, as in {0, 1}");
  if (read_list(L, value, argument, expected) != 2) reject(L, value, argument, expected);
  const std::vector<double> range = read_numbers(L, value, argument);
  return {range[0], range[1]};
}

} // namespace signorini::bind
