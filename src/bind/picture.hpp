#pragma once
// Pictures as values: what each of them shows and how it is drawn, free of models, so that several make one figure or a
// film.

#include "bind/functions.hpp"
#include "view/picture.hpp"
#include "view/series.hpp"

#include <functional>
#include <map>
#include <optional>
#include <variant>

namespace signorini::bind {

/// A state of a model, or patches.
struct StatePicture {
  view::Panel panel;
  view::PictureOptions options;              ///< `title` above the state
  std::optional<view::PictureOptions> inset; ///< of the part that is magnified
};

struct Picture;

/// Pictures side by side.
struct SheetPicture {
  std::vector<Picture> parts;
  std::string title;
  std::optional<int> columns = {};
  bool own_ranges = false;                         ///< else parts of one label have one range of colors
  std::optional<std::array<double, 2>> range = {}; ///< of all parts
};

/// A chart or a heat map, which fits itself to a size in pixels.
struct FlatPicture {
  std::function<view::Figure(const std::array<int, 2>& size)> make;
};

/// What Lua holds: a picture of any kind, and how large it is alone.
struct Picture {
  std::shared_ptr<const std::variant<StatePicture, SheetPicture, FlatPicture>> content;
  std::array<int, 2> size = {1600, 1000};
  bool trim = true; ///< `size` is the most
  bool transparent = false;
  std::string description; ///< "picture of 1 body", for print
};

template <> struct Type<Picture> { static constexpr auto name = "picture"; };

template <class Content> Picture make_picture(Content content, std::string description) {
  Picture picture;
  picture.content = std::make_shared<const std::variant<StatePicture, SheetPicture, FlatPicture>>(std::move(content));
  picture.description = std::move(description);
  return picture;
}

/// Makes the figures of pictures by number (from 0). Those of a film have the size of the first one, one range of
/// colors for each field, and so that nothing jumps one scale and one layout. Throws Error where they are not made
/// alike.
std::function<view::Figure(int picture)> figures_of(const std::vector<Picture>& film);

/// Pushes a picture for the caller, and writes it where the arguments of its function name a file: the last lines of
/// every function that makes one.
int push_picture(lua_State* L, Picture picture, const std::string& file);

/// The same of a chart or a heat map, which draw(options) makes for a size in pixels; `size` and `file` are read.
template <class Options, class Draw>
int push_flat(lua_State* L, const Arguments& a, Options options, const std::string& description, Draw draw) {
  a.read("size", options.size);
  const auto make = [options, draw](const std::array<int, 2>& pixels) {
    Options sized = options;
    sized.size = pixels;
    return draw(sized);
  };
  Picture picture = make_picture(FlatPicture{make}, description);
  picture.size = options.size;
  return push_picture(L, std::move(picture), a.get<std::string>("file"));
}

} // namespace signorini::bind
