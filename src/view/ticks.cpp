// Positions of ticks on an axis, with numbers or names.

#include "view/frame.hpp"

#include "base/error.hpp"
#include "view/text.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>

namespace signorini::view {
namespace {

constexpr double slack = 1e-9; // relative to one step: includes ticks at the ends of the range

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

/// "0.02", or "2×10⁻⁶" if the decimal number would be long.
std::string multiple(int digit, int exponent) {
  if (exponent < -4 || exponent > 4) return (digit == 1 ? "" : std::to_string(digit) + "×") + power_of_ten(exponent);
  return number(digit * std::pow(10.0, exponent), std::max(0, -exponent));
}

/// The smallest 1, 2 or 5 × 10ᵏ with at most `count` multiples within [low, high].
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

/// Linear ticks with minor ticks that divide each step into five or, if it is 2 × 10ᵏ, four parts.
Ticks with_minor(Ticks ticks, double low, double high) {
  if (ticks.at.size() < 2) return ticks;
  const double step = ticks.at[1] - ticks.at[0], digit = step / std::pow(10.0, std::floor(std::log10(step) + slack));
  const int parts = std::lround(digit) == 2 ? 4 : 5;
  const int before = static_cast<int>((ticks.at.front() - low) / step * parts + slack);
  for (int i = -before; ticks.at.front() + i * step / parts <= high + slack * step; ++i)
    if (i % parts != 0) ticks.minor.push_back(ticks.at.front() + i * step / parts);
  return ticks;
}

/// Width available to a name at tick i, if its neighbors take as much, pixels.
double room_for(const Ticks& ticks, std::size_t i, const Scale& scale) {
  double space = scale.to - scale.from;
  if (i > 0) space = std::min(space, scale(ticks.at[i]) - scale(ticks.at[i - 1]));
  if (i + 1 < ticks.at.size()) space = std::min(space, scale(ticks.at[i + 1]) - scale(ticks.at[i]));
  return space;
}

/// All on one line in one size; false if that would be too small.
bool shrink_names(Ticks& ticks, const Scale& scale, bool within_cells, const Style& style) {
  double size = style.tick_size;
  for (std::size_t i = 0; i < ticks.at.size() && within_cells; ++i)
    size = std::min(size, room_for(ticks, i, scale) / (text_width(ticks.labels[i], 1) + 0.6));
  for (std::size_t i = 1; i < ticks.at.size(); ++i) {
    const double needed = 0.5 * (text_width(ticks.labels[i - 1], 1) + text_width(ticks.labels[i], 1)) + 0.6;
    size = std::min(size, (scale(ticks.at[i]) - scale(ticks.at[i - 1])) / needed);
  }
  for (const std::string& label : ticks.labels) ticks.names.push_back({{label}, size});
  return size >= least_size(style);
}

/// Each on up to three lines, in its own size; false if one is truncated.
bool wrap_names(Ticks& ticks, const Scale& scale, const Style& style) {
  bool whole = true;
  for (std::size_t i = 0; i < ticks.at.size(); ++i) {
    const double space = room_for(ticks, i, scale) - 0.6 * least_size(style);
    ticks.names[i] = fit_text(ticks.labels[i], style.tick_size, least_size(style), space, 3);
    ticks.depth = std::max(ticks.depth, ticks.names[i].depth());
    whole = whole && !ticks.names[i].cut;
  }
  return whole;
}

/// Minimum distance of two names, pixels.
double closest(const Ticks& ticks, const Scale& scale) {
  double space = scale.to - scale.from;
  for (std::size_t i = 0; i < ticks.at.size(); ++i) space = std::min(space, room_for(ticks, i, scale));
  return space;
}

/// Omits names closer than `apart` pixels to the one before.
Ticks thinned(const Ticks& ticks, const Scale& scale, double apart) {
  Ticks kept;
  for (std::size_t i = 0; i < ticks.at.size(); ++i) {
    if (!kept.at.empty() && scale(ticks.at[i]) - scale(kept.at.back()) < apart - 1e-9) continue;
    kept.at.push_back(ticks.at[i]), kept.labels.push_back(ticks.labels[i]);
  }
  return kept;
}

/// Some numbers can be omitted, because readers can interpolate.
bool is_number(const std::string& name) {
  return std::none_of(name.begin(), name.end(), [](unsigned char c) { return std::isalpha(c) != 0; });
}

Ticks thin_out_numbers(const Ticks& ticks, const Scale& scale, const Style& style) {
  const double size = least_size(style);
  double width = 0;
  for (const std::string& label : ticks.labels) width = std::max(width, text_width(label, size));
  Ticks kept = thinned(ticks, scale, width + 0.6 * size);
  for (const std::string& label : kept.labels) kept.names.push_back({{label}, size});
  return kept;
}

/// Names across the axis, on as many lines as fit.
Ticks lines_across(const Ticks& ticks, const Scale& scale, double most, double step, const Style& style) {
  const double space = closest(ticks, scale), size = std::clamp(space / step, least_size(style), style.tick_size);
  Ticks kept = thinned(ticks, scale, step * size);
  const int lines = std::clamp(static_cast<int>(space / (line_step * size) - 0.3), 1, 3);
  for (const std::string& label : kept.labels)
    kept.names.push_back(fit_text(label, size, least_size(style), most, lines));
  return kept;
}

Ticks within(const std::vector<Name>& names, const Scale& scale) {
  Ticks ticks;
  for (const auto& [at, name] : names)
    if (at >= scale.low && at <= scale.high) ticks.at.push_back(at), ticks.labels.push_back(name);
  return ticks;
}

} // namespace

std::string in_digits(double value, int most) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.*g", most, std::abs(value));
  std::string text = digits;
  if (const std::size_t e = text.find('e'); e != text.npos)
    text = text.substr(0, e) + "×10^{" + std::to_string(std::stoi(text.substr(e + 1))) + "}";
  return (value < 0 ? "−" : "") + text;
}

void require_drawable(double low, double high, bool log) {
  // Beyond these limits, lengths and steps lose precision.
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
  // An integer counter, because adding 1 has no effect in a range as narrow as rounding error.
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
  // One or two powers alone do not show the scale.
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

Ticks named_ticks(const std::vector<Name>& names, const Scale& scale, double most, const Style& style,
                  bool within_cells) {
  Ticks ticks = within(names, scale);
  if (shrink_names(ticks, scale, within_cells, style)) return ticks;
  if (std::all_of(ticks.labels.begin(), ticks.labels.end(), is_number)) return thin_out_numbers(ticks, scale, style);
  if (wrap_names(ticks, scale, style) || most < 2 * style.tick_size) return ticks;
  Ticks upright = lines_across(ticks, scale, most, line_step, style);
  upright.upright = true;
  for (const FittedText& name : upright.names) upright.depth = std::max(upright.depth, name.width() - style.tick_size);
  return upright;
}

Ticks stacked_names(const std::vector<Name>& names, const Scale& scale, double most, const Style& style) {
  constexpr double step = 1.15; // minimum distance of names, relative to their size
  return lines_across(within(names, scale), scale, most, step, style);
}

} // namespace signorini::view
