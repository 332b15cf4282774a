#pragma once
// Geometry of a contact point in local variables, and the pieces of a slave face that are evaluated in parallel.

#include "contact/point/faces.hpp"
#include "contact/point/history.hpp"

namespace signorini::contact {

/// Foot point and slip point of a contact point on the master.
template <int D> struct FootPoints { FacePoint<D> foot, slip_point; };

/// Projects a contact point at the position in its result: writes closest point and result, and the geometry to `foot`.
/// Returns false at an open end of the master.
template <int D>
bool find_foot(const Master<D>& master, PointHistory<D>& point, PointResult<D>& result, FacePoint<D>& foot,
               const Lookout<D>& from = {});

/// n̄ at the closest point of a position.
template <int D>
Vec<D> contact_normal(const Master<D>& master, const Projection<D>& projection, const FaceGeometry<D>& foot,
                      const Vec<D>& position);

/// The geometry at point i, whose position projects onto `foot`: geometry of order 2; keeps a pointer to it.
template <int D>
LocalGeometry<D> point_geometry(const ContactPoints<D>& points, std::size_t i, const Faces<D>& faces,
                                const Vec<D>& position, const Projection<D>& projection, const FacePoint<D>& foot);

/// Current area per parametric area of the slave face at point i.
template <int D>
double slave_measure(const ContactPoints<D>& points, const Surface<D>& slave, std::size_t i, const Vec<D>& position);

/// First and last + 1 of the points of each piece: whole elements, with about the same number of points.
template <int D> std::vector<std::array<std::size_t, 2>> pieces(const ContactPoints<D>& points);

} // namespace signorini::contact
