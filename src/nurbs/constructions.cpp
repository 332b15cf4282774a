#include "nurbs/constructions.hpp"

#include "base/error.hpp"
#include "nurbs/constants.hpp"
#include "nurbs/curves.hpp"
#include "nurbs/refine.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::nurbs {

namespace {

/// Direction d with its knots mapped linearly to [first, last]; knots that equal one of `known` within rounding error
/// take its value, the others are added to `known`.
KnotVector fitted(const KnotVector& knots, double first, double last, std::vector<double>& known) {
  const double slack = rounding * (last - first);
  std::vector<double> fitted;
  for (double knot : knots.knots()) {
    const double t = (knot - knots.first()) / (knots.last() - knots.first());
    const double moved = (1 - t) * first + t * last;
    const auto match = std::find_if(known.begin(), known.end(), [&](double k) { return std::abs(k - moved) <= slack; });
    fitted.push_back(match == known.end() ? moved : *match);
    if (match == known.end()) known.push_back(moved);
  }
  return {knots.degree(), std::move(fitted)};
}

/// Patch with a new last direction of degree 1 from the control points `start` to `end`.
Patch joined(const Patch& start, const Patch& end) {
  std::vector<KnotVector> directions = start.directions();
  directions.push_back(KnotVector::single(1));
  MatrixX homogeneous(start.dimension() + 1, 2 * start.functions());
  homogeneous << start.homogeneous(), end.homogeneous();
  return {std::move(directions), std::move(homogeneous)};
}

} // namespace

void unify(const std::vector<Along>& all) {
  const KnotVector lead = all.front().patch->direction(all.front().direction);
  int degree = 1;
  for (const auto& [patch, d] : all) degree = std::max(degree, patch->direction(d).degree());

  std::vector<double> known = lead.breaks();
  for (const auto& [patch, d] : all) {
    std::vector<KnotVector> directions = patch->directions();
    KnotVector& own = directions[d];
    own = fitted(own, lead.first(), lead.last(), known);
    const int times = degree - own.degree();
    *patch = elevate({std::move(directions), patch->homogeneous()}, d, times);
  }
  for (double knot : known) {
    int most = 0;
    for (const auto& [patch, d] : all) most = std::max(most, patch->direction(d).multiplicity(knot));
    for (const auto& [patch, d] : all) {
      const int missing = most - patch->direction(d).multiplicity(knot);
      *patch = insert_knots(*patch, d, std::vector<double>(missing, knot));
    }
  }
}

Patch ruled(const Patch& a, const Patch& b) {
  require(a.dimension() == b.dimension(), "nurbs.ruled.dimension",
          {{"first", a.dimension()}, {"second", b.dimension()}});
  require(a.parametric_dimension() == b.parametric_dimension(), "nurbs.ruled.directions",
          {{"first", a.parametric_dimension()}, {"second", b.parametric_dimension()}});
  require(a.parametric_dimension() <= 2, "nurbs.ruled.volumes");
  Patch start = a, end = b;
  for (int d = 0; d < a.parametric_dimension(); ++d) unify({{&start, d}, {&end, d}});
  return joined(start, end);
}

Patch extrude(const Patch& patch, const Point& along) {
  check_point("along", along, along.size() == 3 || patch.dimension() == 3 ? 3 : 2);
  require(along.norm() > 0, "nurbs.extrude.length");
  require(patch.parametric_dimension() <= 2, "nurbs.extrude.volume");
  const MatrixX into = MatrixX::Identity(along.size(), patch.dimension());
  return joined(transform(patch, into, VectorX::Zero(along.size())), transform(patch, into, along));
}

Patch revolve(const Patch& patch, const Point& point, const Point& axis, double angle) {
  require(patch.dimension() == 3 && patch.parametric_dimension() <= 2, "nurbs.revolve.patch",
          {{"directions", patch.parametric_dimension()}, {"dimension", patch.dimension()}});
  check_point("point", point, 3);
  require(std::isfinite(angle) && angle != 0 && std::abs(angle) <= 360, "nurbs.revolve.angle", {{"angle", angle}});
  const Patch turn = arc(Point::Zero(2), 1, 0, angle);
  const Mat<3> quarter = rotation(90, axis);
  const Vec<3> a = axis.normalized();

  std::vector<KnotVector> directions = patch.directions();
  directions.push_back(turn.direction(0));
  MatrixX homogeneous(4, patch.functions() * turn.functions());
  for (int k = 0; k < turn.functions(); ++k)
    for (int n = 0; n < patch.functions(); ++n) {
      // Arc point (X, Y, W), homogeneous: x = foot on the axis, r = radial part, Q r = r turned by 90°;
      // the new point is w (W x + X r + Y Q r, W), all products of homogeneous coordinates (NURBS Book, 8.5).
      const Vec<3> arm = turn.homogeneous().col(k);
      const double w = patch.homogeneous()(3, n);
      const Vec<3> from_point = patch.homogeneous().col(n).head<3>() - w * point;
      const Vec<3> foot = a * a.dot(from_point), radial = from_point - foot;
      const Vec<3> turned = arm(2) * (foot + w * point) + arm(0) * radial + arm(1) * (quarter * radial);
      homogeneous.col(n + patch.functions() * k) << turned, arm(2) * w;
    }
  return {std::move(directions), std::move(homogeneous)};
}

} // namespace signorini::nurbs
