#include "contact/closest/projection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini::contact {

namespace {

using CurveCoordinates = FaceCoordinates<2>;

/// Where a search within one element ended.
enum class Stop { inside, start, end };

/// Half the derivative of the squared distance, −(x − x(ξ))·τ.
double slope(const Vec<2>& x, const FaceGeometry<2>& point) {
  return (point.position - x).dot(point.tangent[0]);
}

/// Minimizes the distance within one element by Newton's method, safeguarded by Gauss–Newton, the element's ends and,
/// once both signs of the slope have occurred, bisection. Leaves the face's geometry at the minimum in `point` (order
/// 2).
Stop descend(const Surface<2>& surface, const Vec<2>& x, int element, double start, FaceGeometry<2>& point) {
  const auto [a, b] = surface.interval(element, 0);
  double xi = std::clamp(start, a, b), low = a, high = b;
  bool falls = false, rises = false; // at low, at high
  for (int iteration = 0;; ++iteration) {
    surface.locate(element, CurveCoordinates(xi), 2, point);
    point.settled = true;
    const double gradient = slope(x, point);
    if (xi <= a && gradient > 0) return Stop::start;
    if (xi >= b && gradient < 0) return Stop::end;
    (gradient > 0 ? high : low) = xi;
    (gradient > 0 ? rises : falls) = true;
    // ξ ← ξ − f'/f'',  f' = (x(ξ) − x)·τ,  f'' = τ·τ + (x(ξ) − x)·x_,11; τ·τ in place of f'' if that is negative, or
    // small and the step long
    const double metric = point.tangent[0].squaredNorm();
    const double curvature = metric + (point.position - x).dot(point.second[0]);
    const bool trusted = curvature > trusted_curvature * metric ||
                         (curvature > 0 && std::abs(gradient) < short_step * (b - a) * curvature);
    const double slowness = trusted ? curvature : metric; // 0 where the parametrization is singular
    const double step = slowness > 0 ? -gradient / slowness : 0;
    double next = std::clamp(xi + step, a, b);
    // Each step squares the error: after one of 1e-8 of the element rounding error is left. A step out of the element
    // does not end the search; at the element's end the slope decides.
    const bool done = (std::abs(step) <= last_step * (b - a) && next == xi + step) || iteration == most_foot_iterations;
    point.settled = std::abs(step) <= foot_tolerance * (b - a);
    if (done && std::abs(next - xi) <= exact_shift * (b - a)) {
      // A first-order shift is exact up to rounding error.
      point.position += (next - xi) * point.tangent[0];
      point.tangent[0] += (next - xi) * point.second[0];
      point.xi(0) = next;
      return Stop::inside;
    }
    if (!done && falls && rises && (next <= low || next >= high || (iteration > 8 && iteration % 3 == 0)))
      next = 0.5 * (low + high);
    xi = next;
    if (done) {
      surface.locate(element, CurveCoordinates(xi), 2, point);
      return Stop::inside;
    }
  }
}

/// Descends along the curve from one element to the next until the distance increases in both directions.
Foot walk(const Surface<2>& surface, const Vec<2>& x, int element, double start, FaceGeometry<2>& point) {
  Stop stop = descend(surface, x, element, start, point);
  for (int moves = 0; stop != Stop::inside && moves < surface.elements(); ++moves) {
    const bool forward = stop == Stop::end;
    const Entry<2> next = across(surface, element, 0, forward, point.xi);
    if (next.element < 0) return Foot::none;
    FaceGeometry<2> beyond;
    const Stop other = descend(surface, x, next.element, next.xi(0), beyond);
    if (other == (next.at_end ? Stop::end : Stop::start)) {
      // The distance increases on both sides of the border: a kink, or on a smooth curve a minimum at the border up to
      // rounding error.
      const double sine = std::abs(point.tangent[0].normalized().dot(
          Vec<2>(-beyond.tangent[0].normalized()(1), beyond.tangent[0].normalized()(0))));
      return sine < same_place ? Foot::regular : Foot::corner;
    }
    element = next.element;
    point = beyond;
    stop = other;
  }
  if (stop == Stop::inside) return Foot::regular;
  point.settled = false;
  return Foot::none;
}

/// Calls search(ξ) at those of 3(degree+1) equidistant points of an element that are nearer to x than their neighbors,
/// because the squared distance to one polynomial piece can have several minima.
template <class Search> void each_start(const Surface<2>& surface, const Vec<2>& x, int element, Search search) {
  const auto [a, b] = surface.interval(element, 0);
  const int count = 3 * surface.degree(element, 0) + 3;
  double positions[2 * grid_points], distances[grid_points];
  sample(surface.bezier(element), positions);
  for (int k = 0; k < count; ++k) {
    const double u = positions[k] - x(0), v = positions[count + k] - x(1);
    distances[k] = u * u + v * v;
  }
  for (int k = 0; k < count; ++k)
    if ((k == 0 || distances[k] <= distances[k - 1]) && (k == count - 1 || distances[k] < distances[k + 1]))
      search(a + (b - a) * k / (count - 1));
}

/// Signed gap at the closest point. At a corner the sum of the two one-sided normals determines the side of x.
double signed_gap(const Surface<2>& surface, const Vec<2>& x, Foot foot, const FaceGeometry<2>& point) {
  const Vec<2> difference = x - point.position;
  Vec<2> normal = outward(surface, point).normalized();
  if (foot == Foot::regular) return difference.dot(normal);
  if (foot == Foot::corner) {
    const bool at_end = point.xi(0) >= surface.interval(point.element, 0)[1];
    const Entry<2> other = across(surface, point.element, 0, at_end, point.xi);
    if (other.element >= 0) {
      FaceGeometry<2> beyond;
      surface.locate(other.element, other.xi, 1, beyond);
      normal += outward(surface, beyond).normalized();
    }
  }
  return std::copysign(difference.norm(), difference.dot(normal));
}

/// True if a local minimum counts for a point of a set.
bool counts(const Surface<2>& surface, const Vec<2>& x, Foot foot, const FaceGeometry<2>& point, const Lookout<2>& from,
            bool kept) {
  if (!from.set) return true;
  const double gap = signed_gap(surface, x, foot, point);
  const bool regular = foot == Foot::regular || foot == Foot::none;
  return admissible<2>(from, point,
                       regular ? Vec<2>(outward(surface, point).normalized()) : Vec<2>((x - point.position) / gap), gap,
                       kept);
}

} // namespace

