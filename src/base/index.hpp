#pragma once
// Indices are int here, as Eigen and the solvers take them; the standard library's containers want their own type.

#include <cstddef>

namespace signorini {

constexpr std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

} // namespace signorini
