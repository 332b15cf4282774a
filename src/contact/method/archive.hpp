#pragma once
// Binary input and output of obstacles, contact laws and the accepted state of contacts.

#include "contact/method/method.hpp"
#include "os/archive.hpp"

namespace signorini::contact {

void write(ArchiveWriter& to, const Obstacle<2>& obstacle);
void write(ArchiveWriter& to, const Obstacle<3>& obstacle);
Obstacle<2> read(ArchiveReader& from, std::type_identity<Obstacle<2>>);
Obstacle<3> read(ArchiveReader& from, std::type_identity<Obstacle<3>>);

constexpr MultiplierSpace last_value(std::type_identity<MultiplierSpace>) {
  return MultiplierSpace::linear; // automatic: never in a scene that is complete
}

inline auto members(Start& start) {
  auto& [active, offset, interference] = start;
  return std::tie(active, offset, interference);
}

void write(ArchiveWriter& to, const Method& method);
Method read(ArchiveReader& from, std::type_identity<Method>);

/// Writes the part of the history that does not follow from the displacements.
template <int D> void write_history(ArchiveWriter& to, const History<D>& history);
/// Reads it into a history of the same contact, to be completed by Formulation::settle. Throws Error if the number of
/// contact points differs, or if a point refers to an element that the master does not have.
template <int D> void read_history(ArchiveReader& from, const Formulation<D>& formulation, History<D>& history);

} // namespace signorini::contact
