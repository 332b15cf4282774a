#include "contact/closest/projection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini::contact {

namespace {

using Coordinates = FaceCoordinates<3>;
using Interval = std::array<double, 2>;

/// Active bound per direction: −1 (+1) if the element's start (end) stops the search, 0 if none does.
using EdgeStop = std::array<int, 2>;

/// Newton step for the squared distance in the directions without an active bound; the Gauss–Newton step where the
/// distance has negative curvature, or small curvature and the step exceeds a hundredth of the element's length `size`.
Coordinates newton_step(const Vec<3>& difference, const FaceGeometry<3>& point, const Coordinates& gradient,
                        const EdgeStop& active, const Coordinates& size) {
  // f = |x(ξ) − x|²/2,  f_,α = (x(ξ) − x)·τ_α,  f_,αβ = τ_α·τ_β + (x(ξ) − x)·x_,αβ
  Mat<2> metric, hessian;
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b) {
      metric(a, b) = point.tangent[a].dot(point.tangent[b]);
      hessian(a, b) = metric(a, b) + difference.dot(point.second[a + b]);
    }
  for (int a = 0; a < 2; ++a)
    if (active[a] != 0) {
      const int b = 1 - a;
      if (active[b] != 0) return Coordinates::Zero();
      Coordinates step = Coordinates::Zero();
      if (hessian(b, b) > 0) step(b) = -gradient(b) / hessian(b, b);
      if (hessian(b, b) > trusted_curvature * metric(b, b) ||
          (hessian(b, b) > 0 && std::abs(step(b)) < short_step * size(b)))
        return step;
      if (metric(b, b) > 0) step(b) = -gradient(b) / metric(b, b);
      return step;
    }
  const Mat<2> margin = hessian - trusted_curvature * metric;
  if (hessian(0, 0) > 0 && hessian.determinant() > 0) {
    const Coordinates step = -hessian.inverse() * gradient;
    if ((margin(0, 0) > 0 && margin.determinant() > 0) || (step.cwiseAbs().array() < short_step * size.array()).all())
      return step;
  }
  // Next to a pole the metric itself is close to singular.
  metric += pole_metric * metric.trace() * Mat<2>::Identity();
  return -metric.inverse() * gradient;
}

/// Largest fraction of the step, at most 1, that stays inside the element.
double allowed(const Coordinates& xi, const Coordinates& step, const std::array<Interval, 2>& box) {
  double fraction = 1;
  for (int a = 0; a < 2; ++a) {
    if (step(a) > 0) fraction = std::min(fraction, (box[a][1] - xi(a)) / step(a));
    if (step(a) < 0) fraction = std::min(fraction, (box[a][0] - xi(a)) / step(a));
  }
  return fraction;
}

/// True if moving inward from the active bounds does not reduce the distance, except by rounding error.
bool is_least_at(const EdgeStop& bounds, const Vec<3>& difference, const FaceGeometry<3>& point,
                 const Coordinates& length) {
  for (int a = 0; a < 2; ++a) {
    const Vec<3>& tangent = point.tangent[a];
    if (bounds[a] * difference.dot(tangent) > border_slack * length(a) * tangent.squaredNorm()) return false;
  }
  return true;
}

