#pragma once
// Which points of a set of faces look for feet, and how far [theory 8.4].

#include "contact/gauss/formulation.hpp"

namespace signorini::contact {

/// From where point i looks for its foot in a trial state, and how far; otherwise every foot counts.
template <int D> Lookout<D> lookout(const Formulation<D>& contact, std::size_t i, const Trial<D>& trial);

/// True if i is the first point of its element.
template <int D> bool is_first_of_element(const ContactPoints<D>& points, std::size_t i) {
  return i == 0 || points.list[i].element != points.list[i - 1].element;
}
/// True only if the points of an element of a set are open and touch nothing on the way from the accepted to the
/// present state. `guessed`: see Controls.
template <int D>
bool is_alone(const Formulation<D>& contact, int element, const History<D>& present, const History<D>& accepted,
              double guessed = 0);
/// True only if no point of an element of a set, in the accepted state, is nearer to contact than a distance with what
/// it looks for.
template <int D> bool is_far(const Formulation<D>& contact, int element, const History<D>& accepted, double distance);
/// True if an element that is alone need not be watched: no later step depends on what its points have gone through.
template <int D> bool has_no_past(const Formulation<D>& contact, int element, const History<D>& present);
/// True if point i of a set, which `is_alone` does not tell to be open, has passed through a part of it since the
/// accepted state (crossing.hpp). `moved`: bound on the set's motion since then.
template <int D>
bool has_passed_through(const Formulation<D>& contact, std::size_t i, const History<D>& present,
                        const History<D>& accepted, double moved);

} // namespace signorini::contact
