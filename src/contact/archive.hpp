#pragma once
// Obstacles, laws and the accepted state of contacts in files, bit by bit.

#include "base/archive.hpp"
#include "contact/method.hpp"

namespace signorini::contact {

void write(ArchiveWriter& to, const Obstacle<2>& obstacle);
void write(ArchiveWriter& to, const Obstacle<3>& obstacle);
Obstacle<2> read(ArchiveReader& from, std::type_identity<Obstacle<2>>);
Obstacle<3> read(ArchiveReader& from, std::type_identity<Obstacle<3>>);

/// Throws Error for a user-defined formulation: files hold only those of the program.
template <int D> void write(ArchiveWriter& to, const Method<D>& method);
template <int D> Method<D> read_method(ArchiveReader& from);

/// What does not follow from the displacements.
template <int D> void write_history(ArchiveWriter& to, const History<D>& history);
/// Puts it into a history of the same contact, which Formulation::settle must then complete. Throws Error when it does
/// not belong to this contact.
template <int D> void read_history(ArchiveReader& from, History<D>& history);

} // namespace signorini::contact
