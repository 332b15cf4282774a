#pragma once
// How far points of a set of faces look for feet, and how long they stay open [theory 8.4].

#include "contact/gauss/formulation.hpp"

namespace signorini::contact {

/// From where point i looks for its foot in a trial state, and how far; otherwise every foot counts.
template <int D> Lookout<D> lookout(const Formulation<D>& contact, std::size_t i, const Trial<D>& trial);

/// The value of Faces::travel up to which point i of a set stays open, with the projection of the trial state.
template <int D> double cleared_in_set(const Formulation<D>& contact, std::size_t i, const Trial<D>& trial);

} // namespace signorini::contact