/// Minimizes the distance within one element by Newton's method with active bounds and step halving. Returns the bounds
/// that stop the last step and leaves the face's geometry there in `point` (order 2).
EdgeStop descend(const Surface<3>& surface, const Vec<3>& x, int element, const Coordinates& start,
                 FaceGeometry<3>& point) {
  const std::array<Interval, 2> box = {surface.interval(element, 0), surface.interval(element, 1)};
  const Coordinates length(box[0][1] - box[0][0], box[1][1] - box[1][0]);
  Coordinates xi;
  for (int a = 0; a < 2; ++a) xi(a) = std::clamp(start(a), box[a][0], box[a][1]);
  surface.locate(element, xi, 2, point);
  for (int iteration = 0;; ++iteration) {
    const Vec<3> difference = point.position - x;
    const Coordinates gradient(difference.dot(point.tangent[0]), difference.dot(point.tangent[1]));
    // A bound is active if the distance decreases beyond it, and also if the step would cross it.
    EdgeStop active{};
    for (int a = 0; a < 2; ++a)
      active[a] = xi(a) <= box[a][0] && gradient(a) > 0 ? -1 : xi(a) >= box[a][1] && gradient(a) < 0 ? 1 : 0;
    EdgeStop extended = active;
    Coordinates step = newton_step(difference, point, gradient, active, length);
    for (int a : {0, 1, 0})
      if ((xi(a) <= box[a][0] && step(a) < 0) || (xi(a) >= box[a][1] && step(a) > 0)) {
        extended[a] = step(a) < 0 ? -1 : 1;
        step = newton_step(difference, point, gradient, extended, length);
      }
    const double size = step.cwiseQuotient(length).cwiseAbs().maxCoeff(); // of the step, in elements
    const double fraction = allowed(xi, step, box);
    // A border in the way would shorten the step in both directions: it is searched along first.
    if ((size <= last_step && fraction == 1) || iteration == most_foot_iterations) {
      // The last step squares the error down to rounding error, which is also the error of the first-order shift below.
      point.settled = size <= foot_tolerance;
      step *= fraction;
      xi += step;
      for (int a = 0; a < 2; ++a) xi(a) = std::clamp(xi(a), box[a][0], box[a][1]);
      point.xi = xi;
      for (int a = 0; a < 2; ++a) point.position += step(a) * point.tangent[a];
      for (int a = 0; a < 2; ++a)
        for (int b = 0; b < 2; ++b) point.tangent[a] += step(b) * point.second[a + b];
      // A step along a border may turn the distance's slope across it: the minimum is then inside.
      if (iteration == most_foot_iterations || is_least_at(extended, point.position - x, point, length))
        return extended;
      surface.locate(element, xi, 2, point);
      continue;
    }
    // Backtracking until Armijo's condition holds, up to rounding error: the last steps towards a far point, whose
    // effect on the distance it exceeds, must not be shortened.
    const double before = difference.squaredNorm() / 2, slope = gradient.dot(step);
    const double most = before * (1 + distance_rounding);
    double scale = fraction;
    for (int halving = 0;; ++halving, scale /= 2) {
      Coordinates next = xi + scale * step;
      for (int a = 0; a < 2; ++a) {
        // Steps that end at a border must end exactly on it.
        const double from = box[a][0], to = box[a][1], slack = border_slack * length(a);
        next(a) = next(a) < from + slack ? from : next(a) > to - slack ? to : next(a);
      }
      surface.locate(element, next, 2, point);
      if ((point.position - x).squaredNorm() / 2 <= most + sufficient_decrease * scale * slope ||
          halving == most_halvings) {
        xi = next;
        break;
      }
    }
  }
}

/// True if an element's border at the start or end of direction α is collapsed to one point.
bool collapsed(const Surface<3>& surface, int element, int alpha, bool at_end) {
  Vec<3> lower, upper;
  bounds(surface.bezier(element), lower, upper);
  const auto along = surface.interval(element, 1 - alpha);
  Coordinates xi;
  xi(alpha) = surface.interval(element, alpha)[at_end ? 1 : 0];
  FaceGeometry<3> first, other;
  xi(1 - alpha) = along[0];
  surface.locate(element, xi, 0, first);
  for (double t : border_probes) {
    xi(1 - alpha) = along[0] + t * (along[1] - along[0]);
    surface.locate(element, xi, 0, other);
    if ((other.position - first.position).norm() > same_place * (upper - lower).norm()) return false;
  }
  return true;
}

