#pragma once
// Patches and discretisations in files, bit by bit.

#include "base/archive.hpp"
#include "nurbs/discretisation.hpp"

namespace signorini::nurbs {

void write(ArchiveWriter& to, const KnotVector& knots);
KnotVector read(ArchiveReader& from, std::type_identity<KnotVector>);

/// As its knots where it has them.
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

inline auto members(Side& side) {
  auto& [direction, at_end] = side;
  return std::tie(direction, at_end);
}

void write(ArchiveWriter& to, const Discretisation& space);
Discretisation read(ArchiveReader& from, std::type_identity<Discretisation>);

} // namespace signorini::nurbs
