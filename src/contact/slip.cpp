#include "contact/slip.hpp"

#include <cmath>

namespace signorini::contact {

double advance_slip(const Surface<2>& surface, double slip, const FacePoint<2>& foot, double length) {
  const nurbs::KnotVector& knots = surface.direction(0);
  // h(ξ) = |x(ξ) − x̄| − L is positive at the old slip point and −L at the foot: bracketed Newton, bisection as guard.
  double outer = slip, inner = foot.xi(0);
  FacePoint<2> point;
  surface.locate(knots.find_element(slip), FaceCoordinates<2>(slip), 0, point);
  const double present = (point.position - foot.position).norm();
  if (!(present > length)) return slip;
  double xi = inner + (outer - inner) * length / present; // where it were on a straight line of even speed
  for (int iteration = 0; iteration < 100; ++iteration) {
    surface.locate(knots.find_element(xi), FaceCoordinates<2>(xi), 1, point);
    const Vec<2> chord = point.position - foot.position;
    const double distance = chord.norm(), h = distance - length;
    if (std::abs(h) <= 1e-15 * distance || std::abs(outer - inner) <= 1e-15 * (knots.last() - knots.first())) break;
    (h > 0 ? outer : inner) = xi;
    // h'(ξ) = (x(ξ) − x̄)·τ/|x(ξ) − x̄|
    const double next = xi - h * distance / chord.dot(point.tangent[0]);
    const bool inside = (next - outer) * (next - inner) < 0;
    const double previous = xi;
    xi = inside ? next : 0.5 * (outer + inner);
    if (xi == previous) break;
  }
  return xi;
}

} // namespace signorini::contact
