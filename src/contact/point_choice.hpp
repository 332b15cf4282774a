#pragma once
// Elements that need few contact points: those far from changes of the contact state.

#include "contact/history.hpp"

#include <vector>

namespace signorini::contact {

/// Per slave element of the history, whether its sparse rule suffices in the next step. The integrand of an element
/// that is wholly open or closed is as smooth as the faces; at the border of the contact it has a kink,
/// where Gauss rules lose their order (T. X. Duong, R. A. Sauer, Comput. Mech. 55, 2015, refine them there). An element
/// has its full rule if
///  - its points are in different states, or a closest point is an open end of the master; where some stick and others
///    slip the friction has a kink, and with fewer points Newton's iteration cycles (share/doc/stability.md);
///  - it is closed and its least pressure is below a fraction of its largest, so that the border is near;
///  - it is open and `clearance` of a point, a lower bound of its distance from contact, is below a multiple of
///    `moved`, by which slave and master have approached each other in the last step, or a fraction of its diagonal;
///  - its state differs from a neighbor's;
///  - the region of the contact cuts it.
/// Both limits are higher for elements that have their full rule (hysteresis), so that rules do not alternate.
template <int D>
std::vector<char> choose_sparse(const ContactPoints<D>& points, const Surface<D>& slave, const History<D>& history,
                                const std::vector<double>& clearance, double moved);

} // namespace signorini::contact
