#pragma once
// An ordering that gathers the entries of a matrix near its diagonal.

#include "solve/pattern.hpp"

#include <vector>

namespace signorini::solve {

/// The unknowns in the reverse order of Cuthill & McKee (1969), each connected part from an end of its own (George &
/// Liu 1979).
std::vector<int> band_order(const Pattern& pattern);

/// Largest |place of i − place of j| over the entries (i, j) of the pattern.
int band_width(const Pattern& pattern, const std::vector<int>& order);

} // namespace signorini::solve
