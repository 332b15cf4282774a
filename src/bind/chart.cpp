#include "view/chart.hpp"

#include "bind/contact_profile.hpp"
#include "bind/functions.hpp"
#include "bind/open.hpp"
#include "bind/options.hpp"

#include <algorithm>

namespace signorini::bind {

namespace {

constexpr const char* corners[] = {"north-east", "north-west", "south-east", "south-west"};

std::array<double, 2> read_range(lua_State* L, const Options& o, const char* key) {
  const VectorX range = o.point(key, "lowest and highest value", 2, 2);
  if (!(range[0] < range[1]))
    throw ArgumentError(text(function_name(L), ": ", o.argument(key).name, " must rise, got {", range[0], ", ",
                             range[1], "}: put the lower value first"));
  return {range[0], range[1]};
}

/// The number of the curve that it looks like, or gray.
int read_colour(const Options& o, lua_State* L) {
  const int value = o.push_value("color");
  const Argument argument = o.argument("color", "number of the curve that it looks like");
  if (lua_type(L, value) != LUA_TSTRING) return o.integer("color", argument.meaning, 1) - 1;
  if (read_string(L, value, argument) != "gray") reject(L, value, argument, "the number of a curve, or \"gray\"");
  return view::gray;
}

/// One name per point, as numbers in the chart's list, which grows by new names unless the user has given it.
std::vector<int> read_marks(lua_State* L, const Options& o, std::vector<std::string>& names, bool given) {
  std::vector<int> marks;
  const Argument whole = o.argument("marks", "what each point is");
  const int list = o.push_value("marks"), count = read_list(L, list, whole, "a list of one name per point");
  for (int i = 1; i <= count; ++i) {
    lua_rawgeti(L, list, i);
    const Argument entry{text(whole.name, "[", i, "]"), whole.meaning};
    const std::string name = read_string(L, -1, entry);
    auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end() && given)
      throw ArgumentError(text(function_name(L), ": ", entry.name, " is '", name,
                               "', which the chart's marks do not list", did_you_mean(name, names),
                               "; known: ", listed(names)));
    if (found == names.end()) found = names.insert(names.end(), name);
    marks.push_back(static_cast<int>(found - names.begin()));
    lua_pop(L, 1);
  }
  return marks;
}

/// A marker's number, or no_marker for "none".
int read_marker(const Options& o) {
  std::vector<std::string> names = view::marker_names();
  names.emplace_back("none");
  const std::string name = o.choice("marker", "shape of the markers", names);
  const auto found = std::find(names.begin(), names.end(), name);
  return found + 1 == names.end() ? view::no_marker : static_cast<int>(found - names.begin());
}

view::Series read_series(lua_State* L, int index, int number, const std::vector<double>& common_x,
                         std::vector<std::string>& marks, bool marks_given) {
  if (is_profile(L, index))
    throw ArgumentError(text(function_name(L), ": [", number,
                             "] must be a curve, got a contact profile: write { x = "
                             "profile.x, y = profile.pressure } or which of its lists it shall be"));
  const Options o(L, index,
                  {"y", "x", "label", "markers", "dashed", "arrows", "line", "color", "width", "marker", "marks"},
                  false, text("[", number, "]"));
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
  if (o.has("markers")) series.markers = o.flag("markers", "draw markers");
  series.dashed = o.flag("dashed", "draw a dashed line", false);
  series.arrows = o.flag("arrows", "on the line, in the order of its points", false);
  series.line = o.flag("line", "draw the line", true);
  series.width = o.positive("width", "of the line, in pixels of a chart of 1600 x 1000", series.width);
  if (o.has("color")) series.colour = read_colour(o, L);
  if (o.has("marker")) series.marker = read_marker(o);
  if (o.has("marks")) series.marks = read_marks(L, o, marks, marks_given);
  if (o.has("marks") && series.marks.size() != series.y.size())
    throw ArgumentError(text(function_name(L), ": ", o.path(),
                             ".marks must have as many names as the curve has points, ", series.y.size(), ", got ",
                             series.marks.size()));
  if (series.arrows && !series.line)
    throw ArgumentError(
        text(function_name(L), ": ", o.path(), ".arrows stand on the line, which line = false takes away"));
  if (!series.line && series.marks.empty() && (!series.markers.value_or(false) || series.marker == view::no_marker))
    throw ArgumentError(text(function_name(L), ": ", o.path(), " shows neither line nor markers: set markers = true"));
  return series;
}

/// A list of {position, text}; where the text may be missing, plain numbers too.
std::vector<view::Name> read_names(lua_State* L, const Options& o, const char* key, const char* meaning,
                                   bool text_needed) {
  std::vector<view::Name> names;
  if (!o.has(key)) return names;
  const Argument whole = o.argument(key, meaning);
  const int table = o.push_value(key), count = read_list(L, table, whole);
  for (int i = 1; i <= count; ++i) {
    const Argument entry{text(whole.name, "[", i, "]"), meaning};
    if (lua_rawgeti(L, table, i) == LUA_TNUMBER && !text_needed) {
      names.push_back({read_number(L, -1, entry), ""});
    } else {
      const int pair = lua_gettop(L), length = read_list(L, pair, entry, "a pair {position, text}");
      if (length != 2 && (text_needed || length != 1)) reject(L, pair, entry, "a pair {position, text}");
      lua_rawgeti(L, pair, 1);
      view::Name name{read_number(L, -1, {text(entry.name, "[1]"), "position on the axis"}), ""};
      lua_rawgeti(L, pair, 2);
      if (length == 2) name.text = read_string(L, -1, {text(entry.name, "[2]"), "text"});
      names.push_back(std::move(name));
    }
    lua_settop(L, table);
  }
  lua_settop(L, table - 1);
  return names;
}

view::Inset read_inset(lua_State* L, const Options& chart) {
  const Options o = chart.table("inset", {"xrange", "yrange", "place"});
  view::Inset inset{read_range(L, o, "xrange")};
  if (o.has("yrange")) inset.yrange = read_range(L, o, "yrange");
  if (o.has("place")) {
    const std::string place = o.choice("place", "corner of the chart", {std::begin(corners), std::end(corners)});
    inset.place = static_cast<view::Corner>(std::find(std::begin(corners), std::end(corners), place) - corners);
  }
  return inset;
}

/// The kinds of points in the order of their markers, each once.
std::vector<std::string> read_mark_names(lua_State* L, const Options& o) {
  const Argument whole = o.argument("marks", "names of kinds of points");
  const int list = o.push_value("marks"), count = read_list(L, list, whole, "a list of names");
  std::vector<std::string> names;
  for (int i = 1; i <= count; ++i) {
    lua_rawgeti(L, list, i);
    const Argument entry{text(whole.name, "[", i, "]"), whole.meaning};
    names.push_back(read_string(L, -1, entry));
    if (std::find(names.begin(), names.end(), names.back()) + 1 != names.end())
      throw ArgumentError(text(function_name(L), ": ", entry.name, " is '", names.back(),
                               "' once more: name each kind of points once"));
    lua_pop(L, 1);
  }
  lua_settop(L, list - 1);
  return names;
}

int chart(lua_State* L) {
  const Options o(L, 1,
                  {"file", "x", "xlabel", "ylabel", "log", "title", "legend", "xrange", "yrange", "xticks", "hlines",
                   "vlines", "inset", "size", "legend_title", "marks", "marks_title"},
                  true);
  view::ChartOptions options;
  const std::string file = o.string("file", "a name that ends with .png, .svg or .pdf");
  options.title = o.string("title", "line above the chart", "");
  options.xlabel = o.string("xlabel", "label of the x axis", "");
  options.ylabel = o.string("ylabel", "label of the y axis", "");
  options.legend = o.flag("legend", "show the legend", true);
  options.legend_title = o.string("legend_title", "line above the curves' names", "");
  options.marks_title = o.string("marks_title", "line above the names of points", "");
  if (o.has("marks")) options.marks = read_mark_names(L, o);
  const std::string log = o.has("log") ? o.choice("log", "logarithmic axes", {"x", "y", "xy"}) : "";
  options.log_x = log == "x" || log == "xy";
  options.log_y = log == "y" || log == "xy";
  if (o.has("xrange")) options.xrange = read_range(L, o, "xrange");
  if (o.has("yrange")) options.yrange = read_range(L, o, "yrange");
  options.xticks = read_names(L, o, "xticks", "names on the x axis", true);
  options.hlines = read_names(L, o, "hlines", "horizontal reference lines", false);
  options.vlines = read_names(L, o, "vlines", "vertical reference lines", false);
  if (o.has("inset")) options.inset = read_inset(L, o);
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
    series.push_back(read_series(L, top + 1, i, x, options.marks, o.has("marks")));
    lua_settop(L, top);
  }
  if (series.empty())
    throw ArgumentError(text(function_name(L), ": no curve is given: add { y = {…}, label = … } to its arguments"));
  view::draw_chart(series, options, file);
  return 0;
}

