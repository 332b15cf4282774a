#pragma once
// What pictures refuse.

#include "view/solid_picture.hpp"

namespace signorini::view {

/// Throws Error on arrays that do not fit together or are not finite.
void check(const std::vector<Panel>& panels);
void check(const std::vector<SolidPanel>& panels);

/// Throws Error unless the box's lower corner lies below its higher one; `argument` names it.
void check_region(const Box& region, const std::string& argument);
void check_region(const Bounds& region, const std::string& argument);

} // namespace signorini::view
