#pragma once
// Numbers as text in pictures.

#include <string>

namespace signorini::bind {

/// As %g, with a minus sign instead of the hyphen and powers of ten: −0.5, 10⁶, 2.5×10⁻⁵. `powers`: also from 10⁴ on
/// and below 10⁻³, where %g would write all digits.
std::string number_text(double value, bool powers = false);

} // namespace signorini::bind