constexpr Function chart_entries[] = {
    {"chart", chart,
     R"(sg.chart{ file, x, { y, x, label, line = true, width = 3, dashed = false, arrows = false, markers,
          marker, marks, color }, …, xlabel, ylabel, log, title, legend = true, legend_title, marks, marks_title, xrange, yrange,
          xticks, hlines, vlines, inset, size = {1600, 1000} }
Draws curves to a file, whole or not at all. Values, ranges and positions are in the units of the data.
file:         a name that ends with .png, .svg or .pdf.
x:            abscissae of the curves that have none of their own.
xlabel, ylabel, title: texts at the axes and above; by default none. Write units into them: "force in N". In all texts
              u_y, x_{max}, mm^2 and 10^-3 are lowered and raised; \\_ and \\^ are the signs themselves.
log:          "x", "y" or "xy": logarithmic axes; by default none.
xrange, yrange: {low, high} of an axis; by default those of the data, of y within xrange.
xticks:       { {1, "m1"}, {2, "m2"} }, in rising order: names in the place of numbers; by default numbers.
hlines, vlines: { value, {value, text}, … }: dotted reference lines; by default none.
legend:       the curves' names right of the chart, or below it where they are long or many (true).
legend_title, marks_title: lines above its two parts, curves and kinds of points; by default none.
marks:        the order of the kinds of points; by default that of their first points.
inset:        { xrange = {low, high}, yrange = {low, high} (that of the curves), place = "north-east", "north-west",
              "south-east" or "south-west" (the emptiest corner) } magnifies a part of the chart in a box; where no
              corner is free the y axis goes on, unless yrange is given. By default none.