/// Unit normal at a point of an element, or slightly inward where the tangents do not span a plane.
Vec<3> normal_near(const Surface<3>& surface, int element, Coordinates xi) {
  FaceGeometry<3> point;
  for (const double t : inward_probes) {
    Coordinates inward = xi;
    for (int a = 0; a < 2; ++a) {
      const auto [from, to] = surface.interval(element, a);
      inward(a) += t * ((from + to) / 2 - xi(a));
    }
    surface.locate(element, inward, 1, point);
    const Vec<3> normal = outward(surface, point);
    if (normal.norm() > least_sine * point.tangent[0].norm() * point.tangent[1].norm() && normal.norm() > 0)
      return normal.normalized();
  }
  return Vec<3>::Zero();
}

/// Signed gap at a closest point. If the line to the closest point is not normal to the face, the normals of the
/// adjacent elements determine the side of x.
double signed_gap(const Surface<3>& surface, const Vec<3>& x, Foot foot, const FaceGeometry<3>& point) {
  const Vec<3> difference = x - point.position;
  if (foot == Foot::regular) return difference.dot(outward(surface, point).normalized());
  Vec<3> normal = normal_near(surface, point.element, point.xi);
  for (int a = 0; a < 2; ++a) {
    const auto [from, to] = surface.interval(point.element, a);
    for (bool at_end : {false, true}) {
      if (point.xi(a) != (at_end ? to : from)) continue;
      const Entry<3> other = across(surface, point.element, a, at_end, point.xi);
      if (other.element >= 0) normal += normal_near(surface, other.element, other.xi);
    }
  }
  return std::copysign(difference.norm(), difference.dot(normal));
}

/// Calls search(ξ) at the points of a grid on an element that are nearer to x than their neighbors, because the squared
/// distance to one polynomial piece can have several minima. Points from which all neighbors are too near to find a
/// distance below √distance2() between them are left out, and those next to `found`, to which they lead.
template <class Distance2, class Search>
void each_start(const Surface<3>& surface, const Vec<3>& x, int element, const FaceGeometry<3>* found,
                const Distance2& distance2, const Search& search) {
  constexpr int most = grid_points;
  const int n0 = 3 * surface.degree(element, 0) + 3, n1 = 3 * surface.degree(element, 1) + 3, size = n0 * n1;
  const auto [a, b] = surface.interval(element, 0);
  const auto [c, d] = surface.interval(element, 1);
  double positions[3 * most * most], distances[most * most];
  sample(surface.bezier(element), positions);
  const double *px = positions, *py = positions + size, *pz = positions + 2 * size;
  const auto distance = [&](int k, double from_x, double from_y, double from_z) {
    const double u = px[k] - from_x, v = py[k] - from_y, w = pz[k] - from_z;
    return u * u + v * v + w * w;
  };
  for (int k = 0; k < size; ++k) distances[k] = distance(k, x(0), x(1), x(2));
  const bool here_found = found && found->element == element;
  // No neighbor is farther from a point than the longest step of the grid in one direction plus that in the other.
  double step[2] = {0, 0};
  for (int j = 0; j < n1; ++j)
    for (int i = 0; i + 1 < n0; ++i) {
      const int k = i + n0 * j;
      step[0] = std::max(step[0], distance(k, px[k + 1], py[k + 1], pz[k + 1]));
    }
  for (int k = 0; k + n0 < size; ++k) step[1] = std::max(step[1], distance(k, px[k + n0], py[k + n0], pz[k + n0]));
  const double reach = std::sqrt(step[0]) + std::sqrt(step[1]) + std::sqrt(distance2());
  const double farthest = reach * reach;
  for (int j = 0; j < n1; ++j)
    for (int i = 0; i < n0; ++i) {
      const int here = i + n0 * j;
      if (distances[here] > farthest) continue;
      const int left = std::max(i - 1, 0), right = std::min(i + 1, n0 - 1);
      const int below = std::max(j - 1, 0), above = std::min(j + 1, n1 - 1);
      bool least = true;
      for (int k = below; least && k <= above; ++k)
        for (int l = left; least && l <= right; ++l) {
          const int there = l + n0 * k;
          // The first of equal distances is taken.
          least = distances[here] < distances[there] || (distances[here] == distances[there] && here <= there);
        }
      if (!least) continue;
      double reach2 = 0; // squared distance to the farthest neighbor
      for (int k = below; k <= above; ++k)
        for (int l = left; l <= right; ++l)
          reach2 = std::max(reach2, distance(l + n0 * k, px[here], py[here], pz[here]));
      if (std::sqrt(distances[here]) - std::sqrt(reach2) > std::sqrt(distance2())) continue;
      const double du = (b - a) / (n0 - 1), dv = (d - c) / (n1 - 1);
      const Coordinates xi(a + du * i, c + dv * j);
      // A point nearer than the one found leads to another.
      if (here_found && distances[here] >= distance2() && std::abs(found->xi(0) - xi(0)) <= du &&
          std::abs(found->xi(1) - xi(1)) <= dv)
        continue;
      search(xi);
    }
}

