#include "terminal/screen.hpp"

#include "base/error.hpp"
#include "bind/lua/open.hpp"
#include "bind/picture/picture.hpp"

#include <algorithm>

namespace signorini::bind {

namespace {

constexpr std::array<int, 2> readable = {400, 250}; ///< pixels: smallest layout with legible text

/// core.screen_obstacle(): why pictures cannot be shown, "no_terminal", "turned_off", "dumb" or "no_library", or nil if
/// they can.
int screen_obstacle(lua_State* L) {
  constexpr const char* names[] = {nullptr, "no_terminal", "turned_off", "dumb", "no_library"};
  push(L, names[static_cast<int>(terminal::screen().obstacle)]);
  return 1;
}

/// A picture laid out for a size, its PNG file, and its size there.
struct Drawn {
  std::string png;
  std::array<int, 2> size;
};

Drawn drawn(const Picture& picture) {
  const view::Figure figure = figure::figures_of({picture})(0);
  return {view::bytes_of(figure, view::Format::png, picture.transparent), figure.size};
}

/// The picture laid out within a size: with its own ratio of sides if its size is exact, else as its contents need.
Picture laid_out(const Picture& picture, const std::array<int, 2>& most) {
  Picture fit = figure::fitted(picture, most);
  if (picture.trim) fit.size = most;
  return fit;
}

/// core.show_picture(picture): shows it on the terminal, no larger than its own size. In a small window it is laid out
/// larger, so that text and data have space, and scaled down.
int show_picture(lua_State* L) {
  const auto& picture = read_object<Picture>(L, 1);
  const terminal::Screen screen = terminal::screen();
  const std::array<int, 2> most = {std::min(screen.most[0], picture.size[0]),
                                   std::min(screen.most[1], picture.size[1])};
  // Few pixels per half block, so that lines are not blurred.
  const double least = screen.protocol == terminal::Protocol::blocks ? 0.5 : 1;
  double larger = std::max(least, std::min(1.0 * readable[0] / most[0], 1.0 * readable[1] / most[1]));
  const auto of_window = [&] {
    return laid_out(picture, {static_cast<int>(larger * most[0]), static_cast<int>(larger * most[1])});
  };
  const auto [width, height] = of_window().size;
  larger *= std::max({1.0, 1.0 * figure::smallest_size[0] / width, 1.0 * figure::smallest_size[1] / height});
  const auto show = [&](const Drawn& of) {
    const double scale = std::min({1 / least, 1.0 * most[0] / of.size[0], 1.0 * most[1] / of.size[1]});
    terminal::show(screen, of.png, of.size, scale);
  };
  std::optional<Drawn> small;
  try {
    small = drawn(of_window());
  } catch (const Error&) { // not enough space for its parts
  }
  show(small ? *small : drawn(picture));
  return 0;
}

} // namespace

void open_screen(lua_State* L) {
  register_functions(L, "core", {{"screen_obstacle", screen_obstacle}, {"show_picture", show_picture}});
}

} // namespace signorini::bind
