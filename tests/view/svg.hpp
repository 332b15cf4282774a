#pragma once
// Contents of SVG files.

#include "messages.hpp"

namespace signorini::view {

using test::holds;
using test::message_of;

/// A color in the notation of an SVG: "#0072b2" is 0%, 44.7 %, 69.8 %.
inline std::string in_svg(const std::string& hex) {
  std::string parts;
  for (std::size_t i : {1, 3, 5}) {
    char digits[16];
    std::snprintf(digits, sizeof digits, "%f", 100 * std::stoi(hex.substr(i, 2), nullptr, 16) / 255.0);
    std::string part = digits;
    part.erase(part.find_last_not_of('0') + 1);
    if (part.back() == '.') part.pop_back();
    parts += (parts.empty() ? "" : ",") + part + "%";
  }
  return "rgb(" + parts + ")";
}

/// How often a text contains a part.
inline int count_of(const std::string& text, const std::string& part) {
  int count = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++count;
  return count;
}

/// The number after `key` in the element that ends with `end`, such as the y of ">20<".
inline double number_at(const std::string& svg, const std::string& end, const std::string& key) {
  const std::size_t place = svg.find(end), start = svg.rfind(" " + key + "=\"", place);
  EXPECT_NE(place, std::string::npos) << end;
  return std::stod(svg.substr(start + key.size() + 3));
}

} // namespace signorini::view