/// True if the tangents do not span a plane, as at the pole of a sphere.
bool degenerate(const Surface<3>& surface, const ElementBoxes<3>& boxes, const FaceGeometry<3>& point) {
  double area = point.tangent[0].cross(point.tangent[1]).norm();
  for (int a = 0; a < 2; ++a) {
    const auto [from, to] = surface.interval(point.element, a);
    area *= to - from;
  }
  return !(area > same_place * boxes.diagonal2(point.element));
}

/// The local minimum of the distance reached by descent from an element and parameter; returns the bounds of the
/// element that are active there.
EdgeStop approach(const Surface<3>& surface, const Vec<3>& x, int element, const Coordinates& start,
                  FaceGeometry<3>& point) {
  EdgeStop active = descend(surface, x, element, start, point);
  if (active == EdgeStop{}) return active;
  FaceGeometry<3> beyond;
  bool moved = true;
  int level = 0; // moves that did not reduce the distance
  for (int moves = 0; moved && moves < 2 * surface.elements() + 8; ++moves) {
    moved = false;
    for (int a = 0; a < 2 && !moved; ++a) {
      if (active[a] == 0) continue;
      const Entry<3> next = across(surface, point.element, a, active[a] > 0, point.xi);
      if (next.element < 0) continue;
      const EdgeStop other = descend(surface, x, next.element, next.xi, beyond);
      // Across a smooth border the squared distance may decrease by less than its rounding error, though the foot is
      // still 1e-7 of the distance off: there a search that does not lead back is followed, a few times, so that
      // elements do not lead to each other in turn.
      const double here2 = (point.position - x).squaredNorm(), there2 = (beyond.position - x).squaredNorm();
      const bool nearer = there2 < here2 * (1 - distance_rounding);
      const bool onward = level < most_level_moves && there2 <= here2 * (1 + same_distance) &&
                          other[next.alpha] != (next.at_end ? 1 : -1);
      if (!nearer && !onward) continue;
      level += !nearer;
      point = beyond;
      active = other;
      moved = true;
    }
  }
  if (moved) point.settled = false;
  return active;
}

/// Kind of a local minimum with these active bounds; `along`: the direction of an edge.
Foot kind_of(const Surface<3>& surface, const ElementBoxes<3>& boxes, const EdgeStop& active,
             const FaceGeometry<3>& point, int& along) {
  // An active bound at the minimum is the border of the face, a kink, or due to rounding error.
  bool kink[2] = {false, false}, pole = false;
  for (int a = 0; a < 2; ++a) {
    if (active[a] == 0) continue;
    const bool at_end = active[a] > 0;
    const Entry<3> next = across(surface, point.element, a, at_end, point.xi);
    if (next.element < 0) {
      if (!collapsed(surface, point.element, a, at_end)) return Foot::none;
      pole = true;
    } else {
      const Vec<3> here = normal_near(surface, point.element, point.xi);
      const Vec<3> there = normal_near(surface, next.element, next.xi);
      kink[a] = here.cross(there).norm() >= same_place;
    }
  }
  if (pole || (kink[0] && kink[1])) return Foot::corner;
  if (!kink[0] && !kink[1]) return degenerate(surface, boxes, point) ? Foot::corner : Foot::regular;
  along = kink[0] ? 1 : 0;
  return Foot::edge;
}

