#pragma once
// Pictures as values, independent of models: contents and options, which can be combined in a figure or a film.

#include "view/picture.hpp"
#include "view/series.hpp"
#include "view/spot.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <variant>

namespace signorini::figure {

/// A state of a model, or patches.
struct StatePicture {
  view::Panel panel;
  view::PictureOptions options;              ///< `title`: above the state
  std::optional<view::PictureOptions> inset; ///< of the magnified part
};

struct Picture;

/// Pictures side by side.
struct SheetPicture {
  std::vector<Picture> parts;
  std::string title;
  std::optional<int> columns = {};
  bool own_ranges = false;                         ///< otherwise parts with the same label share a color range
  std::optional<std::array<double, 2>> range = {}; ///< of all parts
};

/// A chart or a heat map, which is laid out for any size in pixels.
struct FlatPicture {
  std::function<view::Figure(const std::array<int, 2>& size)> make;
  std::function<std::vector<view::Spot>(const std::array<int, 2>& size)> spots;
};

/// A picture of any kind, and its size when drawn alone.
struct Picture {
  std::shared_ptr<const std::variant<StatePicture, SheetPicture, FlatPicture>> content;
  std::array<int, 2> size = {1600, 1000};
  bool trim = true; ///< `size` is the maximum
  bool transparent = false;
  std::string description; ///< "picture of 1 body", for print
  std::string file = "";   ///< in which it was written when it was made
};

template <class Content> Picture make_picture(Content content, std::string description) {
  Picture picture;
  picture.content = std::make_shared<const std::variant<StatePicture, SheetPicture, FlatPicture>>(std::move(content));
  picture.description = std::move(description);
  return picture;
}

/// Returns the figures of pictures by number (from 0). The pictures of a film have the size of the first one and one
/// color range per field, scale and layout. Throws Error when they differ in structure.
std::function<view::Figure(int picture)> figures_of(const std::vector<Picture>& film);

/// Smallest size in pixels.
inline constexpr std::array<int, 2> smallest_size = {160, 120};

/// The picture made to fit into a size in pixels, with its own ratio of sides.
Picture fitted(const Picture& picture, const std::array<int, 2>& most);

} // namespace signorini::figure
