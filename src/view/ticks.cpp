#include "view/ticks.hpp"

#include "base/error.hpp"
#include "view/text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace signorini::view {
namespace {

constexpr double slack = 1e-9; // of one step: a tick on the range's very end belongs to it

std::string number(double value, int decimals) {
  char digits[64];
  std::snprintf(digits, sizeof digits, "%.*f", decimals, std::abs(value));
  return (value < 0 ? "−" : "") + std::string(digits);
}

std::string power_of_ten(int exponent) {
  std::string result = "10";
  if (exponent < 0) result += "⁻";
  for (char digit : std::to_string(std::abs(exponent))) {
    static constexpr char32_t raised[] = U"⁰¹²³⁴⁵⁶⁷⁸⁹";
    result += to_utf8(raised[digit - '0']);
  }
  return result;
}

/// "0.02", or "2×10⁻⁶" where the plain number would be long.
std::string multiple(int digit, int exponent) {
  if (exponent < -4 || exponent > 4) return (digit == 1 ? "" : std::to_string(digit) + "×") + power_of_ten(exponent);
  return number(digit * std::pow(10.0, exponent), std::max(0, -exponent));
}

/// The least of 1, 2, 5 × 10ᵏ whose multiples within [low, high] are no more than `count`.
double round_step(double low, double high, int count) {
  double power = std::pow(10.0, std::floor(std::log10((high - low) / count)));
  for (;; power *= 10)
    for (double factor : {1.0, 2.0, 5.0}) {
      const double step = factor * power;
      if (std::floor(high / step + slack) - std::ceil(low / step - slack) < count) return step;
    }
}

Ticks decades(int first, int last, int count) {
  Ticks ticks;
  const int stride = (last - first) / count + 1;
  for (int k = first - 1; k <= last; ++k) {
    if (k >= first && (k - first) % stride == 0) {
      ticks.at.push_back(std::pow(10.0, k));
      ticks.labels.push_back(power_of_ten(k));
    } else if (k >= first) {
      ticks.minor.push_back(std::pow(10.0, k));
    }
    for (int digit = 2; digit <= 9 && stride == 1; ++digit) ticks.minor.push_back(digit * std::pow(10.0, k));
  }
  return ticks;
}

/// Linear ticks with marks that part each step in fifths or, where it is 2 × 10ᵏ, in quarters.
Ticks with_minor(Ticks ticks, double low, double high) {
  if (ticks.at.size() < 2) return ticks;
  const double step = ticks.at[1] - ticks.at[0], digit = step / std::pow(10.0, std::floor(std::log10(step) + slack));
  const int parts = std::lround(digit) == 2 ? 4 : 5;
  const int before = static_cast<int>((ticks.at.front() - low) / step * parts + slack);
  for (int i = -before; ticks.at.front() + i * step / parts <= high + slack * step; ++i)
    if (i % parts != 0) ticks.minor.push_back(ticks.at.front() + i * step / parts);
  return ticks;
}

} // namespace

std::string in_digits(double value) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.3g", std::abs(value));
  std::string text = digits;
  if (const std::size_t e = text.find('e'); e != text.npos)
    text = text.substr(0, e) + "×10^{" + std::to_string(std::stoi(text.substr(e + 1))) + "}";
  return (value < 0 ? "−" : "") + text;
}

void require_drawable(double low, double high, bool log) {
  // Beyond these, lengths and steps are no longer numbers of full precision.
  constexpr double largest = 1e300, narrowest = 1e-300;
  require(std::max(std::abs(low), std::abs(high)) <= largest && high - low >= narrowest, "view.ticks.bounds");
  require(!log || high / low <= largest, "view.ticks.decades");
}

Ticks linear_ticks(double low, double high, int count) {
  require_drawable(low, high, false);
  Ticks ticks;
  const double step = round_step(low, high, count);
  const int size = static_cast<int>(std::floor(std::log10(std::max(std::abs(low), std::abs(high))) + slack));
  const int exponent = size >= 5 || size <= -4 ? size : 0;
  const double scale = std::pow(10.0, -exponent);
  const int decimals = std::clamp(-static_cast<int>(std::floor(std::log10(step * scale) + slack)), 0, 15);
  // Counted, as adding 1 changes nothing where a range is as narrow as rounding.
  const double first = std::ceil(low / step - slack);
  for (int i = 0; i <= count && first + i <= high / step + slack; ++i) {
    ticks.at.push_back((first + i) * step);
    ticks.labels.push_back(number((first + i) * step * scale, decimals));
  }
  if (exponent != 0) ticks.factor = "×" + power_of_ten(exponent);
  return ticks;
}

Ticks log_ticks(double low, double high, int count) {
  require_drawable(low, high, true);
  const double from = std::log10(low), to = std::log10(high);
  const int first = static_cast<int>(std::ceil(from - slack)), last = static_cast<int>(std::floor(to + slack));
  if (high / low < 5) return with_minor(linear_ticks(low, high, count), low, high);
  Ticks ticks;
  // One or two powers alone would say little.
  const bool few = to - from < 1.5 && count >= 5;
  if (last > first && !few) {
    ticks = decades(first, last, count);
    std::erase_if(ticks.minor, [&](double v) { return v < low || v > high; });
    return ticks;
  }
  for (int k = first - 1; k <= last; ++k)
    for (int digit = 1; digit <= 9; ++digit) {
      const double value = digit * std::pow(10.0, k);
      if (value < low * (1 - slack) || value > high * (1 + slack)) continue;
      if (digit == 1 || digit == 2 || digit == 5) {
        ticks.at.push_back(value);
        ticks.labels.push_back(multiple(digit, k));
      } else {
        ticks.minor.push_back(value);
      }
    }
  return ticks;
}

} // namespace signorini::view
