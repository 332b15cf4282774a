#include "terminal/screen.hpp"

#include "base/error.hpp"
#include "os/module.hpp"
#include "os/process.hpp"
#include "terminal/character_art.hpp"
#include "terminal/dialogue.hpp"
#include "terminal/encode.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sys/ioctl.h>
#include <unistd.h>

namespace signorini::terminal {
namespace {

std::optional<Protocol> wanted;

const CharacterArt& art() {
  static const CharacterArt& loaded = []() -> const CharacterArt& {
    const std::filesystem::path file = find_module(art_module);
    const auto [first, second] = module_folders();
    require(!file.empty(), "terminal.art.missing",
            {{"module", art_module}, {"first", first.string()}, {"second", second.string()}});
    return *static_cast<const CharacterArt*>(load_module(file, "signorini_terminal"));
  }();
  return loaded;
}

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

/// The terminal around tmux, or "" if tmux does not tell.
std::string outer_terminal() {
  try {
    std::string line = run_program({"tmux", "display-message", "-p", tmux_format});
    if (line.ends_with('\n')) line.pop_back();
    return line;
  } catch (const Error&) {
    return "";
  }
}

winsize window() {
  winsize size{};
  ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size);
  if (size.ws_col == 0 || size.ws_row == 0) size.ws_col = 80, size.ws_row = 24;
  return size;
}

/// What does not change.
struct Terminal {
  Choice choice;
  Answers answers;
};

Terminal find_terminal() {
  Surroundings at{variable, {}};
  const bool dumb = variable("TERM").empty() || variable("TERM") == "dumb";
  if (in_tmux(at) && !dumb) at.outer = outer_terminal();
  // tmux would pass answers of the terminal around it on as keys: that one is known by name only.
  const std::string kitty = wanted || in_tmux(at) ? "" : ask_kitty;
  const std::string pixels = window().ws_xpixel == 0 && wanted != Protocol::blocks ? ask_pixels : "";
  const bool asks = can_ask() && !dumb && variable("TERM") != "linux"; // Linux' console would print the queries
  const bool unknown = !wanted || wanted == Protocol::sixel || !pixels.empty();
  if (asks && unknown) ask(kitty + pixels, at.answers);
  const Choice choice = choose(at, wanted);
  if (asks && choice.protocol == Protocol::sixel && !choice.through_tmux) ask(ask_sixel, at.answers);
  return {choice, at.answers};
}

const Terminal& found_terminal() {
  static const Terminal terminal = find_terminal();
  return terminal;
}

Size cell_of(const winsize& window, const Answers& answers) {
  if (window.ws_xpixel > 0 && window.ws_ypixel > 0)
    return {std::max(1, window.ws_xpixel / window.ws_col), std::max(1, window.ws_ypixel / window.ws_row)};
  if (answers.cell) return *answers.cell;
  if (answers.area)
    return {std::max(1, (*answers.area)[0] / window.ws_col), std::max(1, (*answers.area)[1] / window.ws_row)};
  return {10, 20};
}

int scaled(int pixels, double scale) {
  return std::max(1, static_cast<int>(std::lround(scale * pixels)));
}

} // namespace

void set_protocol(Protocol protocol) {
  wanted = protocol;
}

Screen screen() {
  if (::isatty(STDOUT_FILENO) != 1) return {Obstacle::no_terminal};
  if (wanted == Protocol::none) return {Obstacle::turned_off};
  const Terminal& terminal = found_terminal();
  const auto [protocol, through_tmux] = terminal.choice;
  if (protocol == Protocol::none) return {Obstacle::dumb};
  if ((protocol == Protocol::sixel || protocol == Protocol::blocks) && !has_art()) return {Obstacle::no_library};
  Screen screen{Obstacle::none, protocol, through_tmux};
  const winsize now = window();
  screen.cell = cell_of(now, terminal.answers);
  // The last column stays free: some terminals break the line behind it.
  screen.most = {std::max(1, now.ws_col - 1) * screen.cell[0], std::max(1, 2 * now.ws_row / 3) * screen.cell[1]};
  if (const auto& largest = terminal.answers.largest_sixel; largest && protocol == Protocol::sixel)
    screen.most = {std::min(screen.most[0], (*largest)[0]), std::min(screen.most[1], (*largest)[1])};
  return screen;
}

void show(const Screen& screen, const std::string& png, const Size& size, double scale) {
  const Size shown = {scaled(size[0], scale), scaled(size[1], scale)};
  const auto cells = [&](int side) {
    return std::max(1, static_cast<int>(std::lround(1.0 * shown[side] / screen.cell[side])));
  };
  std::string picture;
  switch (screen.protocol) {
  case Protocol::kitty:
    picture = kitty_sequences(png, scale < 1 ? cells(0) : 0, screen.through_tmux);
    break;
  case Protocol::iterm:
    picture = iterm_sequence(png, shown[0]);
    break;
  case Protocol::sixel:
    picture = art().sixels(png, shown[0], shown[1]);
    break;
  case Protocol::blocks:
    picture = art().blocks(png, cells(0), cells(1));
    break;
  case Protocol::none:
    return;
  }
  if (!screen.through_tmux) return put(picture + "\n");
  // tmux does not know of the picture: it gets empty lines, and the cursor of the outer terminal is put back. tmux
  // moves that cursor to the first of these lines before it answers.
  const int rows = (shown[1] + screen.cell[1] - 1) / screen.cell[1];
  put(std::string(static_cast<std::size_t>(rows), '\n') + text("\033[", rows, "A"));
  if (Answers ignored; can_ask()) ask("", ignored);
  const bool whole = screen.protocol == Protocol::kitty; // passed through in parts already
  put((whole ? picture : passed_through("\0337" + picture + "\0338")) + text("\033[", rows, "B"));
}

std::string art_description() {
  return art().description();
}

bool has_art() {
  return !find_module(art_module).empty();
}

} // namespace signorini::terminal
