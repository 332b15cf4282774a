#pragma once
// How a body's elements are shared out, so that several threads can add to one residual and one tangent.

#include "model/unknowns.hpp"

namespace signorini::model {

/// Elements first … last − 1.
struct ElementRange {
  int first, last;
};

/// `heads` are added side by side, then `tails` side by side, then `rest` one by one: no two elements of different
/// heads (of different tails) have a degree of freedom or an unknown in common. The shares depend on the body alone, so
/// sums are the same, bit by bit, for any number of threads.
struct Partition {
  std::vector<ElementRange> heads, tails; ///< of equal number
  std::vector<int> rest;
  std::vector<char> in_rest; ///< per element: passed over in heads and tails
};

/// Shares of a body with enough elements to be worth it; otherwise one head.
template <int D> Partition partition(const Unknowns<D>& unknowns, const solid::Body<D>& body, int offset);

} // namespace signorini::model
