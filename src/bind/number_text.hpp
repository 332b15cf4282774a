#pragma once
// Numbers as texts of pictures show them.

#include <string>

namespace signorini::bind {

/// As %g, with a minus sign in place of the hyphen and powers of ten written as such: −0.5, 10⁶, 2.5×10⁻⁵. `powers`:
/// from 10⁴ on and below 10⁻³ written so, too, where %g would write the digits out.
std::string number_text(double value, bool powers = false);

} // namespace signorini::bind
