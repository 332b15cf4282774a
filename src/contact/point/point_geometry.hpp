#pragma once
// Geometry of a contact point in local variables, and the pieces of a slave face that are evaluated in parallel.

#include "contact/point/contact_points.hpp"
#include "contact/point/local.hpp"
#include "contact/point/master.hpp"

namespace signorini::contact {

/// The geometry at point i, whose position projects onto `foot`: geometry of order 2; keeps a pointer to it.
template <int D>
LocalGeometry<D> point_geometry(const ContactPoints<D>& points, std::size_t i, const Surface<D>& slave,
                                const Master<D>& master, const Vec<D>& position, const Projection<D>& projection,
                                const FacePoint<D>& foot);

/// First and last + 1 of the points of each piece: whole elements, with about the same number of points.
template <int D> std::vector<std::array<std::size_t, 2>> pieces(const ContactPoints<D>& points);

} // namespace signorini::contact
