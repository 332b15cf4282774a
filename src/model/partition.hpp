#pragma once
// How a body's elements are shared out, so that several threads can add to one residual and one tangent.

#include "model/unknowns.hpp"

namespace signorini::model {

/// `heads` are added side by side, then `tails` side by side, then `rest` one by one: no two elements of different
/// heads (of different tails) have a degree of freedom or an unknown in common. The shares depend on the body alone, so
/// sums are the same, bit by bit, for any number of threads.
struct Partition {
  std::vector<std::vector<int>> heads, tails; ///< elements of each share; of equal number
  std::vector<int> rest;                      ///< elements with an unknown that stands for several control points
  std::vector<int> share;                     ///< per element: the share that it would be in, those of `rest` as well
};

/// Shares of a body with enough elements to be worth it: slabs across one parametric direction, as many and across the
/// one that two threads add up soonest; otherwise one head.
template <int D> Partition partition(const Unknowns<D>& unknowns, const solid::Body<D>& body, int offset);

} // namespace signorini::model
