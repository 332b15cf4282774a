#include "view/chart.hpp"

#include "bind/functions.hpp"
#include "bind/open.hpp"
#include "bind/options.hpp"

namespace signorini::bind {

namespace {

std::array<double, 2> read_range(lua_State* L, const Options& o, const char* key) {
  const VectorX range = o.point(key, "lowest and highest value", 2, 2);
  if (!(range[0] < range[1]))
    throw ArgumentError(text(function_name(L), ": ", o.argument(key).name, " must rise, got {", range[0], ", ",
                             range[1], "}: put the lower value first"));
  return {range[0], range[1]};
}

view::Series read_series(lua_State* L, int index, int number, const std::vector<double>& common_x) {
  const Options o(L, index, {"y", "x", "label", "markers", "dashed", "line"}, false, text("[", number, "]"));
  const auto list = [&](const char* key, const char* meaning) {
    return read_numbers(L, o.push_value(key), o.argument(key, meaning), true);
  };
  view::Series series;
  series.y = list("y", "values of the curve");
  if (o.has("x"))
    series.x = list("x", "the curve's own abscissae");
  else
    series.x = common_x;
  if (series.x.size() != series.y.size())
    throw ArgumentError(series.x.empty() ? text(function_name(L), ": ", o.path(),
                                                ".x is missing: give x for the chart or for the curve")
                                         : text(function_name(L), ": ", o.path(), ".y must have as many values as x, ",
                                                series.x.size(), ", got ", series.y.size()));
  series.label = o.string("label", "name in the legend", "");
  series.markers = o.flag("markers", "draw markers", false);
  series.dashed = o.flag("dashed", "draw a dashed line", false);
  series.line = o.flag("line", "draw the line", true);
  if (!series.line && !series.markers)
    throw ArgumentError(text(function_name(L), ": ", o.path(), " shows neither line nor markers: set markers = true"));
  return series;
}

int chart(lua_State* L) {
  const Options o(L, 1, {"file", "x", "xlabel", "ylabel", "log", "title", "legend", "xrange", "yrange", "size"}, true);
  view::ChartOptions options;
  const std::string file = o.string("file", "a name that ends with .png, .svg or .pdf");
  options.title = o.string("title", "line above the chart", "");
  options.xlabel = o.string("xlabel", "label of the x axis", "");
  options.ylabel = o.string("ylabel", "label of the y axis", "");
  options.legend = o.flag("legend", "show the legend", true);
  const std::string log = o.has("log") ? o.choice("log", "logarithmic axes", {"x", "y", "xy"}) : "";
  options.log_x = log == "x" || log == "xy";
  options.log_y = log == "y" || log == "xy";
  if (o.has("xrange")) options.xrange = read_range(L, o, "xrange");
  if (o.has("yrange")) options.yrange = read_range(L, o, "yrange");
  if (o.has("size")) {
    const auto size =
        read_integers(L, o.push_value("size"), o.argument("size", "width and height in pixels"), 100, 10000);
    if (size.size() != 2) reject(L, -1, o.argument("size", "width and height in pixels"), "a list of 2 whole numbers");
    options.size = {size[0], size[1]};
  }

  std::vector<double> x;
  if (o.has("x")) x = read_numbers(L, o.push_value("x"), o.argument("x", "abscissae of the curves"), true);
  std::vector<view::Series> series;
  const int top = lua_gettop(L);
  for (int i = 1; lua_rawgeti(L, 1, i) != LUA_TNIL; ++i) {
    series.push_back(read_series(L, top + 1, i, x));
    lua_settop(L, top);
  }
  if (series.empty())
    throw ArgumentError(text(function_name(L), ": no curve is given: add { y = {…}, label = … } to its arguments"));
  view::draw_chart(series, options, file);
  return 0;
}

constexpr Function rows[] = {
    {"chart", wrap<chart>,
     "sg.chart{ file, x, { y, label, … }, …, xlabel, ylabel, log, title, legend = true }\n"
     "Draws curves to a file that ends with .png, .svg or .pdf. Each curve is a table without a name:\n"
     "  { y = {…}, x = its own abscissae (the chart's x), label = , markers = false, dashed = false, line = true }\n"
     "log = \"x\", \"y\" or \"xy\" for logarithmic axes; xrange, yrange = {low, high}; size = {1600, 1000} pixels.\n"
     "A nan leaves a gap.\n"
     "Example: sg.chart{ file = \"square.png\", x = {1, 2, 3}, { y = {1, 4, 9}, label = \"x squared\" } }"},
};

} // namespace

void open_chart(lua_State* L) {
  register_functions(L, "sg", rows);
}

} // namespace signorini::bind
