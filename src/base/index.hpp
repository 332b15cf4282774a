#pragma once
// Indices are int, as in Eigen and the solvers; at() converts them for the containers of the standard library.

#include <cstddef>

namespace signorini {

constexpr std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

} // namespace signorini
