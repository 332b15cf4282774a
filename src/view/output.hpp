#pragma once
// Files that are written whole or not at all, and the forms a drawing can take.

#include "view/drawing.hpp"

#include <string>
#include <string_view>

namespace signorini::view {

/// Puts the bytes into a temporary file beside `file`, then renames it. Throws Error when the folder does not exist or
/// the file cannot be written.
void write_whole(const std::string& file, std::string_view bytes);

/// The ending of a file's name in lower case, with its dot.
std::string file_ending(const std::string& file);

/// SVG with text as text.
std::string svg(const Drawing& drawing);

/// A PDF of one page without dates, set in the viewer's Helvetica and Symbol. Throws Error on a character that neither
/// font has.
std::string pdf(const Drawing& drawing);

} // namespace signorini::view
