#include "solve/pseudo_time.hpp"

#include "solve/constants.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::solve {

bool PseudoTime::accept(double error) {
  if (!(error <= most_pseudo_error) && !(damping_ > strong_damping && std::isfinite(error))) {
    damping_ = std::max(damping_retry * damping_, least_pseudo_damping);
    return false;
  }
  if (error < small_pseudo_error * most_pseudo_error)
    damping_ /= damping_fall;
  else if (error > large_pseudo_error * most_pseudo_error)
    damping_ *= damping_growth;
  return true;
}

} // namespace signorini::solve
