#include "bind/picture/picture.hpp"

#include "bind/lua/open.hpp"
#include "bind/lua/wording/wording.hpp"
#include "bind/picture/state_picture.hpp"
#include "os/whole_file.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::bind {

namespace {

constexpr int largest_size = 5000; // pixels per side

/// Reads size and background of a separate picture; default size: `most`.
void read_paper(const Arguments& a, Picture& picture, const std::array<int, 2>& most) {
  picture.size = most;
  if (a.has("size")) {
    picture.trim = a.is("size", LUA_TNUMBER);
    if (picture.trim) {
      const int width = a.get<int>("size");
      picture.size = {width, std::min(2 * width, largest_size)};
    } else {
      picture.size = a.get<std::array<int, 2>>("size");
    }
  }
  const double scale = a.get<double>("scale");
  for (int& side : picture.size) {
    const double scaled = std::round(scale * side);
    if (scaled < 120 || scaled > largest_size)
      a.fail("scale = ", scale, " makes ", scaled, " pixels of ", side, "; a picture may have from 120 to ",
             largest_size, " each way");
    side = static_cast<int>(scaled);
  }
  picture.transparent = a.get<bool>("transparent");
}

/// A picture with the size and background of a paper.
Picture on_paper(const Picture& paper, Picture picture) {
  picture.size = paper.size, picture.trim = paper.trim, picture.transparent = paper.transparent;
  return picture;
}

void write_picture(const Picture& picture, const std::string& file) {
  const view::Format format = view::format_of(file);
  check_output(file, view::kind_of(format)); // before it is drawn
  write_output(file, view::bytes_of(figure::figures_of({picture})(0), format, picture.transparent),
               view::kind_of(format));
}

/// Writes a series of files, or a film.
void write_film(const std::vector<Picture>& pictures, const std::string& file, double rate) {
  require(!view::is_film(file) || !pictures[0].transparent,
          "transparent is not available for films: draw a series of pictures, file = \"x-%04d.png\"");
  const view::Format format = view::series_format(file);
  const auto figures = figure::figures_of(pictures);
  std::optional<std::array<int, 2>> size;
  view::write_series(file, static_cast<int>(pictures.size()), rate, [&](int i) {
    const view::Figure figure = figures(i);
    if (!size) size = figure.size;
    require(figure.size == *size, "picture ", i + 1, " has ", figure.size[0], " × ", figure.size[1],
            " pixels and the first one ", (*size)[0], " × ", (*size)[1],
            ": use the same size {width, height} for all pictures of a film");
    return view::bytes_of(figure, format, pictures[0].transparent);
  });
}

/// Checks a file name before drawing.
void check_ending(const std::string& file, bool may_be_series) {
  try {
    if (view::is_series(file))
      view::series_format(file);
    else if (!file.empty())
      view::format_of(file);
  } catch (const Error& error) {
    fail(worded(error), may_be_series ? "; for several states also a series, \"x-%04d.png\", or a film, .mp4" : "");
  }
  require(may_be_series || !view::is_series(file), "file '", file,
          "' names a series of several pictures: draw one with sg.film, or with states = run:states() in sg.picture");
}

Picture make_sheet(SheetPicture sheet) {
  const std::size_t count = sheet.parts.size();
  const std::string title = sheet.title.empty() ? "" : " '" + sheet.title + "'";
  return figure::make_picture(std::move(sheet),
                              text("sheet", title, " of ", count, count == 1 ? " picture" : " pictures"));
}

// ── sg.picture ───────────────────────────────────────────────────────────────────────────────────────────────────────

/// The title of an entry of run:states().
std::string title_of(lua_State* L, int state) {
  lua_getfield(L, state, "title");
  auto title = to<std::string>(L, -1);
  lua_pop(L, 1);
  return title;
}

/// A picture of each field in each state: one sheet per field, or a series with all fields in each picture.
int picture_of_many(lua_State* L, const Arguments& a, const std::string& file) {
  const auto fields = a.has("fields") ? a.get<std::vector<std::string>>("fields")
                                      : std::vector<std::string>{a.get<std::string>("field")};
  Picture paper;
  read_paper(a, paper, {1600, 2000});
  std::vector<std::vector<Picture>> by_state;
  const auto add_state = [&](int state, const std::string& title) {
    auto& pictures = by_state.emplace_back();
    for (const auto& field : fields) pictures.push_back(read_state_picture(a, field, state, title, paper.size));
  };
  if (a.has("states"))
    a.list("states", [&](int, int index, const std::string&) { add_state(index, title_of(L, index)); });
  else
    add_state(0, "");

  const auto title = a.get<std::string>("title");
  std::optional<int> columns;
  a.read("columns", columns);
  if (view::is_series(file)) {
    if (columns) a.fail("columns is not available for a series, whose pictures show one state each: omit it");
    std::vector<Picture> film;
    for (const auto& pictures : by_state) film.push_back(on_paper(paper, make_sheet({pictures, title})));
    write_film(film, file, a.get<double>("fps"));
    return 0;
  }
  if (!a.has("states")) return push_picture(L, on_paper(paper, make_sheet({by_state[0], title, columns})), file);
  std::vector<Picture> sheets;
  for (std::size_t f = 0; f < fields.size(); ++f) {
    std::vector<Picture> states;
    for (const auto& pictures : by_state) states.push_back(pictures[f]);
    sheets.push_back(make_sheet({std::move(states), fields.size() == 1 ? title : "", columns}));
  }
  return push_picture(L, on_paper(paper, fields.size() == 1 ? sheets[0] : make_sheet({std::move(sheets), title})),
                      file);
}

int picture(lua_State* L) {
  const Arguments a(L);
  const auto file = a.get<std::string>("file");
  check_ending(file, a.has("states"));
  if (a.has("states") || a.has("fields")) return picture_of_many(L, a, file);
  Picture paper;
  read_paper(a, paper, {1600, 1000});
  const int state = a.has("state") ? a.push("state") : 0;
  const auto title = a.get<std::string>("title", state != 0 ? title_of(L, state) : "");
  return push_picture(L, on_paper(paper, read_state_picture(a, a.get<std::string>("field"), state, title, paper.size)),
                      file);
}

// ── Several pictures ─────────────────────────────────────────────────────────────────────────────────────────────────

/// The unnamed entries: pictures, or lists of them.
std::vector<Picture> read_pictures(lua_State* L) {
  std::vector<Picture> pictures;
  const std::function<void(int)> add = [&](int index) {
    if (const Picture* one = test_object<Picture>(L, index)) {
      pictures.push_back(*one);
      return;
    }
    luaL_checktype(L, index, LUA_TTABLE);
    luaL_checkstack(L, 8, "nested lists");
    for (lua_Unsigned i = 1; i <= lua_rawlen(L, index); ++i) {
      lua_rawgeti(L, index, static_cast<lua_Integer>(i));
      add(lua_gettop(L));
      lua_pop(L, 1);
    }
  };
  add(1);
  if (pictures.empty())
    throw ArgumentError(text(function_name(L), ": at least one picture is needed, got an empty list"));
  return pictures;
}

int sheet(lua_State* L) {
  const Arguments a(L);
  const auto file = a.get<std::string>("file");
  check_ending(file, false);
  SheetPicture content{read_pictures(L), a.get<std::string>("title")};
  a.read("columns", content.columns);
  if (a.is("range", LUA_TSTRING))
    content.own_ranges = a.get<std::string>("range") == "own";
  else
    a.read("range", content.range);
  Picture whole = make_sheet(std::move(content));
  read_paper(a, whole, {1600, 2000});
  return push_picture(L, std::move(whole), file);
}

int film(lua_State* L) {
  const Arguments a(L);
  const auto file = a.get<std::string>("file");
  if (!view::is_series(file))
    a.refuse("file", "the name of a film, such as \"x.mp4\", or of a series, such as \"x-%04d.png\"");
  check_ending(file, true);
  std::vector<Picture> pictures = read_pictures(L);
  Picture& first = pictures[0];
  const bool transparent = first.transparent;
  if (a.has("size") || a.get<double>("scale") != 1) read_paper(a, first, first.size);
  first.transparent = a.get<bool>("transparent") || transparent;
  write_film(pictures, file, a.get<double>("fps"));
  return 0;
}

void write_method(const Picture& picture, const std::string& file) {
  check_ending(file, false);
  write_picture(picture, file);
}

/// The picture at `index`, made to fit into the size {width, height} in pixels at `most` with its own ratio of sides;
/// nil for its own size.
Picture read_sized(lua_State* L, int index, int most) {
  luaL_checkany(L, index);
  const Picture* given = test_object<Picture>(L, index);
  require(given, "a picture is expected, got ", describe(L, index));
  if (lua_isnoneornil(L, most)) return *given;
  const auto size = to<std::array<int, 2>>(L, most);
  for (const int side : size) require(side >= 1 && side <= largest_size, "a size in pixels is expected, got ", side);
  return figure::fitted(*given, size);
}

/// core.picture_bytes(picture, format, most): the bytes of a file, format "png", "svg" or "pdf". most: {width, height}
/// in pixels, into which the picture is laid out with its own ratio of sides; nil for its own size.
int picture_bytes(lua_State* L) {
  const Picture picture = read_sized(L, 1, 3);
  const view::Format format = view::format_of(text("picture.", to<std::string>(L, 2)));
  push(L, view::bytes_of(figure::figures_of({picture})(0), format, picture.transparent));
  return 1;
}

/// core.picture_spots(picture, most): where a chart or a heat map of this size shows its points or cells: a list of {
/// x, y, width, height, values = {{name, value}, …} } with the center in pixels from the top left corner. nil for other
/// pictures.
int picture_spots(lua_State* L) {
  const Picture picture = read_sized(L, 1, 2);
  const auto* flat = std::get_if<FlatPicture>(picture.content.get());
  if (!flat) return 0;
  push_list(L, flat->spots(picture.size), [&](const view::Spot& spot) {
    const auto& [left, right, bottom, top] = spot.box;
    push_fields(L, "x", 0.5 * (left + right), "y", picture.size[1] - 0.5 * (bottom + top), "width", right - left,
                "height", top - bottom);
    push_list(L, spot.values, [&](const auto& pair) { push(L, std::vector<std::string>(pair.begin(), pair.end())); });
    lua_setfield(L, -2, "values");
  });
  return 1;
}

/// core.picture_file(picture): the file in which it was written when it was made, or nil.
std::optional<std::string> picture_file(const Picture& picture) {
  return picture.file.empty() ? std::nullopt : std::optional(picture.file);
}

} // namespace

int push_picture(lua_State* L, Picture picture, const std::string& file) {
  Picture& pushed = push_object(L, std::move(picture));
  if (!file.empty()) write_picture(pushed, file);
  pushed.file = file;
  return 1;
}

void open_picture(lua_State* L) {
  register_functions(L, "sg", {{"picture", picture}, {"sheet", sheet}, {"film", film}});
  register_functions(
      L, "core",
      {{"picture_bytes", picture_bytes}, {"picture_file", call<picture_file>}, {"picture_spots", picture_spots}});
  register_type<Picture>(L, {{"write", call<write_method>},
                             {"__tostring", call<[](const Picture& picture) { return picture.description; }>}});
}

} // namespace signorini::bind
