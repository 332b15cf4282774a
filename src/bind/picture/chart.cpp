#include "view/chart.hpp"
#include "view/curves.hpp"

#include "bind/lua/open.hpp"
#include "bind/picture/picture.hpp"

#include <algorithm>

namespace signorini::bind {

namespace {

/// The index of a name in a list, or the size of the list.
int place_of(const std::string& name, const std::vector<std::string>& names) {
  return static_cast<int>(std::find(names.begin(), names.end(), name) - names.begin());
}

/// One name per point, as indices into the chart's list, to which new names are added unless the user has given it.
std::vector<int> read_kinds(const Arguments& chart, const Arguments& curve, std::vector<std::string>& known) {
  std::vector<int> kinds;
  for (const auto& name : curve.get<std::vector<std::string>>("marks")) {
    const int place = place_of(name, known);
    if (place == std::ssize(known)) {
      if (chart.has("marks"))
        chart.fail(curve.name("marks"), "[", kinds.size() + 1, "] is '", name, "', which is not in the chart's marks",
                   did_you_mean(name, known), "; known: ", listed(known));
      known.push_back(name);
    }
    kinds.push_back(place);
  }
  return kinds;
}

/// The curve on top of the stack; `chart`: the arguments of its chart.
view::Series read_series(lua_State* L, const Arguments& chart, int number, const std::vector<double>& common_x,
                         std::vector<std::string>& kinds) {
  const Arguments curve(L, -1, text("[", number, "]"));
  const auto fail = [&](const char* key, const auto&... parts) { chart.fail(curve.name(key), parts...); };
  view::Series series;
  series.y = curve.get<std::vector<double>>("y");
  series.x = curve.get("x", common_x);
  if (series.x.empty() && !series.y.empty()) fail("x", " is missing: give x for the chart or for the curve");
  curve.read("error", series.error, "label", series.label, "markers", series.markers, "dashed", series.dashed, "arrows",
             series.arrows, "line", series.line, "width", series.width);
  for (const auto& [key, values] : {std::pair("y", &series.y), std::pair("error", &series.error)})
    if (values->size() != series.x.size() && curve.has(key))
      fail(key, " must have as many values as x, ", series.x.size(), ", got ", values->size());
  if (curve.has("color")) series.color = curve.is("color", LUA_TSTRING) ? view::gray : curve.get<int>("color") - 1;
  if (curve.has("marker")) {
    const auto name = curve.get<std::string>("marker");
    series.marker = name == "none" ? view::no_marker : place_of(name, view::marker_names());
  }
  if (curve.has("marks")) {
    series.marks = read_kinds(chart, curve, kinds);
    if (series.marks.size() != series.y.size())
      fail("marks", " must have as many names as the curve has points, ", series.y.size(), ", got ",
           series.marks.size());
  }
  if (series.arrows && !series.line) fail("arrows", " need a line, but line = false");
  const bool marked = series.markers.value_or(false) && series.marker != view::no_marker;
  if (!series.line && series.marks.empty() && !marked)
    fail("line", " = false without markers shows nothing: set markers = true");
  return series;
}

/// The number of the color of the discretization that a label begins with, or -1: the same one in all charts.
int discretization_color(const std::string& label) {
  const std::vector<std::string> known = {"N2", "N2-N2.2", "N2-N2.1", "N3", "N4", "N2-N4", "L1", "L2"};
  const int place = place_of(label.substr(0, label.find_first_of(" ,:")), known);
  return place < std::ssize(known) ? place : -1;
}

/// Numbers for the looks of curves without a color of their own: those that are named by a discretization get its
/// color, further names of it the next dashes; other curves get the colors that are left.
void color_by_discretization(std::vector<view::Series>& series) {
  const int colors = static_cast<int>(view::curve_colors().size());
  std::vector<std::vector<std::string>> names(colors);
  for (view::Series& s : series) {
    const int color = s.color ? -1 : discretization_color(s.label);
    if (color < 0) continue;
    const int dash = place_of(s.label, names[color]);
    if (dash == std::ssize(names[color])) names[color].push_back(s.label);
    s.color = color + colors * dash;
  }
  const auto taken = [&](int number) { return !names[number % colors].empty(); };
  const auto count = std::count_if(names.begin(), names.end(), [](const auto& list) { return !list.empty(); });
  if (count == 0 || count == colors) return;
  int next = 0;
  for (view::Series& s : series) {
    if (s.color) continue;
    while (taken(next)) ++next;
    s.color = next++;
  }
}

/// A list of {position, text}, {position} and positions.
std::vector<view::Name> read_places(const Arguments& a, const char* key) {
  lua_State* L = a.state();
  std::vector<view::Name> places;
  if (!a.has(key)) return places;
  a.list(key, [&](int, int index, const std::string&) {
    if (lua_type(L, index) == LUA_TNUMBER) {
      places.push_back({to<double>(L, index), ""});
    } else {
      lua_rawgeti(L, index, 1);
      lua_rawgeti(L, index, 2);
      places.push_back({to<double>(L, -2), to<std::string>(L, -1)});
    }
  });
  return places;
}

view::Inset read_inset(const Arguments& a) {
  view::Inset inset;
  a.read("xrange", inset.xrange, "yrange", inset.yrange);
  if (a.has("place"))
    inset.place =
        choice<view::Corner>(a.get<std::string>("place"), {"north-east", "north-west", "south-east", "south-west"});
  return inset;
}

/// true, false, or a position.
view::LegendPlace read_legend(const Arguments& a) {
  using enum view::LegendPlace;
  if (a.is("legend", LUA_TSTRING))
    return choice<view::LegendPlace>(a.get<std::string>("legend"), {"none", "automatic", "inside", "outside"});
  return a.get<bool>("legend") ? automatic : none;
}

int chart(lua_State* L) {
  const Arguments a(L);
  view::ChartOptions options;
  a.read("title", options.title, "xlabel", options.xlabel, "ylabel", options.ylabel, "xrange", options.xrange, "yrange",
         options.yrange, "legend_title", options.legend_title, "marks_title", options.marks_title, "marks",
         options.marks);
  options.legend = read_legend(a);
  for (std::size_t i = 0; i < options.marks.size(); ++i)
    if (place_of(options.marks[i], options.marks) < static_cast<int>(i))
      a.fail("marks[", i + 1, "] is '", options.marks[i], "' again: name each kind of points once");
  const auto log = a.get<std::string>("log");
  options.log_x = log == "x" || log == "xy";
  options.log_y = log == "y" || log == "xy";
  options.xticks = read_places(a, "xticks");
  options.hlines = read_places(a, "hlines");
  options.vlines = read_places(a, "vlines");
  if (a.has("inset")) options.inset = read_inset(a.table("inset"));
  const auto x = a.get<std::vector<double>>("x");
  std::vector<view::Series> series;
  for (lua_Unsigned i = 1; i <= lua_rawlen(L, 1); ++i) {
    lua_rawgeti(L, 1, static_cast<lua_Integer>(i));
    series.push_back(read_series(L, a, static_cast<int>(i), x, options.marks));
    lua_pop(L, 1);
  }
  color_by_discretization(series);
  if (series.empty()) a.fail("at least one curve is needed, got none: add { y = {…}, label = … }");
  const std::string curves = text(series.size(), series.size() == 1 ? " curve" : " curves");
  return push_flat(
      L, a, options, text("chart of ", curves),
      [series](const view::ChartOptions& sized) { return view::chart_figure(series, sized); },
      [series](const view::ChartOptions& sized) { return view::chart_spots(series, sized); });
}

} // namespace

void open_chart(lua_State* L) {
  register_functions(L, "sg", {{"chart", chart}});
}

} // namespace signorini::bind
