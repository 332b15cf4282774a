#include "contact/point/slip.hpp"

#include "contact/point/unfold.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini::contact {

namespace {

/// The point at the end of the projection of a chord from `foot` to `slip`.
template <int D>
FaceCoordinates<D> along_chord(const Surface<D>& surface, const FaceCoordinates<D>& slip, const FaceGeometry<D>& foot,
                               double length) {
  FaceGeometry<D> point;
  surface.locate(surface.find_element(slip), slip, 0, point);
  const Vec<D> chord = point.position - foot.position;
  const double present = chord.norm();
  if (!(present > length)) return slip;
  // x(ξ) is the closest point to y = x̄ + c (x_sl − x̄)/|x_sl − x̄|; on a curved surface c, the length on the chord, is
  // slightly less than |x(ξ) − x̄|.
  double on_chord = length;
  FaceCoordinates<D> xi = foot.xi, best = xi;
  double least = std::numeric_limits<double>::infinity(); // error of the best point
  for (int iteration = 0; iteration < 30; ++iteration) {
    const Vec<D> y = foot.position + (on_chord / present) * chord;
    walk(surface, y, surface.find_element(xi), xi, point);
    xi = point.xi;
    const double distance = (point.position - foot.position).norm(), error = std::abs(distance - length);
    if (!(distance > 0)) break;
    const bool decreases = error < least;
    if (decreases) {
      least = error;
      best = xi;
    }
    // Rounding error, that of the positions if a small error does not decrease any more.
    if (error <= slip_rounding * present || (!decreases && least <= position_rounding * present)) break;
    on_chord = std::min(on_chord * length / distance, present);
  }
  return best;
}

/// As advance_slip(), on the way to `foot` on the same side of all kinks.
FaceCoordinates<2> advance_smoothly(const Surface<2>& surface, const FaceCoordinates<2>& slip,
                                    const FaceGeometry<2>& foot, double length) {
  const int sheet = surface.sheet(foot.element);
  if (surface.sheet_at(slip) != sheet) return along_chord(surface, slip, foot, length);
  const nurbs::Space1D& space = surface.direction(0, sheet);
  // h(ξ) = |x(ξ) − x̄| − L is positive at the old slip point and −L at the foot point: Newton's method with bisection as
  // safeguard.
  double outer = slip(0), inner = foot.xi(0);
  // On a closed curve the shorter path may cross the seam, where the parameter jumps by the period.
  const int first = surface.first_function(sheet), last = first + space.functions() - 1;
  const double period = space.last() - space.first();
  if (surface.points().col(first).isApprox(surface.points().col(last)) && std::abs(outer - inner) > 0.5 * period)
    outer += std::copysign(period, inner - outer);
  const auto wrapped = [&](double xi) {
    return xi > space.last()    ? std::max(xi - period, space.first())
           : xi < space.first() ? std::min(xi + period, space.last())
                                : xi;
  };
  const auto locate = [&](double xi, int order, FaceGeometry<2>& point) {
    surface.locate(surface.first_element(sheet) + space.find_element(wrapped(xi)), FaceCoordinates<2>(wrapped(xi)),
                   order, point);
  };
  FaceGeometry<2> point;
  locate(slip(0), 0, point);
  const double present = (point.position - foot.position).norm();
  if (!(present > length)) return slip;
  double xi = inner + (outer - inner) * length / present; // exact for a straight line with linear parametrization
  for (int iteration = 0; iteration < 100; ++iteration) {
    locate(xi, 1, point);
    const Vec<2> chord = point.position - foot.position;
    const double distance = chord.norm(), h = distance - length;
    if (std::abs(h) <= slip_rounding * distance || std::abs(outer - inner) <= slip_rounding * period) break;
    (h > 0 ? outer : inner) = xi;
    // h'(ξ) = (x(ξ) − x̄)·τ/|x(ξ) − x̄|
    const double next = xi - h * distance / chord.dot(point.tangent[0]);
    const bool inside = (next - outer) * (next - inner) < 0;
    const double previous = xi;
    xi = inside ? next : 0.5 * (outer + inner);
    if (xi == previous) break;
  }
  return FaceCoordinates<2>(wrapped(xi));
}

FaceCoordinates<3> advance_smoothly(const Surface<3>& surface, const FaceCoordinates<3>& slip,
                                    const FaceGeometry<3>& foot, double length) {
  return along_chord(surface, slip, foot, length);
}

/// Side by side of the kinks between foot and slip point.
template <int D>
FaceCoordinates<D> advance(const Surface<D>& surface, const FaceCoordinates<D>& slip, FaceGeometry<D> foot,
                           double length) {
  for (const Kink<D>& kink : kinks_between(surface, foot, slip)) {
    FaceGeometry<D> border;
    surface.locate(kink.far.element, kink.far.xi, 0, border);
    const double distance = (border.position - foot.position).norm();
    if (length <= distance) return advance_smoothly(surface, kink.near.xi, foot, length);
    length -= distance;
    foot = border;
  }
  return advance_smoothly(surface, slip, foot, length);
}

} // namespace

FaceCoordinates<2> advance_slip(const Surface<2>& surface, const FaceCoordinates<2>& slip, const FaceGeometry<2>& foot,
                                double length) {
  return advance(surface, slip, foot, length);
}

FaceCoordinates<3> advance_slip(const Surface<3>& surface, const FaceCoordinates<3>& slip, const FaceGeometry<3>& foot,
                                double length) {
  return advance(surface, slip, foot, length);
}

} // namespace signorini::contact