void walk(const Surface<2>& surface, const Vec<2>& x, int element, const FaceCoordinates<2>& start,
          FaceGeometry<2>& point) {
  walk(surface, x, element, start(0), point);
}

Projection<2> project(const Surface<2>& surface, const ElementBoxes<2>& boxes, const Vec<2>& x,
                      const Projection<2>& seed, FaceGeometry<2>& point, const Lookout<2>& from) {
  Projection<2> best;
  double nearest = from.farthest * from.farthest;
  bool settled = false, found = false; // settled: the foot point's element and its neighbors need no further search
  FaceGeometry<2> candidate;
  if (seed.element >= 0) {
    const Foot foot = walk(surface, x, seed.element, seed.xi(0), candidate);
    const double distance2 = (x - candidate.position).squaredNorm();
    if (distance2 < nearest && counts(surface, x, foot, candidate, from, seed.gap < 0)) {
      found = true;
      nearest = distance2;
      best.foot = foot;
      point = candidate;
      settled = foot == Foot::regular && point.settled && nearest < boxes.unique_distance2(point.element);
    }
  }
  const int home = settled ? point.element : -1;

  // A minimum on a border is reached from both sides; the factor keeps rounding error from choosing one.
  boxes.near(
      x, from.sight, [&] { return nearest * (1 - same_distance); },
      [&](int e) {
        if (settled && smoothly_adjacent(surface, home, e)) return;
        if (from.set && boxes.is_behind(surface, e, x, deepest_part * from.set->thickness[surface.sheet(e)])) return;
        each_start(surface, x, e, [&](double start) {
          const Foot foot = walk(surface, x, e, start, candidate);
          const double distance2 = (x - candidate.position).squaredNorm();
          if (distance2 >= nearest * (1 - same_distance) || !counts(surface, x, foot, candidate, from, false)) return;
          found = true;
          nearest = distance2;
          best.foot = foot;
          point = candidate;
        });
      });

  if (!found && from.set) return nothing_near<2>();
  if (!found) { // squares of distances overflow
    surface.locate(0, FaceCoordinates<2>(surface.interval(0, 0)[0]), 2, point);
    return {Foot::none, 0, 0, point.xi, std::numeric_limits<double>::max(), 0};
  }
  best.element = point.element;
  best.xi = point.xi;
  best.gap = signed_gap(surface, x, best.foot, point);
  return best;
}

} // namespace signorini::contact
