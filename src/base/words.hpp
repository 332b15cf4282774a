#pragma once
// Formatting of values in messages.

#include "base/eigen.hpp"

#include <string>

namespace signorini {

/// "-0.125": six significant digits.
std::string number(double value);

/// "1 point", "2 points".
std::string counted(std::size_t count, const std::string& noun);

/// "(1.5, -2)"; coordinates that are only rounding error of the largest one are printed as 0.
std::string coordinates(const VectorX& point);

} // namespace signorini
