#pragma once
// Bodies whose north or south face is a given curve, and dense assembly of a contact's blocks.

#include "base/groups.hpp"
#include "contact/gauss/block_dofs.hpp"
#include "contact/pair.hpp"
#include "nurbs/coincident.hpp"
#include "nurbs/random_patch.hpp"
#include "nurbs/shapes.hpp"

namespace signorini::contact::test {

using nurbs::test::integer;
using nurbs::test::Random;
using nurbs::test::uniform;

inline nurbs::Discretization discretize(const nurbs::Patch& patch, std::vector<int> elements, const std::string& label,
                                        const std::string& contact) {
  nurbs::Plan plan;
  plan.elements = std::move(elements);
  plan.contact = {nurbs::side_of(contact, patch.dimension())};
  plan.labels.assign(static_cast<std::size_t>(patch.dimension()) - 1, nurbs::parse_label(label));
  plan.thickness_degree = 1;
  return {patch, plan};
}

/// Numbers of a face's control points, equal where they share unknowns.
inline std::vector<int> shared_numbers(const nurbs::Discretization& body, nurbs::Side side) {
  Groups groups(body.functions());
  for (const std::vector<int>& group : nurbs::coincident_functions(body))
    for (const int function : group) groups.unite(group.front(), function);
  std::vector<int> numbers = body.face_functions(side);
  for (int& number : numbers) number = groups.leader(number);
  return numbers;
}

/// A strip of unit thickness below a curve, without refinement. The curve is its north face, with the outside above for
/// a curve that runs to the right.
inline nurbs::Discretization below(const nurbs::KnotVector& knots, const MatrixX& points, const VectorX& weights) {
  const int n = knots.functions();
  MatrixX both(2, 2 * n);
  both << points.colwise() - Eigen::Vector2d(0, 1), points;
  VectorX twice(2 * n);
  twice << weights, weights;
  return discretize(nurbs::make_patch({knots, nurbs::KnotVector::single(1)}, both, twice), {knots.elements(), 1},
                    text("N", knots.degree()), "north");
}

/// A random wavy rational curve from x = 0 to `length`, with kinks where a knot is repeated degree times.
inline nurbs::Discretization wavy(Random& random, double length, double amplitude, int degree, int breaks) {
  const nurbs::KnotVector knots = nurbs::test::random_knots(random, degree, breaks);
  const int n = knots.functions();
  MatrixX points(2, n);
  VectorX weights(n);
  for (int i = 0; i < n; ++i) {
    points.col(i) << length * (i + (i > 0 && i + 1 < n ? uniform(random, -0.4, 0.4) : 0)) / (n - 1),
        uniform(random, -amplitude, amplitude);
    weights(i) = uniform(random, 0.6, 1.5);
  }
  return below(knots, points, weights);
}

/// A polyline as a degree-1 face.
inline nurbs::Discretization polyline(const std::vector<Eigen::Vector2d>& points) {
  std::vector<double> knots{0};
  for (std::size_t i = 0; i < points.size(); ++i) knots.push_back(static_cast<double>(i));
  knots.push_back(knots.back());
  MatrixX columns(2, static_cast<int>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) columns.col(static_cast<int>(i)) = points[i];
  return below({1, knots}, columns, VectorX::Ones(columns.cols()));
}

/// Residual and tangent of a contact over all degrees of freedom: those of the slave body, then those of the master
/// body or the obstacle's translation.
struct Dense {
  VectorX force;
  MatrixX tangent;
};

/// `with_tangent`: whether it was evaluated; otherwise it is empty.
template <int D> Dense dense(const Pair<D>& pair, int slave_dofs, int master_dofs, bool with_tangent = true) {
  const int size = slave_dofs + master_dofs + pair.extra_unknowns();
  Dense sum{VectorX::Zero(size), {}};
  if (with_tangent) sum.tangent.setZero(size, size);
  std::vector<int> dofs;
  for (const Block& block : pair.blocks()) {
    dofs.clear();
    append_dofs(pair.formulation().faces(), block, {slave_dofs, slave_dofs + master_dofs}, dofs);
    for (int r = 0; r < block.rows; ++r) {
      const std::size_t row = static_cast<std::size_t>(r);
      sum.force(dofs[row]) += block.force[row];
      for (int c = 0; with_tangent && c < block.columns; ++c)
        sum.tangent(dofs[row], dofs[static_cast<std::size_t>(c)]) +=
            block.matrix[row * static_cast<std::size_t>(block.columns) + static_cast<std::size_t>(c)];
    }
  }
  return sum;
}

} // namespace signorini::contact::test
