#include "bind/marks.hpp"

namespace signorini::bind {

std::vector<view::PointMark> read_marks(lua_State* L, const Options& o, int dimension) {
  std::vector<view::PointMark> marks;
  if (!o.has("marks")) return marks;
  const Argument whole = o.argument("marks", "places to be marked");
  const int list = o.push_value("marks");
  const int count = read_list(L, list, whole, "a list of marks { x = {…}, text = … }");
  for (int i = 1; i <= count; ++i) {
    lua_rawgeti(L, list, i);
    const Options one(L, -1, {"x", "text", "kind", "body", "element", "point", "contact", "X", "value"}, false,
                      text(whole.name, "[", i, "]"));
    view::PointMark mark{Vec<3>::Zero(), one.string("text", "a few words beside the mark", "")};
    mark.at.head(dimension) = one.point("x", "place in the present state", dimension, dimension);
    marks.push_back(std::move(mark));
    lua_settop(L, list);
  }
  lua_settop(L, list - 1);
  return marks;
}

} // namespace signorini::bind
