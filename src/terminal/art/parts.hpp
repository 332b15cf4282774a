#pragma once
// The parts of signorini_terminal.so.

#include <string>

namespace signorini::terminal {

/// By libsixel; see CharacterArt.
std::string sixels(const std::string& png, int width, int height);

} // namespace signorini::terminal
