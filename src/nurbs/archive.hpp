#pragma once
// Patches and discretisations in files, bit by bit.

#include "base/archive.hpp"
#include "nurbs/discretisation.hpp"

namespace signorini::nurbs {

void write(ArchiveWriter& to, const KnotVector& knots);
KnotVector read(ArchiveReader& from, std::type_identity<KnotVector>);

void write(ArchiveWriter& to, const Patch& patch);
Patch read(ArchiveReader& from, std::type_identity<Patch>);

void write(ArchiveWriter& to, const Side& side);
Side read(ArchiveReader& from, std::type_identity<Side>);

void write(ArchiveWriter& to, const Discretisation& space);
Discretisation read(ArchiveReader& from, std::type_identity<Discretisation>);

} // namespace signorini::nurbs
