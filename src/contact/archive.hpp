#pragma once
// Obstacles, laws and the accepted state of contacts in files, bit by bit.

#include "base/archive.hpp"
#include "contact/pair.hpp"

namespace signorini::contact {

void write(ArchiveWriter& to, const Obstacle<2>& obstacle);
void write(ArchiveWriter& to, const Obstacle<3>& obstacle);
Obstacle<2> read(ArchiveReader& from, std::type_identity<Obstacle<2>>);
Obstacle<3> read(ArchiveReader& from, std::type_identity<Obstacle<3>>);

void write(ArchiveWriter& to, const Law& law);
Law read(ArchiveReader& from, std::type_identity<Law>);

/// What does not follow from the displacements.
template <int D> void write_history(ArchiveWriter& to, const typename Pair<D>::History& history);
/// Puts it into a history of the same contact, which the pair must restore and then settle. Throws Error when it does
/// not belong to this contact.
template <int D> void read_history(ArchiveReader& from, typename Pair<D>::History& history);

} // namespace signorini::contact
