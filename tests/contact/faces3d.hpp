#pragma once
// Solids whose back face (ξ³ at its end) is a given surface.

#include "contact/faces.hpp"

namespace signorini::contact::test {

/// A plate of unit thickness below a surface, without refinement. The surface is its back face, with the outside above
/// if ξ¹, ξ² run like x, y.
inline nurbs::Discretization below(const std::vector<nurbs::KnotVector>& knots, const MatrixX& points,
                                   const VectorX& weights) {
  const int n = static_cast<int>(points.cols());
  MatrixX both(3, 2 * n);
  both << points.colwise() - Eigen::Vector3d(0, 0, 1), points;
  VectorX twice(2 * n);
  twice << weights, weights;
  const nurbs::Patch patch = nurbs::make_patch({knots[0], knots[1], nurbs::KnotVector::single(1)}, both, twice);
  nurbs::Plan plan;
  plan.elements = {knots[0].elements(), knots[1].elements(), 1};
  plan.contact = {nurbs::side_of("back", 3)};
  plan.labels = {nurbs::parse_label(text("N", knots[0].degree())), nurbs::parse_label(text("N", knots[1].degree()))};
  plan.thickness_degree = 1;
  return {patch, plan};
}

/// A random wavy rational surface over [0, length]², with kinks where a knot is repeated degree times.
inline nurbs::Discretization wavy_plate(Random& random, double length, double amplitude, int degree, int breaks) {
  const std::vector<nurbs::KnotVector> knots = {nurbs::test::random_knots(random, degree, breaks),
                                                nurbs::test::random_knots(random, degree, breaks)};
  const int nu = knots[0].functions(), nv = knots[1].functions();
  MatrixX points(3, nu * nv);
  VectorX weights(nu * nv);
  for (int j = 0; j < nv; ++j)
    for (int i = 0; i < nu; ++i) {
      const bool inner_u = i > 0 && i + 1 < nu, inner_v = j > 0 && j + 1 < nv;
      points.col(i + nu * j) << length * (i + (inner_u ? uniform(random, -0.2, 0.2) : 0)) / (nu - 1),
          length * (j + (inner_v ? uniform(random, -0.2, 0.2) : 0)) / (nv - 1), uniform(random, -amplitude, amplitude);
      weights(i + nu * j) = uniform(random, 0.7, 1.4);
    }
  return below(knots, points, weights);
}

inline Surface<3> top_of(const nurbs::Discretization& plate) {
  return {plate, nurbs::side_of("back", 3)};
}

} // namespace signorini::contact::test
