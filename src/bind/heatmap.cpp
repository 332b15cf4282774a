#include "view/heatmap.hpp"

#include "bind/functions.hpp"
#include "bind/number_text.hpp"
#include "bind/open.hpp"
#include "bind/options.hpp"
#include "bind/range.hpp"
#include "view/picture.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

namespace signorini::bind {

namespace {

/// A string, or a number as text.
std::string read_name(lua_State* L, int index, const Argument& argument, bool powers = false) {
  if (lua_type(L, index) == LUA_TNUMBER) return number_text(read_number(L, index, argument), powers);
  if (lua_type(L, index) != LUA_TSTRING) reject(L, index, argument, "a string or a number");
  return read_string(L, index, argument);
}

/// Whether %g writes a number of the list as a power of ten: then no 100000 shall stand beside it.
bool has_powers(lua_State* L, int list, int count) {
  bool found = false;
  for (int i = 1; i <= count; ++i) {
    lua_rawgeti(L, list, i);
    const double size = lua_type(L, -1) == LUA_TNUMBER ? std::abs(lua_tonumber(L, -1)) : 0;
    found = found || size >= 1e6 || (size > 0 && size < 1e-4);
    lua_pop(L, 1);
  }
  return found;
}

std::vector<std::string> read_names(lua_State* L, const Options& o, const char* key, const char* meaning) {
  const Argument whole = o.argument(key, meaning);
  const int list = o.push_value(key), count = read_list(L, list, whole, "a list of names or numbers");
  if (count == 0) reject(L, list, whole, "a list of at least one name or number");
  const bool powers = has_powers(L, list, count);
  std::vector<std::string> names;
  for (int i = 1; i <= count; ++i) {
    lua_rawgeti(L, list, i);
    names.push_back(read_name(L, -1, {text(whole.name, "[", i, "]"), meaning}, powers));
    lua_pop(L, 1);
  }
  lua_settop(L, list - 1);
  return names;
}

// ── Categories ───────────────────────────────────────────────────────────────────────────────────────────────────────

/// "#rrggbb", read from a string at a stack index.
view::Rgb read_colour(lua_State* L, int index, const Argument& argument) {
  const std::string hex = lua_type(L, index) == LUA_TSTRING ? lua_tostring(L, index) : "";
  const bool digits = std::all_of(hex.begin() + (hex.empty() ? 0 : 1), hex.end(),
                                  [](unsigned char c) { return std::isxdigit(c) != 0; });
  if (hex.size() != 7 || hex[0] != '#' || !digits)
    reject(L, index, argument, "a colour such as \"#d55e00\", or the number of one");
  view::Rgb colour;
  for (std::size_t c = 0; c < 3; ++c)
    colour[c] = static_cast<std::uint8_t>(std::stoi(hex.substr(1 + 2 * c, 2), nullptr, 16));
  return colour;
}

/// A category before it has got a look: its own colour, or one of the good or the bad ones.
struct Wish {
  std::string name;
  std::optional<bool> good = {};
  std::optional<view::Rgb> colour = {};
  std::optional<std::size_t> look = {}; ///< in the list of the good or the bad ones
};

Wish read_category(lua_State* L, int index, const Argument& entry) {
  if (lua_type(L, index) == LUA_TSTRING) return {read_string(L, index, entry)};
  const Options o(L, index, {"name", "colour", "good"}, false, entry.name);
  Wish wish{o.string("name", "as it stands in values")};
  if (o.has("good")) wish.good = o.flag("good", "an outcome that is wanted");
  if (!o.has("colour")) return wish;
  const int colour = o.push_value("colour");
  const Argument argument = o.argument("colour", "of the category's cells");
  if (lua_type(L, colour) == LUA_TNUMBER)
    wish.look = static_cast<std::size_t>(read_index(L, colour, argument, static_cast<int>(view::bad_looks().size())));
  else
    wish.colour = read_colour(L, colour, argument);
  return wish;
}

/// Where none says whether it is good, the first one is.
std::vector<view::Category> with_looks(std::vector<Wish> wishes) {
  if (std::none_of(wishes.begin(), wishes.end(), [](const Wish& one) { return one.good.has_value(); }))
    wishes.front().good = true;
  const auto &good = view::good_looks(), &bad = view::bad_looks();
  std::size_t goods = 0, bads = 0;
  std::vector<view::Category> categories;
  for (const Wish& wish : wishes) {
    const bool wanted = wish.good.value_or(false);
    const auto& looks = wanted ? good : bad;
    const std::size_t next = wanted ? goods++ : bads++;
    categories.push_back(
        {wish.name, wish.colour ? view::Look{*wish.colour} : looks[wish.look.value_or(next) % looks.size()]});
  }
  return categories;
}

std::vector<view::Category> read_categories(lua_State* L, const Options& o) {
  if (!o.has("categories")) return {};
  const Argument whole = o.argument("categories", "what values may be");
  const int list = o.push_value("categories"), count = read_list(L, list, whole, "a list of categories");
  if (count == 0) reject(L, list, whole, "a list of at least one category", "add one such as { name = \"converged\" }");
  std::vector<Wish> wishes;
  for (int i = 1; i <= count; ++i) {
    lua_rawgeti(L, list, i);
    const Argument entry{text(whole.name, "[", i, "]"), whole.meaning};
    wishes.push_back(read_category(L, lua_gettop(L), entry));
    const auto same = [&](const Wish& one) { return one.name == wishes.back().name; };
    if (std::find_if(wishes.begin(), wishes.end(), same) + 1 != wishes.end())
      throw ArgumentError(text(function_name(L), ": ", entry.name, " has the name '", wishes.back().name,
                               "' of an earlier one: name each category once"));
    lua_settop(L, list);
  }
  lua_settop(L, list - 1);
  return with_looks(std::move(wishes));
}

// ── Cells ────────────────────────────────────────────────────────────────────────────────────────────────────────────

/// Calls read(row, column, argument) for each entry of a list of rows, with the entry on top of the stack; rows may
/// have holes.
template <class Read>
void each_cell(lua_State* L, const Options& o, const char* key, const char* meaning, std::size_t rows,
               std::size_t columns, Read read) {
  const Argument whole = o.argument(key, meaning);
  const int list = o.push_value(key);
  const std::string expected = text("a list of ", rows, rows == 1 ? " row" : " rows", ", one for each y");
  if (read_list(L, list, whole, expected.c_str()) != static_cast<int>(rows)) reject(L, list, whole, expected);
  for (std::size_t j = 0; j < rows; ++j) {
    lua_rawgeti(L, list, static_cast<lua_Integer>(j) + 1);
    const int row = lua_gettop(L);
    const Argument named{text(whole.name, "[", j + 1, "]"), meaning};
    const std::string of = text("a list of ", columns, columns == 1 ? " entry" : " entries", ", one for each x");
    if (!lua_istable(L, row)) reject(L, row, named, of);
    for (lua_pushnil(L); lua_next(L, row); lua_pop(L, 1))
      if (!lua_isinteger(L, -2) || lua_tointeger(L, -2) < 1 || lua_tointeger(L, -2) > static_cast<lua_Integer>(columns))
        reject(L, row, named, of);
    for (std::size_t i = 0; i < columns; ++i) {
      lua_rawgeti(L, row, static_cast<lua_Integer>(i) + 1);
      if (!lua_isnil(L, -1)) read(j, i, Argument{text(named.name, "[", i + 1, "]"), meaning});
      lua_settop(L, row);
    }
    lua_settop(L, list);
  }
  lua_settop(L, list - 1);
}

constexpr double blank = std::numeric_limits<double>::quiet_NaN();

/// Whether nan or infinity is on top of the stack: no value, as in charts.
bool is_gap(lua_State* L) {
  return lua_type(L, -1) == LUA_TNUMBER && !std::isfinite(lua_tonumber(L, -1));
}

/// The number of the category that is named on top of the stack.
double read_member(lua_State* L, const Argument& argument, const std::vector<view::Category>& categories) {
  if (is_gap(L)) return blank;
  std::vector<std::string> names;
  for (const view::Category& one : categories) names.push_back(one.name);
  if (lua_type(L, -1) != LUA_TSTRING) reject(L, -1, argument, "the name of a category, nil or nan");
  const std::string name = lua_tostring(L, -1);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw ArgumentError(text(function_name(L), ": ", argument.name, " is '", name, "', which is no category",
                             did_you_mean(name, names), "; known: ", listed(names)));
  return static_cast<double>(found - names.begin());
}

/// The number on top of the stack; nan for a blank cell.
double read_cell(lua_State* L, const Argument& argument) {
  if (lua_type(L, -1) == LUA_TSTRING)
    reject(L, -1, argument, "a number, nil or nan", "to map names, list them in categories = { { name = … }, … }");
  if (is_gap(L)) return blank;
  return read_number(L, -1, argument, "a number, nil or nan");
}

view::Heat read_map(lua_State* L, const Options& o, const view::HeatmapOptions& options) {
  const std::size_t rows = options.y.size(), columns = options.x.size();
  const auto size = [](std::size_t n) { return static_cast<Eigen::Index>(n); };
  view::Heat map{"", MatrixX::Constant(size(rows), size(columns), blank)};
  each_cell(
      L, o, "values", "rows of cells", rows, columns, [&](std::size_t j, std::size_t i, const Argument& argument) {
        const bool named = !options.categories.empty();
        map.values(size(j), size(i)) = named ? read_member(L, argument, options.categories) : read_cell(L, argument);
      });
  if (!o.has("texts")) return map;
  map.texts.assign(rows, std::vector<std::string>(columns));
  each_cell(L, o, "texts", "what stands in the cells", rows, columns,
            [&](std::size_t j, std::size_t i, const Argument& argument) {
              if (!is_gap(L)) map.texts[j][i] = read_name(L, -1, argument);
            });
  return map;
}

std::vector<view::Heat> read_maps(lua_State* L, const Options& o, const view::HeatmapOptions& options) {
  if (!o.has("panels")) return {read_map(L, o, options)};
  for (const char* key : {"values", "texts"})
    if (o.has(key)) throw ArgumentError(text(function_name(L), ": ", key, " belongs to each of the panels"));
  const Argument whole = o.argument("panels", "maps side by side");
  const int list = o.push_value("panels"), count = read_list(L, list, whole, "a list of maps");
  if (count == 0) reject(L, list, whole, "a list of at least one map", "add one such as { title = …, values = … }");
  std::vector<view::Heat> maps;
  for (int i = 1; i <= count; ++i) {
    lua_rawgeti(L, list, i);
    const Options one(L, -1, {"title", "values", "texts"}, false, text("panels[", i, "]"));
    maps.push_back(read_map(L, one, options));
    maps.back().title = one.string("title", "line above the map", "");
    lua_settop(L, list);
  }
  lua_settop(L, list - 1);
  return maps;
}

// ── The figure ───────────────────────────────────────────────────────────────────────────────────────────────────────

/// 1600 × 1000 pixels; several maps in as many rows as they need.
std::array<int, 2> read_size(lua_State* L, const Options& o, std::size_t maps) {
  if (!o.has("size")) return {1600, maps == 1 ? 1000 : maps <= 3 ? 850 : 1400};
  const Argument argument = o.argument("size", "width and height in pixels");
  const auto size = read_integers(L, o.push_value("size"), argument, 120, 5000);
  if (size.size() != 2) reject(L, -1, argument, "a list of 2 whole numbers");
  return {size[0], size[1]};
}

void read_scale(lua_State* L, const Options& o, view::HeatmapOptions& options) {
  for (const char* key : {"label", "range", "log", "colormap"})
    if (!options.categories.empty() && o.has(key))
      throw ArgumentError(text(function_name(L), ": ", key, " is for maps of numbers, this one has categories"));
  options.label = o.string("label", "title of the colour bar", "");
  options.log = o.flag("log", "colours follow the logarithm", false);
  options.colormap = o.choice("colormap", "colours of the cells", view::colormaps(), options.colormap);
  if (!o.has("range")) return;
  const std::array<double, 2> range = read_range(L, o);
  if (!(range[0] < range[1]))
    throw ArgumentError(
        text(function_name(L), ": range must rise, got {", range[0], ", ", range[1], "}: put the lower value first"));
  options.range = {range[0], range[1]};
}

int heatmap(lua_State* L) {
  const Options o(L, 1,
                  {"file", "x", "y", "values", "texts", "panels", "columns", "categories", "xlabel", "ylabel", "title",
                   "size", "range", "log", "label", "colormap"});
  const std::string file = o.string("file", "a name that ends with .png, .svg or .pdf");
  view::HeatmapOptions options;
  options.title = o.string("title", "line above the map", "");
  options.xlabel = o.string("xlabel", "label of the x axis", "");
  options.ylabel = o.string("ylabel", "label of the y axis", "");
  options.x = read_names(L, o, "x", "names of the columns");
  options.y = read_names(L, o, "y", "names of the rows, from below");
  options.categories = read_categories(L, o);
  read_scale(L, o, options);
  const std::vector<view::Heat> maps = read_maps(L, o, options);
  if (o.has("columns")) options.columns = o.integer("columns", "maps in a row", 1, 100);
  options.size = read_size(L, o, maps.size());
  view::draw_heatmap(maps, options, file);
  return 0;
}

constexpr Function heatmap_entries[] = {
    {"heatmap", heatmap,
     R"(sg.heatmap{ file, x, y, values, texts, categories, xlabel, ylabel, title, label, range, log = false,
            colormap = "viridis", panels, columns, size = {1600, 1000} }
Draws a map of equal coloured cells to a file, whole or not at all: numbers with a colour bar, or names with a legend.
file:         a name that ends with .png, .svg or .pdf.
x, y:         names of the columns and rows, strings or numbers, in order; the first y is at the bottom.
values:       values[j][i] belongs to y[j] and x[i]: a number, or the name of a category; nil, nan and inf are blank.
texts:        rows of short strings or numbers drawn in the cells, left out where they do not fit; by default none.
xlabel, ylabel, title: texts at the axes and above; by default none. Write units into them. u_y, x_{max}, mm^2 and
              10^-3 are lowered and raised in all texts, as in sg.chart.
label, range, log, colormap: for numbers. label: title of the colour bar, with the values' unit (none); range: {low,
              high} of the colours, in that unit (that of the values); log: colours follow the logarithm (false);
              colormap: as in sg.picture ("viridis").
categories:   { { name = "converged" }, { name = "diverged" }, … }: values are these names. A legend shows those that
              occur. Those with good = true (the first one when none says good) are light green and blue, others warm
              and dark, in the order of the list, the first seven of these plain, later ones hatched; all are told
              apart without colour too. colour = "#rrggbb", or the number of a look (1 to 21), sets a category's own.
              By default none.
panels:       { { title, values, texts }, … } draws several maps side by side, in the place of values and texts.
columns:      maps in a row; by default three at most, of four two.
size:         {width, height} in pixels, from 160 x 120 to 5000 x 5000 ({1600, 1000}; of two or three panels {1600,
              850}, of more {1600, 1400}).
Example: sg.heatmap{ file = "map.png", x = {"N2", "N4"}, y = {10, 20}, values = { {0.3, 0.1}, {0.2, 0.05} } }
Example: sg.heatmap{ file = "map.png", x = {"N2", "N4"}, y = {10, 20}, texts = { {"", 12}, {35, 11} },
                     categories = { { name = "converged" }, { name = "diverged" } },
                     values = { {"diverged", "converged"}, {"converged", "converged"} } })"},
};

} // namespace

void open_heatmap(lua_State* L) {
  register_functions(L, "sg", heatmap_entries);
}

} // namespace signorini::bind
