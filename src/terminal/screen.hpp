#pragma once
// Pictures on the terminal of standard output.

#include "terminal/choice.hpp"

#include <optional>

namespace signorini::terminal {

/// Why pictures cannot be shown.
enum class Obstacle { none, no_terminal, turned_off, dumb, no_library };

/// What the terminal shows, and the size of the largest picture.
struct Screen {
  Obstacle obstacle = Obstacle::none;
  Protocol protocol = Protocol::none;
  bool through_tmux = false; ///< to the terminal around it
  Size cell = {10, 20};      ///< pixels
  Size most = {800, 320};    ///< pixels: the width of the window, two thirds of its height
};

/// The protocol given by --pictures, instead of the one that suits the terminal. Called before screen().
void set_protocol(Protocol protocol);

/// The terminal as it is now. The first call chooses the protocol; for this it may ask the terminal.
Screen screen();

/// Shows a PNG file, with its size in pixels times `scale`, and ends the line. Needs a screen without obstacle.
void show(const Screen& screen, const std::string& png, const Size& size, double scale);

/// Name and version of the library that draws sixels and blocks. Throws Error without it.
std::string art_description();
bool has_art();

} // namespace signorini::terminal
