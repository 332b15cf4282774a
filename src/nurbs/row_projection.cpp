#include "nurbs/row_projection.hpp"

#include "base/error.hpp"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <utility>

namespace signorini::nurbs {

namespace {

/// Binomial coefficients of `n` over 0 … n.
VectorX binomials(int n) {
  VectorX result = VectorX::Ones(n + 1);
  for (int k = 1; k <= n; ++k) result(k) = result(k - 1) * (n - k + 1) / k;
  return result;
}

/// ∫ B_i^p B_j^q dξ = h C(p,i) C(q,j) / (C(p+q,i+j) (p+q+1)) on an element of length h [theory 4.5].
MatrixX bernstein_products(int p, int q, double length) {
  const VectorX first = binomials(p), second = binomials(q), both = binomials(p + q);
  MatrixX result(p + 1, q + 1);
  for (int i = 0; i <= p; ++i)
    for (int j = 0; j <= q; ++j) result(i, j) = length * first(i) * second(j) / (both(i + j) * (p + q + 1));
  return result;
}

/// Calls add(a, b, ∫ N_a N_b dξ) for the functions of two spaces on each element.
template <class Add> void each_product(const Space1D& rows, const Space1D& columns, const Add& add) {
  for (int e = 0; e < rows.elements(); ++e) {
    const auto [from, to] = rows.interval(e);
    const MatrixX products = rows.extraction(e) * bernstein_products(rows.degree(e), columns.degree(e), to - from) *
                             columns.extraction(e).transpose();
    for (Eigen::Index a = 0; a < products.rows(); ++a)
      for (Eigen::Index b = 0; b < products.cols(); ++b)
        add(rows.functions_on(e)[a], columns.functions_on(e)[b], products(a, b));
  }
}

} // namespace

MatrixX projection(const Space1D& from, const Space1D& to) {
  require(from.breaks() == to.breaks(), "nurbs.row.other_elements",
          {{"first", from.elements()}, {"second", to.elements()}});
  const int last = to.functions() - 1, inner = last - 1;
  MatrixX result = MatrixX::Zero(last + 1, from.functions());
  result(0, 0) = result(last, from.functions() - 1) = 1; // the end functions are the only ones there
  if (inner <= 0) return result;
  // M_ii c_i = ∫ N_i Σ_a N_a c_a dξ − M_ie c_e, i the inner functions, e those of the ends
  const auto is_inner = [&](int function) { return function > 0 && function < last; };
  std::vector<Eigen::Triplet<double>> mass;
  MatrixX right = MatrixX::Zero(inner, from.functions());
  each_product(to, from, [&](int i, int a, double product) {
    if (is_inner(i)) right(i - 1, a) += product;
  });
  each_product(to, to, [&](int i, int j, double product) {
    if (is_inner(i) && is_inner(j))
      mass.emplace_back(i - 1, j - 1, product);
    else if (is_inner(i))
      right.row(i - 1) -= product * result.row(j);
  });
  Eigen::SparseMatrix<double> matrix(inner, inner);
  matrix.setFromTriplets(mass.begin(), mass.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
  result.middleRows(1, inner) = solver.solve(right);
  return result;
}

MatrixX project_row(const Row& from, const Row& to, const MatrixX& values) {
  if (from.directions() == to.directions()) return values;
  const VectorX old_weights = from.weights(), weights = to.weights();
  const MatrixX first = projection(from.direction(0), to.direction(0));
  const bool line = from.parametric_dimension() == 1;
  const MatrixX second = line ? MatrixX::Identity(1, 1) : projection(from.direction(1), to.direction(1));
  MatrixX result(values.rows(), to.functions());
  for (Eigen::Index k = 0; k < values.rows(); ++k) {
    const MatrixX weighted =
        (values.row(k).transpose().array() * old_weights.array()).matrix().reshaped(first.cols(), second.cols());
    const MatrixX carried = first * weighted * second.transpose();
    result.row(k) = (carried.reshaped().array() / weights.array()).matrix().transpose();
  }
  return result;
}

} // namespace signorini::nurbs
