#include "bind/lua/number_text.hpp"

#include <cmath>
#include <cstdio>

namespace signorini::bind {

std::string number_text(double value, bool powers) {
  static constexpr const char* raised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  const double size = std::abs(value);
  char digits[32];
  std::snprintf(digits, sizeof digits, powers && (size >= 1e4 || (size > 0 && size < 1e-3)) ? "%.5e" : "%g", size);
  const std::string number = digits;
  const std::size_t e = number.find('e');
  std::string result = number.substr(0, e);
  if (e != std::string::npos) {
    if (result.find('.') != std::string::npos) result.erase(result.find_last_not_of(".0") + 1);
    const int exponent = std::stoi(number.substr(e + 1));
    result = (result == "1" ? "" : result + "×") + "10" + (exponent < 0 ? "⁻" : "");
    for (char digit : std::to_string(std::abs(exponent))) result += raised[digit - '0'];
  }
  return (value < 0 ? "−" : "") + result;
}

} // namespace signorini::bind
