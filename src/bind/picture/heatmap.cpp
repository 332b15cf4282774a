#include "view/heatmap.hpp"

#include "bind/lua/number_text.hpp"
#include "bind/lua/open.hpp"
#include "bind/picture/picture.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

namespace signorini::bind {

namespace {

/// The string on top of the stack, or the number there as text.
std::string name_on_top(lua_State* L, bool powers = false) {
  return lua_type(L, -1) == LUA_TNUMBER ? number_text(lua_tonumber(L, -1), powers) : to<std::string>(L, -1);
}

/// Names of columns or rows. If one number needs a power of ten, all large and small ones are written that way.
std::vector<std::string> read_names(const Arguments& a, const char* key) {
  lua_State* L = a.state();
  bool powers = false;
  a.list(key, [&](int, int index, const std::string&) {
    const double size = lua_type(L, index) == LUA_TNUMBER ? std::abs(lua_tonumber(L, index)) : 0;
    powers = powers || size >= 1e6 || (size > 0 && size < 1e-4);
  });
  std::vector<std::string> names;
  a.list(key, [&](int, int, const std::string&) { names.push_back(name_on_top(L, powers)); });
  return names;
}

// ── Categories ───────────────────────────────────────────────────────────────────────────────────────────────────────

/// A category without look yet: its own color, or one of the favorable or unfavorable looks.
struct CategoryEntry {
  std::string name;
  std::optional<bool> good = {};
  std::optional<view::Rgb> color = {};
  std::optional<std::size_t> look = {}; ///< index among the favorable or unfavorable looks
};

/// "#rrggbb".
view::Rgb read_hex(const Arguments& category) {
  const auto hex = category.get<std::string>("color");
  const bool digits =
      std::all_of(hex.begin() + !hex.empty(), hex.end(), [](unsigned char c) { return std::isxdigit(c) != 0; });
  if (hex.size() != 7 || hex[0] != '#' || !digits)
    category.refuse("color", "a color such as \"#d55e00\", or the number of one");
  view::Rgb color;
  for (std::size_t c = 0; c < 3; ++c)
    color[c] = static_cast<std::uint8_t>(std::stoi(hex.substr(1 + 2 * c, 2), nullptr, 16));
  return color;
}

CategoryEntry read_category(lua_State* L, int index, const std::string& path) {
  if (lua_type(L, index) == LUA_TSTRING) return {to<std::string>(L, index)};
  const Arguments category(L, index, path);
  CategoryEntry entry;
  category.read("name", entry.name, "good", entry.good);
  if (category.is("color", LUA_TSTRING))
    entry.color = read_hex(category);
  else if (category.has("color"))
    entry.look = static_cast<std::size_t>(category.get<int>("color") - 1);
  return entry;
}

/// If no category has `good`, the first one is favorable.
std::vector<view::Category> with_looks(std::vector<CategoryEntry> entries) {
  if (std::none_of(entries.begin(), entries.end(), [](const CategoryEntry& one) { return one.good.has_value(); }))
    entries.front().good = true;
  const auto &good = view::good_looks(), &bad = view::bad_looks();
  std::size_t goods = 0, bads = 0;
  std::vector<view::Category> categories;
  for (const CategoryEntry& entry : entries) {
    const bool wanted = entry.good.value_or(false);
    const auto& looks = wanted ? good : bad;
    const std::size_t next = wanted ? goods++ : bads++;
    categories.push_back(
        {entry.name, entry.color ? view::Look{*entry.color} : looks[entry.look.value_or(next) % looks.size()]});
  }
  return categories;
}

std::vector<view::Category> read_categories(const Arguments& a) {
  lua_State* L = a.state();
  if (!a.has("categories")) return {};
  std::vector<CategoryEntry> entries;
  a.list("categories", [&](int, int index, const std::string& path) {
    entries.push_back(read_category(L, index, path));
    const auto same = [&](const CategoryEntry& one) { return one.name == entries.back().name; };
    if (std::find_if(entries.begin(), entries.end(), same) + 1 != entries.end())
      a.fail(path, " has the name '", entries.back().name, "' of an earlier one: name each category once");
  });
  return with_looks(std::move(entries));
}

// ── Cells ────────────────────────────────────────────────────────────────────────────────────────────────────────────

/// Calls read(row, column, path) for each entry of a list of rows, with the entry on top of the stack. Checks the
/// lengths here, because rows may have gaps, which the function's table cannot describe.
template <class Read>
void each_cell(const Arguments& a, const char* key, std::size_t rows, std::size_t columns, Read read) {
  lua_State* L = a.state();
  const std::string expected = text("a list of ", rows, rows == 1 ? " row" : " rows", ", one for each y");
  const int list = a.push(key);
  if (lua_rawlen(L, list) != rows) reject(L, list, {a.name(key)}, expected);
  lua_pop(L, 1);
  a.list(key, [&](int j, int row, const std::string& path) {
    const auto refuse = [&] {
      reject(L, row, {path}, text("a list of ", columns, columns == 1 ? " entry" : " entries", ", one for each x"));
    };
    if (!lua_istable(L, row)) refuse();
    for (lua_pushnil(L); lua_next(L, row); lua_pop(L, 1))
      if (!lua_isinteger(L, -2) || lua_tointeger(L, -2) < 1 || lua_tointeger(L, -2) > static_cast<lua_Integer>(columns))
        refuse();
    for (std::size_t i = 0; i < columns; ++i) {
      lua_rawgeti(L, row, static_cast<lua_Integer>(i) + 1);
      if (!lua_isnil(L, -1)) read(static_cast<std::size_t>(j), i, text(path, "[", i + 1, "]"));
      lua_settop(L, row);
    }
  });
}

constexpr double blank = std::numeric_limits<double>::quiet_NaN();

/// True if nan or infinity is on top of the stack: a gap, as in charts.
bool is_gap(lua_State* L) {
  return lua_type(L, -1) == LUA_TNUMBER && !std::isfinite(lua_tonumber(L, -1));
}

/// The index of the category whose name is on top of the stack.
double read_member(lua_State* L, const std::string& path, const std::vector<view::Category>& categories) {
  if (is_gap(L)) return blank;
  std::vector<std::string> names;
  for (const view::Category& one : categories) names.push_back(one.name);
  if (lua_type(L, -1) != LUA_TSTRING) reject(L, -1, {path}, "the name of a category, nil or nan");
  const auto name = to<std::string>(L, -1);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw ArgumentError(text(function_name(L), ": ", path, " is '", name, "', which is not a category",
                             did_you_mean(name, names), "; known: ", listed(names)));
  return static_cast<double>(found - names.begin());
}

/// The number on top of the stack; nan for a blank cell.
double read_cell(lua_State* L, const std::string& path) {
  if (is_gap(L)) return blank;
  if (lua_type(L, -1) != LUA_TNUMBER)
    reject(L, -1, {path}, "a number, nil or nan",
           lua_type(L, -1) == LUA_TSTRING ? "for names, give categories = { { name = … }, … }" : "");
  return lua_tonumber(L, -1);
}

view::Heat read_map(const Arguments& a, const view::HeatmapOptions& options) {
  lua_State* L = a.state();
  const std::size_t rows = options.y.size(), columns = options.x.size();
  const auto size = [](std::size_t n) { return static_cast<Eigen::Index>(n); };
  view::Heat map{a.get<std::string>("title"), MatrixX::Constant(size(rows), size(columns), blank)};
  each_cell(a, "values", rows, columns, [&](std::size_t j, std::size_t i, const std::string& path) {
    const bool named = !options.categories.empty();
    map.values(size(j), size(i)) = named ? read_member(L, path, options.categories) : read_cell(L, path);
  });
  if (!a.has("texts")) return map;
  map.texts.assign(rows, std::vector<std::string>(columns));
  each_cell(a, "texts", rows, columns, [&](std::size_t j, std::size_t i, const std::string& path) {
    if (is_gap(L)) return;
    if (lua_type(L, -1) != LUA_TNUMBER && lua_type(L, -1) != LUA_TSTRING) reject(L, -1, {path}, "a string or a number");
    map.texts[j][i] = name_on_top(L);
  });
  return map;
}

std::vector<view::Heat> read_maps(const Arguments& a, const view::HeatmapOptions& options) {
  lua_State* L = a.state();
  if (!a.has("panels")) {
    std::vector<view::Heat> one = {read_map(a, options)};
    one[0].title.clear();
    return one;
  }
  std::vector<view::Heat> maps;
  a.list("panels", [&](int, int index, const std::string& path) {
    maps.push_back(read_map(Arguments(L, index, path), options));
  });
  return maps;
}

// ── The figure ───────────────────────────────────────────────────────────────────────────────────────────────────────

int heatmap(lua_State* L) {
  const Arguments a(L);
  view::HeatmapOptions options;
  a.read("title", options.title, "xlabel", options.xlabel, "ylabel", options.ylabel, "label", options.label, "log",
         options.log, "colormap", options.colormap, "range", options.range, "columns", options.columns);
  options.x = read_names(a, "x");
  options.y = read_names(a, "y");
  options.categories = read_categories(a);
  const std::vector<view::Heat> maps = read_maps(a, options);
  // Several maps in as many rows as needed
  options.size = {1600, maps.size() == 1 ? 1000 : maps.size() <= 3 ? 850 : 1400};
  return push_flat(
      L, a, options, text("heat map of ", options.x.size(), " x ", options.y.size(), " cells"),
      [maps](const view::HeatmapOptions& sized) { return view::heatmap_figure(maps, sized); },
      [maps](const view::HeatmapOptions& sized) { return view::heatmap_spots(maps, sized); });
}

} // namespace

void open_heatmap(lua_State* L) {
  register_functions(L, "sg", {{"heatmap", heatmap}});
}

} // namespace signorini::bind
