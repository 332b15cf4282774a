#pragma once
// Slip points that follow the projection of a chord onto a shape.

#include "contact/constants.hpp"
#include "contact/face/surface.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace signorini::contact {

/// The point of a shape at distance `length` from `foot`: the closest point to a point of the chord from `foot` to
/// `slip`, positions in the shape's own frame. None if the chord leads too far from the shape.
template <class Shape, int D>
std::optional<MasterPoint<D>> point_on_chord(const Shape& shape, const Vec<D>& foot, const Vec<D>& slip,
                                             double length) {
  const Vec<D> chord = slip - foot;
  const double present = chord.norm();
  FacePoint<D> point;
  double distance = 0;
  // y = x̄ + c (x_sl − x̄)/|x_sl − x̄|; c is slightly less than |x − x̄| on a curved shape. Secant steps, after a first one
  // through c = |x − x̄| = 0.
  double on_chord = length, before = 0, distance_before = 0;
  for (int iteration = 0; iteration < 30; ++iteration) {
    find_closest(shape, Vec<D>(foot + (on_chord / present) * chord), point);
    locate(shape, point);
    distance = (point.position - foot).norm();
    if (!(distance > 0) || std::abs(distance - length) <= slip_rounding * present) break;
    const double slope = (distance - distance_before) / (on_chord - before);
    before = on_chord;
    distance_before = distance;
    on_chord = std::min(on_chord + (length - distance) / (slope > 0 ? slope : 1), present);
  }
  if (std::abs(distance - length) > slip_tolerance * present) return std::nullopt;
  return MasterPoint<D>(point.xi, point.last);
}

} // namespace signorini::contact
