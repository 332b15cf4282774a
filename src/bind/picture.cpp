#include "base/whole_file.hpp"
#include "bind/open.hpp"
#include "bind/picture_pages.hpp"
#include "bind/range.hpp"
#include "bind/state_frame.hpp"
#include "view/close_up.hpp"
#include "view/series.hpp"
#include "view/sheet.hpp"
#include "view/side_by_side.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

namespace signorini::bind {

namespace {

const std::vector<std::string> picture_keys = {
    "fields", "states", "frames",      "columns", "file",  "fps",    "title", "label", "range", "colormap",
    "size",   "scale",  "transparent", "crop",    "inset", "camera", "unit",  "ruler", "bar"};

std::vector<std::string> joined(std::vector<std::string> keys, const std::vector<std::string>& more) {
  keys.insert(keys.end(), more.begin(), more.end());
  return keys;
}

int frame(lua_State* L) {
  const Options o(L, 1, joined(state_keys, {"title"}));
  StateFrame state = read_state(L, o, {read_field(o)}, [](bool) { return std::vector<Window>(); }).front();
  state.set_title(o.string("title", "line above this state", ""));
  push_object(L, std::move(state));
  return 1;
}

int frame_tostring(lua_State* L) {
  const StateFrame& state = self<StateFrame>(L);
  const std::string &title = state.title(), &label = state.label;
  push(L, text("frame", title.empty() ? "" : " '" + title + "'", " of ", state.bodies(),
               state.bodies() == 1 ? " body" : " bodies", label.empty() ? "" : ", coloured by " + label));
  return 1;
}

// ── A picture ────────────────────────────────────────────────────────────────────────────────────────────────────────

constexpr int largest_size = 5000; // OpenGL's limit after supersampling

/// A pair is the picture's size. A number is the most it may be wide, and half of the most it may be high. Nothing
/// stands for 1600 × 1000 at most, for sheets 1600 × 2000.
void read_size(lua_State* L, const Options& o, view::PictureOptions& options) {
  options.trim = true;
  if (o.has("frames") || o.has("states") || o.has("fields")) options.size = {1600, 2000};
  if (!o.has("size")) return;
  const Argument argument = o.argument("size", "width and height in pixels, or the greatest width");
  const int value = o.push_value("size");
  if (lua_type(L, value) == LUA_TNUMBER) {
    const int width = read_integer(L, value, argument, 160, largest_size);
    options.size = {width, std::min(2 * width, largest_size)};
    return;
  }
  const auto size = read_integers(L, value, argument, 120, largest_size);
  if (size.size() != 2) reject(L, value, argument, "a whole number or a list of 2 whole numbers");
  options.size = {size[0], size[1]};
  options.trim = false;
}

/// Everything larger or smaller, text as well.
void read_scale(lua_State* L, const Options& o, view::PictureOptions& options) {
  const double scale = o.positive("scale", "multiplies the size, of text as well", 1.0);
  for (int& side : options.size) {
    const double scaled = std::round(scale * side);
    if (scaled < 120 || scaled > largest_size)
      throw ArgumentError(text(function_name(L), ": scale = ", scale, " makes ", scaled, " pixels of ", side,
                               "; a picture may have from 120 to ", largest_size, " each way"));
    side = static_cast<int>(scaled);
  }
}

/// The frames of a sheet: of one field and one dimension.
std::vector<StateFrame> read_frames(lua_State* L, const Options& o) {
  for (const std::string& key : joined(state_keys, {"fields", "states"}))
    if (o.has(key.c_str()))
      throw ArgumentError(
          text(function_name(L), ": ", key, " belongs to each of the frames: give it to sg.frame{ … }"));
  const Argument argument = o.argument("frames", "made by sg.frame");
  const int list = o.push_value("frames"), count = read_list(L, list, argument, "a list of frames");
  if (count == 0) reject(L, list, argument, "a list of at least one frame", "add one made by sg.frame{ … }");
  std::vector<StateFrame> frames;
  for (int i = 1; i <= count; ++i) {
    lua_rawgeti(L, list, i);
    const StateFrame& state = read_object<StateFrame>(L, -1, {text("frames[", i, "]"), argument.meaning});
    frames.push_back(state);
    const std::string& label = frames.front().label;
    if (state.label != label && !o.has("label"))
      throw ArgumentError(text(function_name(L), ": frames[", i, "] shows '", state.label, "' and frames[1] '", label,
                               "': one colour bar serves all frames, give them one field, or name the bar by label"));
    if (state.solid() != frames.front().solid())
      throw ArgumentError(text(function_name(L), ": frames[", i, "] shows a ", state.solid() ? "solid" : "plane",
                               " model and frames[1] does not; draw them in pictures of their own"));
    lua_pop(L, 1);
  }
  return frames;
}

/// A name, or { from = …, up = … }; by default the face of a cut with this normal is seen.
view::Camera read_camera(lua_State* L, const Options& o, const std::optional<Vec<3>>& cut) {
  constexpr const char* meaning = "where the picture is seen from";
  if (!o.has("camera")) return cut ? view::turned_to(view::camera("iso"), *cut) : view::camera("iso");
  const int value = o.push_value("camera"), type = lua_type(L, value);
  if (type == LUA_TSTRING) return view::camera(o.choice("camera", meaning, view::camera_names()));
  if (type != LUA_TTABLE)
    reject(L, value, o.argument("camera", meaning),
           text(one_of(view::camera_names()), ", or a table { from = …, up = … }"));
  const Options c = o.table("camera", {"from", "up"});
  const Vec<3> from = c.point("from", "direction from the model to the eye", 3, 3);
  if (from.norm() == 0)
    reject(L, c.push_value("from"), c.argument("from", "direction from the model to the eye"),
           "a vector that is not zero");
  const bool steep = from.head<2>().norm() < 1e-6 * from.norm();
  const Vec<3> otherwise = steep ? Vec<3>::UnitY() : Vec<3>::UnitZ();
  return {from, c.point("up", "direction that points upwards in the picture", 3, 3, VectorX(otherwise))};
}

/// What of a picture is read the same way for all models.
void read_options(lua_State* L, const Options& o, view::PictureOptions& options) {
  options.title = o.string("title", "line above the picture", "");
  options.colormap = o.choice("colormap", "colours of the field", view::colormaps(), options.colormap);
  read_size(L, o, options);
  read_scale(L, o, options);
  options.transparent = o.flag("transparent", "no white ground", false);
  options.bar = o.flag("bar", "the colour bar", true);
  options.unit = o.string("unit", "of lengths, behind the axes' names", "");
  if (o.has("range")) {
    const std::array<double, 2> range = read_range(L, o);
    options.range = {range[0], range[1]};
  }
}

std::vector<double> read_box(lua_State* L, const Options& o, const char* key, const char* meaning, std::size_t count) {
  const std::vector<double> box = o.numbers(key, meaning);
  if (box.size() != count)
    reject(L, o.push_value(key), o.argument(key, meaning), text("a list of ", count, " numbers"));
  for (std::size_t i = 0; i < count; i += 2)
    if (!(box[i] < box[i + 1])) {
      std::string numbers = text(box[0]);
      for (std::size_t n = 1; n < count; ++n) numbers += text(", ", box[n]);
      throw ArgumentError(
          text(function_name(L), ": ", key, " is {", numbers, "}; expected {", meaning, "} with min below max"));
    }
  return box;
}

/// The options with the part of the model that `key` names, or none.
std::optional<view::SolidOptions> read_region(lua_State* L, const Options& o, const char* key,
                                              view::SolidOptions options) {
  if (!o.has(key)) return std::nullopt;
  const std::vector<double> box = read_box(L, o, key, "xmin, xmax, ymin, ymax, zmin, zmax", 6);
  options.region = view::Bounds{{box[0], box[2], box[4]}, {box[1], box[3], box[5]}};
  return options;
}

std::optional<view::PictureOptions> read_region(lua_State* L, const Options& o, const char* key,
                                                view::PictureOptions options) {
  if (!o.has(key)) return std::nullopt;
  const std::vector<double> box = read_box(L, o, key, "xmin, xmax, ymin, ymax", 4);
  options.crop = {box[0], box[1], box[2], box[3]};
  return options;
}

/// What one picture shows: by field, the states in their order.
using Sheets = std::vector<std::vector<StateFrame>>;

/// The parts that a picture of this many pixels shows alone, or magnifies.
std::vector<Window> read_windows(lua_State* L, const Options& o, const std::array<int, 2>& size, bool solid) {
  std::vector<Window> windows;
  for (const char* key : {"crop", "inset"}) {
    if (solid) {
      const auto part = read_region(L, o, key, view::SolidOptions{});
      if (!part) continue;
      const auto cut = read_cut(L, o);
      const Mat<3> axes = view::picture_axes(read_camera(L, o, cut ? std::optional(cut->normal) : std::nullopt));
      windows.push_back(box_window(axes.topRows<2>(), part->region->low, part->region->high, size));
    } else if (const auto part = read_region(L, o, key, view::PictureOptions{})) {
      const auto [left, right, bottom, top] = *part->crop;
      windows.push_back(box_window(Mat<3>::Identity().topRows<2>(), {left, bottom, 0}, {right, top, 0}, size));
    }
  }
  return windows;
}

Sheets read_sheets(lua_State* L, const Options& o, const std::array<int, 2>& size) {
  if (o.has("frames")) return {read_frames(L, o)};
  const ReadWindows windows = [&](bool solid) { return read_windows(L, o, size, solid); };
  const std::vector<std::string> fields = read_fields(L, o);
  if (o.has("states")) return read_states(L, o, fields, windows);
  Sheets sheets;
  for (StateFrame& state : read_state(L, o, fields, windows)) sheets.push_back({std::move(state)});
  return sheets;
}

/// Where insets go, by the size of the picture.
using Plans = std::map<std::array<int, 2>, view::CloseUpPlan>;

/// The states of a field with the options that they are drawn with.
template <class Panel, class PanelOptions> struct FieldSheet {
  std::vector<std::vector<Panel>> pictures; ///< one, or those of a series
  PanelOptions options;
  std::optional<PanelOptions> inset;                        ///< of what is magnified
  std::shared_ptr<Plans> plans = std::make_shared<Plans>(); ///< made once for a series
};

/// A picture of a field, drawn with these options.
template <class Panel, class PanelOptions>
view::Figure figure_of(const FieldSheet<Panel, PanelOptions>& sheet, int picture, const PanelOptions& options) {
  const auto panels = [&](int of) -> const std::vector<Panel>& { return sheet.pictures[static_cast<std::size_t>(of)]; };
  if (!sheet.inset) return view::figure_of(view::make_plate(panels(picture), options));
  const auto whole = [&](int of, const std::optional<view::Box>& extent) {
    PanelOptions larger = options;
    if (extent) larger.extent = extent;
    return view::make_plate(panels(of), larger);
  };
  const auto detail = [&](int of, int state, const std::array<int, 2>& most) {
    PanelOptions own = *sheet.inset;
    own.size = most;
    own.style = view::close_up_style(view::style_of(options));
    std::vector<Panel> one = {panels(of)[static_cast<std::size_t>(state)]};
    one[0].title.clear();
    return view::make_plate(one, own);
  };
  auto plan = sheet.plans->find(options.size);
  if (plan == sheet.plans->end()) {
    const int pictures = static_cast<int>(sheet.pictures.size());
    plan = sheet.plans->emplace(options.size, view::plan_close_ups(pictures, whole, detail)).first;
  }
  return view::with_close_ups(picture, plan->second, whole, detail);
}

/// A whole picture: the sheets of several fields side by side.
template <class Panel, class PanelOptions>
view::Figure figure_of(const std::vector<FieldSheet<Panel, PanelOptions>>& sheets, int picture) {
  const PanelOptions& first = sheets[0].options;
  if (sheets.size() == 1) return figure_of(sheets[0], picture, first);
  const bool single = sheets[0].pictures[0].size() == 1; // then the columns are those of the fields
  view::PictureOptions whole = first;
  if (!single) whole.columns.reset();
  const auto part = [&](int i, const std::array<int, 2>& most) {
    PanelOptions options = sheets[static_cast<std::size_t>(i)].options;
    options.title.clear();
    options.size = most;
    options.trim = true;
    options.style = view::part_style(most, view::style_of(first));
    if (single) options.columns.reset();
    return figure_of(sheets[static_cast<std::size_t>(i)], picture, options);
  };
  return view::side_by_side(static_cast<int>(sheets.size()), whole, part);
}

/// One meaning of colours in all states, and in a series one frame. `beside`: there are other sheets.
template <class Panel, class PanelOptions>
void align_states(FieldSheet<Panel, PanelOptions>& sheet, const std::vector<Panel>& states, bool series, bool beside) {
  if (!series && !sheet.inset && !beside) return;
  const auto extent = sheet.options.extent;
  align(sheet.options, states);
  if (!series) sheet.options.extent = extent;
  if (!sheet.inset) return;
  sheet.inset->range = sheet.options.range;
  sheet.inset->bar = false;
  sheet.inset->axis_names = false;
  sheet.inset->ruler = false;
  sheet.inset->trim = true;
  sheet.inset->title.clear();
}

/// Refuses parts and cuts that show or take nothing.
template <class Panel, class PanelOptions>
void check_shown(const std::vector<Panel>& states, const PanelOptions& options,
                 const std::optional<PanelOptions>& inset) {
  check_part(states, options, "crop");
  if (inset) check_part(states, *inset, "inset");
  if constexpr (std::is_same_v<Panel, view::SolidPanel>) check_cuts(states);
}

template <class Panel, class PanelOptions>
void draw(const Sheets& sheets, const PanelOptions& options, const std::optional<PanelOptions>& inset,
          const std::string& file, double rate) {
  const bool series = view::is_series(file);
  std::vector<FieldSheet<Panel, PanelOptions>> all;
  for (const auto& states : sheets) {
    auto& sheet = all.emplace_back(FieldSheet<Panel, PanelOptions>{{}, options, inset});
    if (options.field_label.empty()) sheet.options.field_label = states.front().label;
    std::vector<Panel> panels;
    for (const StateFrame& state : states) panels.push_back(std::get<Panel>(state.panel));
    check_shown(panels, options, inset);
    align_states(sheet, panels, series, sheets.size() > 1);
    if (!series)
      sheet.pictures = {std::move(panels)};
    else
      for (Panel& panel : panels) sheet.pictures.push_back({std::move(panel)});
  }
  // One layout for all: the largest colour bar decides.
  for (auto& sheet : all)
    for (const auto& beside : all)
      if (beside.options.range && all.size() > 1)
        sheet.options.bars_beside.push_back({*beside.options.range, beside.options.field_label});
  const view::Format format = series ? view::series_format(file) : view::format_of(file);
  const auto bytes = [&](int i) { return view::bytes_of(figure_of(all, i), format, options.transparent); };
  if (series) return view::write_series(file, static_cast<int>(sheets[0].size()), rate, bytes);
  write_whole(file, bytes(0));
}

void check_ending(const std::string& file, bool series) {
  try {
    if (series)
      view::series_format(file);
    else
      view::format_of(file);
  } catch (const Error& error) {
    fail(error.what(), "; several states may also make a series, \"x-%04d.png\", or a film, .mp4 or .ogv");
  }
}

/// Refuses what has no meaning without something else.
void check_company(lua_State* L, const Options& o, const std::string& file) {
  const bool series = view::is_series(file), many = o.has("frames") || o.has("states");
  const auto refuse = [&](const auto&... words) { throw ArgumentError(text(function_name(L), ": ", words...)); };
  check_ending(file, series);
  if (series && !many)
    refuse("file '", file, "' is for several states and names a series: give it states = run:states(), or frames");
  if (o.has("columns") && !many && !o.has("fields"))
    refuse("columns needs frames = {…}, made by sg.frame, or states, or fields");
  if (o.has("columns") && series) refuse("columns has no meaning for a series, whose pictures show one state each");
  if (o.has("fps") && !series) refuse("fps is of a film, file = \"x.mp4\" or \"x.ogv\"; this is one picture");
  if (o.flag("transparent", "no white ground", false) && view::is_film(file))
    refuse("transparent has no meaning for a film: draw a series of pictures, file = \"x-%04d.png\"");
  for (const char* key : {"states", "fields"})
    if (o.has("patch") && o.has(key)) refuse(key, " is for models, and patch draws a shape that is none yet");
  if (o.has("label") && o.has("fields")) refuse("label names one colour bar, but each of fields has its own");
}

int picture(lua_State* L) {
  const Options o(L, 1, joined(state_keys, picture_keys));
  const std::string file =
      o.string("file", "a name that ends with .png, .svg or .pdf, or \"x-%04d.png\", .mp4 or .ogv for a series");
  check_company(L, o, file);
  view::SolidOptions options;
  read_options(L, o, options);
  const double rate = o.positive("fps", "pictures per second of a film", 10.0);
  if (o.has("columns")) options.columns = o.integer("columns", "pictures in a row", 1, 100);
  const Sheets sheets = read_sheets(L, o, options.size);
  const StateFrame& first = sheets.front().front();
  if (o.has("label")) {
    if (first.label.empty())
      throw ArgumentError(text(function_name(L), ": label names a colour bar, but no field is drawn: add field"));
    options.field_label = o.string("label", "title of the colour bar");
  }
  if (first.solid()) {
    const auto& cut = std::get<view::SolidPanel>(first.panel).cut;
    options.ruler = o.flag("ruler", "a length below the picture", true);
    options.camera = read_camera(L, o, cut ? std::optional(cut->normal) : std::nullopt);
    const auto whole = read_region(L, o, "crop", options).value_or(options);
    draw<view::SolidPanel>(sheets, whole, read_region(L, o, "inset", options), file, rate);
  } else {
    for (const char* key : {"camera", "ruler"})
      if (o.has(key))
        throw ArgumentError(text(function_name(L), ": ", key, " is for models of solids, this one is plane"));
    const view::PictureOptions& plane = options;
    const auto whole = read_region(L, o, "crop", plane).value_or(plane);
    draw<view::Panel>(sheets, whole, read_region(L, o, "inset", plane), file, rate);
  }
  return 0;
}

constexpr Function picture_entries[] = {{"picture", picture, picture_page}, {"frame", frame, frame_page}};

constexpr Function frame_rows[] = {
    {"__tostring", frame_tostring,
     "frame\nWhat sg.frame returns, a state kept for sg.picture{ frames = {…} }; print(frame) tells its title and "
     "field."},
};

} // namespace

void open_picture(lua_State* L) {
  register_functions(L, "sg", picture_entries);
  register_type<StateFrame>(L, frame_rows);
}

} // namespace signorini::bind
