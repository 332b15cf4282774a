#pragma once
// The interface of signorini_terminal.so, the only part of the program that is linked with Chafa and libsixel.

#include <string>

namespace signorini::terminal {

/// What the module exports as `signorini_terminal`.
struct CharacterArt {
  std::string (*description)();
  /// A PNG file as sixels of 256 colors, of a size in pixels.
  std::string (*sixels)(const std::string& png, int width, int height);
  /// A PNG file as lines of half blocks, in the colors that the terminal has according to the environment.
  std::string (*blocks)(const std::string& png, int columns, int rows);
};

inline constexpr const char* art_module = "signorini_terminal.so";

} // namespace signorini::terminal
