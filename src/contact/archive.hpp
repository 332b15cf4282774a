#pragma once
// Obstacles, laws and the accepted state of contacts in files, bit by bit.

#include "base/archive.hpp"
#include "contact/method.hpp"

namespace signorini::contact {

template <class T>
concept AnyObstacle = std::is_same_v<T, Obstacle<2>> || std::is_same_v<T, Obstacle<3>>;
template <AnyObstacle T> void write(ArchiveWriter& to, const T& obstacle);
template <AnyObstacle T> T read(ArchiveReader& from, std::type_identity<T>);

/// Throws Error for a formulation of one's own, of which nobody else knows.
template <int D> void write(ArchiveWriter& to, const Method<D>& method);
template <int D> Method<D> read_method(ArchiveReader& from);

/// What does not follow from the displacements.
template <int D> void write_history(ArchiveWriter& to, const History<D>& history);
/// Puts it into a history of the same contact, which Formulation::settle must then complete. Throws Error when it does
/// not belong to this contact.
template <int D> void read_history(ArchiveReader& from, History<D>& history);

} // namespace signorini::contact