/// True if a local minimum counts for a point of a set.
bool counts(const Surface<3>& surface, const Vec<3>& x, Foot foot, const FaceGeometry<3>& point, const Lookout<3>& from,
            bool kept) {
  if (!from.set) return true;
  const double gap = signed_gap(surface, x, foot, point);
  const bool regular = foot == Foot::regular || foot == Foot::none;
  return admissible<3>(from, point,
                       regular ? Vec<3>(outward(surface, point).normalized()) : Vec<3>((x - point.position) / gap), gap,
                       kept);
}

} // namespace

void walk(const Surface<3>& surface, const Vec<3>& x, int element, const Coordinates& start, FaceGeometry<3>& point) {
  approach(surface, x, element, start, point);
}

Projection<3> project(const Surface<3>& surface, const ElementBoxes<3>& boxes, const Vec<3>& x,
                      const Projection<3>& seed, FaceGeometry<3>& point, const Lookout<3>& from) {
  Projection<3> best;
  double nearest = from.farthest * from.farthest;
  bool settled = false, found = false; // settled: the foot point's element and its neighbors need no further search
  FaceGeometry<3> candidate;
  if (seed.element >= 0) {
    const EdgeStop active = approach(surface, x, seed.element, seed.xi, candidate);
    int along = 0;
    const Foot foot = kind_of(surface, boxes, active, candidate, along);
    const double distance2 = (x - candidate.position).squaredNorm();
    if (distance2 < nearest && counts(surface, x, foot, candidate, from, seed.gap < 0)) {
      found = true;
      nearest = distance2;
      best.foot = foot;
      best.along = along;
      point = candidate;
      settled = foot == Foot::regular && point.settled && nearest < boxes.unique_distance2(point.element);
    }
  }
  const int home = settled ? point.element : -1;

  // A minimum on a border is reached from both sides; the factor keeps rounding error from choosing one.
  const auto within = [&] { return nearest * (1 - same_distance); };
  boxes.near(x, from.sight, within, [&](int e) {
    if (settled && smoothly_adjacent(surface, home, e)) return;
    if (from.set && boxes.is_behind(surface, e, x, deepest_part * from.set->thickness[surface.sheet(e)])) return;
    // The plane through the point found, normal to the line to it, separates x from an element that lies behind it.
    if (found) {
      const Vec<3> line = point.position - x;
      if (least_along<3>(surface.bezier(e), line) - line.dot(x) >= std::sqrt(nearest * within())) return;
    }
    each_start(surface, x, e, best.foot == Foot::regular ? &point : nullptr, within, [&](const Coordinates& start) {
      const EdgeStop active = approach(surface, x, e, start, candidate);
      const double distance2 = (x - candidate.position).squaredNorm();
      if (distance2 >= nearest * (1 - same_distance)) return;
      int along = 0;
      const Foot foot = kind_of(surface, boxes, active, candidate, along);
      if (!counts(surface, x, foot, candidate, from, false)) return;
      found = true;
      nearest = distance2;
      best.along = along;
      best.foot = foot;
      point = candidate;
    });
  });

  if (!found && from.set) return nothing_near<3>();
  if (!found) { // squares of distances overflow
    surface.locate(0, Coordinates(surface.interval(0, 0)[0], surface.interval(0, 1)[0]), 2, point);
    return {Foot::none, 0, 0, point.xi, std::numeric_limits<double>::max(), 0};
  }
  best.element = point.element;
  best.xi = point.xi;
  best.gap = signed_gap(surface, x, best.foot, point);
  return best;
}

} // namespace signorini::contact
