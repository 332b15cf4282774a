#include "nurbs/basis.hpp"

#include "base/error.hpp"
#include "nurbs/bezier.hpp"

#include <algorithm>

namespace signorini::nurbs {

void basis_derivatives(const KnotVector& knots, int element, double xi, int order, double* out) {
  const int p = knots.degree();
  const int i = knots.span(element);
  const double* u = knots.knots().data() + i;

  // values[q][s] = N_{i−q+s, q}(ξ), and inverse[q][s] = 1/(ξ_{i+1+s} − ξ_{i+1−q+s}), the reciprocal length of the
  // support of N_{i−q+1+s, q−1}. Lower triangles; entries above the diagonal are not read.
  double values[max_degree + 1][max_degree + 1], inverse[max_degree + 1][max_degree + 1];
  values[0][0] = 1;
  for (int q = 1; q <= p; ++q) {
    // N_{i,q} = (ξ−ξ_i)/(ξ_{i+q}−ξ_i) N_{i,q−1} + (ξ_{i+q+1}−ξ)/(ξ_{i+q+1}−ξ_{i+1}) N_{i+1,q−1}   (NURBS Book, eq. 2.5)
    double carried = 0;
    for (int s = 0; s < q; ++s) {
      const double left = u[1 + s - q], right = u[1 + s];
      inverse[q][s] = 1 / (right - left);
      const double share = values[q - 1][s] * inverse[q][s];
      values[q][s] = carried + (right - xi) * share;
      carried = (xi - left) * share;
    }
    values[q][q] = carried;
  }
  std::copy_n(values[p], p + 1, out);

  for (int k = 1; k <= order; ++k) {
    double* row = out + k * (p + 1);
    if (k > p) {
      std::fill_n(row, p + 1, 0.0);
      continue;
    }
    // N'_{i,q} = q (N_{i,q−1}/(ξ_{i+q}−ξ_i) − N_{i+1,q−1}/(ξ_{i+q+1}−ξ_{i+1})) (NURBS Book, eq. 2.7), applied k times
    // from degree p−k upwards; from the right end, so that one row can hold both degrees.
    std::copy_n(values[p - k], p - k + 1, row);
    for (int q = p - k + 1; q <= p; ++q) {
      row[q] = q * row[q - 1] * inverse[q][q - 1];
      for (int s = q - 1; s > 0; --s) row[s] = q * (row[s - 1] * inverse[q][s - 1] - row[s] * inverse[q][s]);
      row[0] *= -q * inverse[q][0];
    }
  }
}

void basis_derivatives(const Space1D& space, int element, double xi, int order, double* out) {
  if (space.knots()) return basis_derivatives(*space.knots(), element, xi, order, out);
  require(order <= 2, "nurbs.basis.derivative", {{"order", order}});
  const auto [start, end] = space.interval(element);
  const Space1D::Extraction extraction = space.extraction(element);
  double bernsteins[3 * (max_degree + 1)];
  bernstein(space.degree(element), (xi - start) / (end - start), end - start, order, bernsteins);
  for (int k = 0; k <= order; ++k) {
    // N_a = Σ_l C(a, l) B_l
    const Eigen::Map<const VectorX> row(bernsteins + k * extraction.cols(), extraction.cols());
    Eigen::Map<VectorX>(out + k * extraction.rows(), extraction.rows()) = extraction.lazyProduct(row);
  }
}

} // namespace signorini::nurbs
