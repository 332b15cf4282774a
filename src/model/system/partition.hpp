#pragma once
// Partition of a body's elements for parallel assembly of one residual and one tangent.

#include "model/system/unknowns.hpp"

namespace signorini::model {

/// `heads` are assembled in parallel, then `tails` in parallel, then `rest` sequentially: elements of different heads
/// (of different tails) have no common degree of freedom or unknown. The shares depend on the body alone, so sums are
/// bitwise the same for any number of threads.
struct Partition {
  std::vector<std::vector<int>> heads, tails; ///< elements of each share; of equal number
  std::vector<int> rest;                      ///< elements with an unknown of several control points or bodies
  std::vector<int> share;                     ///< per element, also of `rest`: index of its share
};

/// The partition into slabs normal to one parametric direction, with the number and direction that two threads assemble
/// fastest; one head for bodies with few elements. `offset`: the body's first degree of freedom,
/// `of_several`: see of_several_bodies().
template <int D>
Partition partition(const Unknowns<D>& unknowns, const solid::Body<D>& body, int offset,
                    const std::vector<char>& of_several = {});

/// Marks the unknowns of several bodies, which are joined or rotate together; empty if there are none.
template <int D> std::vector<char> of_several_bodies(const Scene<D>& scene, const Unknowns<D>& unknowns);

} // namespace signorini::model
