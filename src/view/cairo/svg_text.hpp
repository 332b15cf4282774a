#pragma once
// What Cairo's SVG lacks: texts that can be found and selected.

#include "view/figure.hpp"

namespace signorini::view {

/// Cairo draws texts as outlines, which look the same everywhere. This adds the texts themselves, unseen, in their
/// places, and numbers the parts within the file: Cairo counts them through the whole process.
std::string searchable(const std::string& svg, const Figure& figure);

} // namespace signorini::view
