#pragma once
// Elements that need few contact points: those far from changes of the contact state [theory 5.12].

#include "contact/point/history.hpp"

#include <functional>
#include <span>
#include <vector>

namespace signorini::contact {

using IsNear = std::function<bool(std::span<const std::size_t> points, double distance)>;

/// Per slave element of the history, true if its sparse rule suffices in the next step. The integrand of an element
/// that is wholly open or closed is as smooth as the faces; at the border of the contact it has a kink,
/// where Gauss rules lose their order (T. X. Duong, R. A. Sauer, Comput. Mech. 55, 2015, refine them there). An element
/// has its full rule if
///  - its points are in different states; where some stick and others slip the friction has a kink, and with fewer
///    points Newton's iteration cycles (share/doc/evidence/stability.md);
///  - it is closed and its least pressure is below a fraction of its largest, so that the border is near;
///  - it is open and a point is nearer to contact than a multiple of `moved`, by which slave and master have approached
///    each other in the last step, or a fraction of its diagonal;
///  - a point of a neighbor is open where it is closed, or the reverse;
///  - the region of the contact cuts it.
/// Both limits are higher for elements that have their full rule (hysteresis), so that rules do not alternate.
/// `is_near(points, distance)`: true if one of these open points is nearer to contact than the distance.
template <int D>
std::vector<char> choose_sparse(const ContactPoints<D>& points, const Surface<D>& slave, const History<D>& history,
                                double moved, const IsNear& is_near);

} // namespace signorini::contact
