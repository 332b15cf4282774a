#pragma once
// Degrees of freedom of contact blocks.

#include "contact/gauss/block.hpp"
#include "contact/point/faces.hpp"

namespace signorini::contact {

/// First degree of freedom of the master, which is not 0 for an obstacle only, and of the additional unknowns.
/// Functions of faces are numbered through all bodies.
struct Offsets {
  int master, extra;
};

/// Appends the degrees of freedom of a block's columns, those of the rows first.
template <int D>
void append_dofs(const Faces<D>& faces, const Block& block, const Offsets& offsets, std::vector<int>& dofs);
/// Appends those of an element of a face, which are numbered from `first` on.
template <int D> void append_element(const Surface<D>& face, int element, int first, std::vector<int>& dofs);
/// Appends those of a master element and, if `and_next`, of its neighbors on the face.
template <int D>
void append_master(const Master<D>& master, int element, const Offsets& offsets, std::vector<int>& dofs,
                   bool and_next = false);

} // namespace signorini::contact
