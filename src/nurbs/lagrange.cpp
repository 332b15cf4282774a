#include "nurbs/lagrange.hpp"

#include "base/orthonormal.hpp"
#include "nurbs/basis.hpp"

namespace signorini::nurbs {

namespace {

KnotVector lagrange_knots(int degree, const std::vector<double>& breaks) {
  std::vector<double> knots{breaks.front()};
  for (double knot : breaks) knots.insert(knots.end(), degree, knot);
  knots.push_back(breaks.back());
  return {degree, std::move(knots)};
}

/// Replaces values at `places` by Bernstein coefficients along one direction: entries start, start+stride, … of the
/// columns.
void to_coefficients(const KnotVector& knots, const std::vector<double>& places, int start, int stride,
                     MatrixX& values) {
  const int p = knots.degree();
  MatrixX functions(p + 1, p + 1), line(values.rows(), knots.functions());
  for (int i = 0; i < knots.functions(); ++i) line.col(i) = values.col(start + i * stride);
  for (int e = 0; e < knots.elements(); ++e) {
    const int first = e * p;
    for (int k = 0; k <= p; ++k) basis_derivatives(knots, e, places[first + k], 0, functions.col(k).data());
    // v_k = Σ_j B_j(ξ_k) c_j on every span
    const MatrixX inverse = pseudo_inverse(functions.transpose());
    const MatrixX local = line.middleCols(first, p + 1).lazyProduct(inverse.transpose());
    for (int k = 0; k <= p; ++k) values.col(start + (first + k) * stride) = local.col(k);
  }
}

} // namespace

Patch interpolate_lagrange(const Patch& patch, const std::vector<int>& degrees,
                           const std::vector<std::vector<double>>& breaks) {
  const int dimensions = patch.parametric_dimension();
  std::vector<KnotVector> directions;
  std::vector<std::vector<double>> parameters;
  int size = 1;
  for (int d = 0; d < dimensions; ++d) {
    directions.push_back(lagrange_knots(degrees[d], breaks[d]));
    parameters.push_back(sites(spline_space(directions.back())));
    size *= directions.back().functions();
  }

  MatrixX values(patch.dimension(), size);
  VectorX xi(dimensions);
  for (int n = 0; n < size; ++n) {
    for (int d = 0, rest = n; d < dimensions; ++d) {
      const int count = directions[d].functions();
      xi(d) = parameters[d][rest % count];
      rest /= count;
    }
    values.col(n) = evaluate(patch, xi);
  }

  for (int d = 0, stride = 1; d < dimensions; ++d) {
    const KnotVector& knots = directions[d];
    for (int n = 0; n < size; ++n)
      if ((n / stride) % knots.functions() == 0) to_coefficients(knots, parameters[d], n, stride, values);
    stride *= knots.functions();
  }
  return make_patch(std::move(directions), values);
}

} // namespace signorini::nurbs
