#pragma once
// Serialization of patches and discretizations, bit by bit.

#include "nurbs/discretization.hpp"
#include "os/archive.hpp"

namespace signorini::nurbs {

void write(ArchiveWriter& to, const KnotVector& knots);
KnotVector read(ArchiveReader& from, std::type_identity<KnotVector>);

/// Writes the knots if the space has them, otherwise its tables.
void write(ArchiveWriter& to, const Space1D& space);
Space1D read(ArchiveReader& from, std::type_identity<Space1D>);

template <class Direction> void write(ArchiveWriter& to, const TensorProduct<Direction>& patch) {
  to.put(patch.directions(), patch.homogeneous());
}
template <class Direction>
TensorProduct<Direction> read(ArchiveReader& from, std::type_identity<TensorProduct<Direction>>) {
  auto directions = from.get<std::vector<Direction>>();
  return {std::move(directions), from.get<MatrixX>()};
}

inline void write(ArchiveWriter& to, const Side& side) {
  to.put(side.direction, side.at_end);
}
Side read(ArchiveReader& from, std::type_identity<Side>);

/// Writes the patch and the plan if it has its recipe, otherwise its parts.
void write(ArchiveWriter& to, const Discretization& space);
Discretization read(ArchiveReader& from, std::type_identity<Discretization>);

} // namespace signorini::nurbs