size:         {width, height} in pixels, from 160 x 120 to 5000 x 5000 ({1600, 1000}).
Each curve is a table without a name:
 y:           values; nan and inf leave a gap. A point between gaps has a marker.
 x:           as many abscissae (the chart's x).
 label:       its name in the legend, where curves of one label and look share a row; one without has none.
 line:        draws the line (true).
 width:       of the line, in pixels of a chart of 1600 x 1000 (3).
 dashed:      a dashed line (false).
 arrows:      heads on the line, in the order of its points: which way a hysteresis runs (false).
 markers:     a marker at each point, or false for none; by default a few on each of several curves, none on one.
 marker:      circle, square, triangle, diamond, triangle down, cross, pentagon, plus, the same open ("open circle"),
              or "none"; by default that of the curve's number.
 marks:       { "m1", "m2", … }, the kind of each of its points, such as the mesh: one marker per kind in all curves;
              the legend lists them after the curves. By default none.
 color:       the number of the curve that it looks like, or "gray"; by default its own look: 40 curves are told
              apart by colour and dashes, and a warning tells of more.
Example: sg.chart{ file = "square.png", x = {1, 2, 3}, { y = {1, 4, 9}, label = "x squared" } })"},
};

} // namespace

void open_chart(lua_State* L) {
  register_functions(L, "sg", chart_entries);
}

} // namespace signorini::bind
