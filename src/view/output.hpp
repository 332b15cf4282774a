#pragma once
// The forms of a file that a drawing can take.

#include "view/drawing.hpp"

#include <string>

namespace signorini::view {

/// The ending of a file's name in lower case, with its dot.
std::string file_ending(const std::string& file);

/// SVG with text as text.
std::string svg(const Drawing& drawing);

/// A PDF of one page without dates, set in the viewer's Helvetica and Symbol. Characters that neither has become boxes,
/// with a warning.
std::string pdf(const Drawing& drawing);

} // namespace signorini::view
