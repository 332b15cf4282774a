#pragma once
// Values in the words of messages.

#include "base/eigen.hpp"

#include <string>

namespace signorini {

/// "(1.5, -2)", with six digits.
std::string coordinates(const VectorX& point);

} // namespace signorini
