#include "solve/pseudo_time.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::solve {

bool PseudoTime::accept(double error) {
  constexpr double largest = 0.5, least = 1e-5;
  // A move this short, next to that of the diagonal alone, goes over a jump of the residual if there is one.
  constexpr double strong = 10;
  if (!(error <= largest) && !(damping_ > strong && std::isfinite(error))) {
    damping_ = std::max(4 * damping_, least);
    return false;
  }
  if (error < 0.2 * largest)
    damping_ /= 5;
  else if (error > 0.5 * largest)
    damping_ *= 2;
  return true;
}

} // namespace signorini::solve
