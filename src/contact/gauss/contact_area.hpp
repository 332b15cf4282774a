#pragma once
// The area in contact: the part of the slave face inside g = 0, interpolated between the contact points
// [theory 5.15].

#include "contact/gauss/formulation.hpp"

namespace signorini::contact {

/// The contact points that lie in the contact area, and that area.
///
/// Points that touch are inside, except those of a fringe: with multipliers, pressures extend over the whole support
/// of the last closed ones, past the border, where the gap is open. The fringe are the touching points whose gap is
/// open, E g > 0.1 h p with the length h of their element, and that are connected with open points through such points.
/// Mortar contact holds in the mean only: the smaller gaps that multipliers leave inside, in turn with penetrations,
/// belong to the contact.
///
/// The border is g = 0 between points inside and outside: linear between two neighboring points of a curve,
/// on a surface straight in each cell of four neighboring points. Each point contributes the part of its area (of its
/// Gauss weight) that lies inside, so that the area is a continuous function of the gaps. At the ends of the face and
/// of the master the area ends with that of the last point. Bonds and adhesion act over a distance: the points that
/// they hold are inside as a whole.
struct ContactArea {
  std::vector<char> inside; ///< by contact point
  double area = 0;
};
/// `reference`: areas of results are reference areas; `modulus`: Young's modulus of the softer body. `history` belongs
/// to the current position of the faces.
template <int D>
ContactArea contact_area(const Formulation<D>& formulation, const History<D>& history, bool reference, double modulus);

} // namespace signorini::contact
