#pragma once
// Answers of terminals to queries, which arrive between the keys that a user types.

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace signorini::terminal {

/// Width and height, in pixels or cells.
using Size = std::array<int, 2>;

struct Answers {
  bool kitty = false;                         ///< takes pictures by kitty's protocol
  std::optional<std::vector<int>> attributes; ///< primary device attributes: 4 means sixel
  std::optional<Size> cell, area;             ///< pixels of a cell and of the whole window
  std::optional<Size> largest_sixel;          ///< pixels
};

/// The queries. All terminals answer the device attributes, in order, so that what comes before their answer is all
/// that comes.
inline constexpr const char *ask_kitty = "\033_Gi=31,s=1,v=1,a=q,t=d,f=24;AAAA\033\\", *ask_attributes = "\033[c",
                            *ask_pixels = "\033[16t\033[14t",
                            *ask_sixel = "\033[?1;3;256S\033[?2;1;0S"; ///< also asks for 256 colors

/// Moves complete answers from the input to `answers`. Other bytes, which are keys, and an incomplete answer at the end
/// remain.
void take_answers(std::string& input, Answers& answers);

} // namespace signorini::terminal
