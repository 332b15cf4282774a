#pragma once
// How messages say where things lie.

#include <cmath>
#include <sstream>
#include <string>

namespace signorini::view {

/// "x = 0.25 … 2", four digits each.
inline std::string extent_text(const char* axis, double low, double high) {
  std::ostringstream out;
  out.precision(4);
  // Rounding errors about zero are no extent.
  const double least = 1e-9 * (high - low);
  out << axis << " = " << (std::abs(low) < least ? 0 : low) << " … " << (std::abs(high) < least ? 0 : high);
  return out.str();
}

} // namespace signorini::view
