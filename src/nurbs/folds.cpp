#include "nurbs/folds.hpp"

#include "base/error.hpp"
#include "nurbs/bezier.hpp"
#include "nurbs/constants.hpp"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace signorini::nurbs {

namespace {

/// A box of the parametric domain with the Bernstein coefficients of the numerator on it, ξ¹ fastest.
struct BernsteinBox {
  VectorX low, high, coefficients;
};

/// Degrees of the numerator: each of D + 1 columns has degree p, one of them p − 1; without weights, of D columns.
std::vector<int> degrees_of_numerator(const Patch& patch) {
  const auto weights = patch.homogeneous().bottomRows(1);
  const bool rational = weights.maxCoeff() > weights.minCoeff();
  std::vector<int> degrees;
  for (const KnotVector& direction : patch.directions())
    degrees.push_back((patch.parametric_dimension() + (rational ? 1 : 0)) * direction.degree() - 1);
  return degrees;
}

int coefficients_of(const std::vector<int>& degrees) {
  int count = 1;
  for (const int degree : degrees) count *= degree + 1;
  return count;
}

/// Applies a matrix to direction d of an array with these counts, ξ¹ fastest.
VectorX applied(const MatrixX& matrix, const VectorX& values, std::vector<int>& counts, std::size_t d) {
  Eigen::Index inner = 1, outer = 1;
  for (std::size_t k = 0; k < counts.size(); ++k) (k < d ? inner : outer) *= k == d ? 1 : counts[k];
  const Eigen::Index from = counts[d], to = matrix.rows();
  VectorX result(inner * to * outer);
  for (Eigen::Index o = 0; o < outer; ++o)
    Eigen::Map<MatrixX>(result.data() + o * inner * to, inner, to) =
        Eigen::Map<const MatrixX>(values.data() + o * inner * from, inner, from) * matrix.transpose();
  counts[d] = static_cast<int>(to);
  return result;
}

/// Values of the Bernstein polynomials at degree + 1 even points, one row each, or of their derivatives.
MatrixX at_even_points(int degree, int points, double length, int order) {
  MatrixX values(points, degree + 1);
  std::vector<double> out(3 * (degree + 1));
  for (int i = 0; i < points; ++i) {
    bernstein(degree, points == 1 ? 0.5 : static_cast<double>(i) / (points - 1), length, order, out.data());
    for (int k = 0; k <= degree; ++k) values(i, k) = out[order * (degree + 1) + k];
  }
  return values;
}

/// The numerator on one span: interpolated at as many points as it has coefficients.
BernsteinBox numerator(const Patch& patch, const std::array<int, 3>& span, const std::vector<int>& degrees) {
  const int dimensions = patch.parametric_dimension();
  BernsteinBox box{VectorX(dimensions), VectorX(dimensions), {}};
  // Homogeneous Bézier points, one array per coordinate
  std::vector<int> own;
  std::vector<VectorX> points(dimensions + 1);
  for (int d = 0; d < dimensions; ++d) own.push_back(patch.direction(d).degree() + 1);
  for (int c = 0; c <= dimensions; ++c) {
    VectorX& list = points[c];
    list.resize(own[0] * own[1] * (dimensions > 2 ? own[2] : 1));
    for (Eigen::Index k = 0; k < list.size(); ++k) {
      Eigen::Index function = 0, rest = k;
      for (int d = 0; d < dimensions; ++d) {
        function += (patch.direction(d).first_function(span[d]) + rest % own[d]) * patch.stride(d);
        rest /= own[d];
      }
      list(k) = patch.homogeneous()(c, function);
    }
    std::vector<int> counts = own;
    for (int d = 0; d < dimensions; ++d)
      list = applied(bezier_extraction(patch.direction(d), span[d]).transpose(), list, counts, d);
  }
  // Values of H (entry D) and its derivatives (0 … D − 1) at the points of interpolation
  std::vector<std::vector<VectorX>> values(dimensions + 1, std::vector<VectorX>(dimensions + 1));
  for (int c = 0; c <= dimensions; ++c)
    for (int by = 0; by <= dimensions; ++by) {
      VectorX& list = values[c][by] = points[c];
      std::vector<int> counts = own;
      for (int d = 0; d < dimensions; ++d) {
        const auto& breaks = patch.direction(d).breaks();
        box.low(d) = breaks[span[d]];
        box.high(d) = breaks[span[d] + 1];
        list = applied(at_even_points(own[d] - 1, degrees[d] + 1, box.high(d) - box.low(d), d == by), list, counts, d);
      }
    }
  box.coefficients.resize(coefficients_of(degrees));
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 4, 4> columns(dimensions + 1, dimensions + 1);
  for (Eigen::Index k = 0; k < box.coefficients.size(); ++k) {
    for (int c = 0; c <= dimensions; ++c)
      for (int by = 0; by <= dimensions; ++by) columns(c, by) = values[c][by](k);
    box.coefficients(k) = columns.determinant();
  }
  std::vector<int> counts;
  for (const int degree : degrees) counts.push_back(degree + 1);
  for (std::size_t d = 0; d < counts.size(); ++d)
    box.coefficients = applied(at_even_points(degrees[d], counts[d], 1, 0).inverse(), box.coefficients, counts, d);
  return box;
}

/// The halves of a box in direction d, by de Casteljau's algorithm as two matrices.
std::array<BernsteinBox, 2> halves(const BernsteinBox& box, const std::vector<int>& degrees, std::size_t d) {
  const int n = degrees[d];
  MatrixX left = MatrixX::Zero(n + 1, n + 1);
  left(0, 0) = 1;
  for (int i = 1; i <= n; ++i)
    for (int k = 0; k <= i; ++k) left(i, k) = ((k > 0 ? left(i - 1, k - 1) : 0) + (k < i ? left(i - 1, k) : 0)) / 2;
  std::array<BernsteinBox, 2> result{box, box};
  const auto along = static_cast<Eigen::Index>(d);
  result[0].high(along) = result[1].low(along) = (box.low(along) + box.high(along)) / 2;
  for (BernsteinBox& half : result) {
    std::vector<int> counts;
    for (const int degree : degrees) counts.push_back(degree + 1);
    half.coefficients = applied(&half == result.data() ? left : MatrixX(left.reverse()), box.coefficients, counts, d);
  }
  return result;
}

/// Parameters of a corner where the numerator is below −tolerance; empty if there is none.
VectorX negative_corner(const BernsteinBox& box, const std::vector<int>& degrees, double tolerance) {
  const int dimensions = std::ssize(degrees);
  for (int corner = 0; corner < 1 << dimensions; ++corner) {
    VectorX xi = box.low;
    Eigen::Index index = 0, stride = 1;
    for (int d = 0; d < dimensions; ++d) {
      if ((corner >> d & 1) != 0) {
        xi(d) = box.high(d);
        index += stride * degrees[d];
      }
      stride *= degrees[d] + 1;
    }
    if (box.coefficients(index) < -tolerance) return xi;
  }
  return {};
}

/// Parameters where the numerator is negative on a span; empty if there are none, or if this remains open.
VectorX negative_place(const BernsteinBox& span, const std::vector<int>& degrees) {
  const double tolerance = folded_digits * span.coefficients.cwiseAbs().maxCoeff();
  std::vector<BernsteinBox> open{span};
  for (std::size_t k = 0; k < open.size() && k < most_boxes; ++k) {
    const BernsteinBox box = std::move(open[k]); // up to megabytes, which are not needed again
    if (box.coefficients.minCoeff() >= -tolerance) continue;
    if (VectorX xi = negative_corner(box, degrees, tolerance); xi.size() > 0) return xi;
    Eigen::Index widest = 0;
    (box.high - box.low).cwiseQuotient(span.high - span.low).maxCoeff(&widest);
    for (BernsteinBox& half : halves(box, degrees, static_cast<std::size_t>(widest))) open.push_back(std::move(half));
  }
  return {};
}

} // namespace

void check_folds(const Patch& patch) {
  const int dimensions = patch.parametric_dimension();
  const std::vector<int> degrees = degrees_of_numerator(patch);
  std::array<int, 3> counts{1, 1, 1}, span{};
  double coefficients = coefficients_of(degrees);
  for (int d = 0; d < dimensions; ++d) coefficients *= counts[d] = patch.direction(d).elements();
  if (coefficients > examined_coefficients) return;
  for (span[2] = 0; span[2] < counts[2]; ++span[2])
    for (span[1] = 0; span[1] < counts[1]; ++span[1])
      for (span[0] = 0; span[0] < counts[0]; ++span[0]) {
        const VectorX xi = negative_place(numerator(patch, span, degrees), degrees);
        if (xi.size() == 0) continue;
        const std::vector<Derivative> all = derivatives(patch, xi, 1);
        MatrixX jacobian(dimensions, dimensions);
        for (int d = 0; d < dimensions; ++d) jacobian.col(d) = all[d + 1].value;
        fail("nurbs.patch.folded", {{"jacobian", jacobian.determinant()}, {"place", all[0].value}, {"xi", xi}});
      }
}

} // namespace signorini::nurbs
