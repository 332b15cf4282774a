#pragma once
// Where a chart shows its data points and cells, for programs that display their values on request.

#include "view/drawing.hpp"

namespace signorini::view {

/// A data point (a box without extent) or a cell.
struct Spot {
  Box box; ///< in pixels of the figure
  /// Name and value of each quantity, as the chart's labels have them; the name may be empty.
  std::vector<std::array<std::string, 2>> values = {};

  void add(const std::string& name, const std::string& value) {
    if (!value.empty()) values.push_back({name, value});
  }
};

} // namespace signorini::view
