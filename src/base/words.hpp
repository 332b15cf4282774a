#pragma once
// Values in the words of messages.

#include "base/eigen.hpp"

#include <string>

namespace signorini {

/// "-0.125": six digits.
std::string number(double value);

/// "1 point", "2 points".
std::string counted(std::size_t count, const std::string& noun);

/// "(1.5, -2)"; what is nothing but rounding beside the largest coordinate is 0.
std::string coordinates(const VectorX& point);

} // namespace signorini
