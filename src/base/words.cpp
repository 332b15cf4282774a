#include "base/words.hpp"

#include <sstream>

namespace signorini {

std::string number(double value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

std::string coordinates(const VectorX& point) {
  constexpr double rounding = 1e-12;
  const double least = rounding * point.cwiseAbs().maxCoeff();
  std::string words;
  for (const double value : point) words += (words.empty() ? "(" : ", ") + number(std::abs(value) <= least ? 0 : value);
  return words + ")";
}

std::string counted(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

} // namespace signorini
