#pragma once
// Pictures in Lua (figure/picture.hpp).

#include "bind/lua/arguments.hpp"
#include "bind/lua/functions.hpp"
#include "figure/picture.hpp"

namespace signorini::bind {

using figure::FlatPicture;
using figure::Picture;
using figure::SheetPicture;
using figure::StatePicture;

template <> struct Type<Picture> { static constexpr auto name = "picture"; };

/// Pushes a picture, and writes it if the arguments name a file: called at the end of every function that makes one.
int push_picture(lua_State* L, Picture picture, const std::string& file);

/// Likewise a chart or a heat map, drawn by draw(options) for a size in pixels, with data points or cells at
/// spots(options); reads `size` and `file`.
template <class Options, class Draw, class Spots>
int push_flat(lua_State* L, const Arguments& a, Options options, const std::string& description, Draw draw,
              Spots spots) {
  a.read("size", options.size);
  const auto sized = [options](const std::array<int, 2>& pixels) {
    Options changed = options;
    changed.size = pixels;
    return changed;
  };
  Picture picture =
      figure::make_picture(FlatPicture{[=](const std::array<int, 2>& pixels) { return draw(sized(pixels)); },
                                       [=](const std::array<int, 2>& pixels) { return spots(sized(pixels)); }},
                           description);
  picture.size = options.size;
  return push_picture(L, std::move(picture), a.get<std::string>("file"));
}

} // namespace signorini::bind
