#include "terminal/encode.hpp"

#include "base/base64.hpp"
#include "base/text.hpp"

namespace signorini::terminal {
namespace {

constexpr std::size_t chunk = 4096; // largest payload of one of kitty's sequences

} // namespace

std::string kitty_sequences(const std::string& png, int columns, bool around_tmux) {
  const std::string data = base64(png);
  std::string sequences;
  for (std::size_t begin = 0; begin < data.size(); begin += chunk) {
    // q: no answers, C: the cursor stays.
    const std::string first =
        text("a=T,f=100,q=2,", columns > 0 ? text("c=", columns, ",") : "", around_tmux ? "C=1," : "");
    const std::string sequence = text("\033_G", begin == 0 ? first : "", "m=", begin + chunk < data.size() ? 1 : 0, ";",
                                      data.substr(begin, chunk), "\033\\");
    sequences += around_tmux ? passed_through(sequence) : sequence;
  }
  return sequences;
}

std::string iterm_sequence(const std::string& png, int width) {
  return text("\033]1337;File=inline=1;size=", png.size(), ";width=", width, "px:", base64(png), "\a");
}

std::string passed_through(const std::string& sequence) {
  std::string doubled;
  for (const char c : sequence) doubled.append(c == '\033' ? 2 : 1, c);
  return "\033Ptmux;" + doubled + "\033\\";
}

} // namespace signorini::terminal
