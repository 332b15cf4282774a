#include "nurbs/multi_degree.hpp"

#include "base/error.hpp"
#include "base/orthonormal.hpp"
#include "nurbs/bezier_element.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace signorini::nurbs {

namespace {

/// Per element the Bernstein coefficients of its functions in the space with degrees and continuities reduced by
/// `missing`, empty where the degree is negative. Its functions are numbered from that of the element's first +
/// missing.
struct Level {
  int missing;
  std::vector<MatrixX> elements;
};

/// The next level by the recurrence: all degrees one higher. `first`: per element the first function of the space.
Level integrated(const Level& level, const std::vector<double>& breaks, const std::vector<int>& degrees,
                 const std::vector<int>& first, int functions) {
  const std::size_t count = degrees.size();
  const auto length = [&](std::size_t e) { return breaks[e + 1] - breaks[e]; };
  const auto function = [&](std::size_t e, Eigen::Index r) { return first[e] + level.missing + static_cast<int>(r); };
  // ∫ M_i over the elements before and after each one; the integral of a Bernstein polynomial of degree q is h/(q+1)
  std::vector<VectorX> before(count), own(count), after(count);
  std::vector<double> total(functions, 0.0);
  for (std::size_t e = 0; e < count; ++e) {
    const MatrixX& part = level.elements[e];
    before[e] = after[e] = VectorX::Zero(part.rows());
    own[e] = part.rowwise().sum() * (length(e) / static_cast<double>(part.cols()));
    for (Eigen::Index r = 0; r < part.rows(); ++r) {
      before[e](r) = total[function(e, r)];
      total[function(e, r)] += own[e](r);
    }
  }
  std::vector<double> right(functions, 0.0);
  for (std::size_t e = count; e-- > 0;)
    for (Eigen::Index r = 0; r < own[e].size(); ++r) {
      after[e](r) = right[function(e, r)];
      right[function(e, r)] += own[e](r);
    }

  Level next{level.missing - 1, std::vector<MatrixX>(count)};
  for (std::size_t e = 0; e < count; ++e) {
    const int q = degrees[e] - next.missing;
    if (q < 0) continue;
    // F_i and 1 − F_i; functions that begin before the element have F = 1, those after it 0.
    MatrixX F = MatrixX::Zero(q + 2, q + 1), rest = F;
    F.row(0).setOnes();
    rest.row(q + 1).setOnes();
    for (Eigen::Index r = 0; r < q; ++r) {
      const double scale = 1 / total[function(e, r)];
      double left = before[e](r), beyond = after[e](r);
      for (int k = 0; k <= q; ++k) {
        F(r + 1, k) = left * scale;
        rest(r + 1, q - k) = beyond * scale;
        if (k == q) break;
        left += level.elements[e](r, k) * (length(e) / q);
        beyond += level.elements[e](r, q - 1 - k) * (length(e) / q);
      }
    }
    MatrixX& functions_here = next.elements[e];
    functions_here.resize(q + 1, q + 1);
    for (int i = 0; i <= q; ++i)
      for (int k = 0; k <= q; ++k) {
        // N_i = F_i − F_{i+1}, the difference of the smaller values
        const double value = F(i, k) < 0.5 ? F(i, k) - F(i + 1, k) : rest(i + 1, k) - rest(i, k);
        functions_here(i, k) = std::max(value, 0.0);
      }
  }
  return next;
}

/// D with B_k(t0 + (t1 − t0) τ) = Σ_j D(k, j) B_j(τ): the Bernstein polynomials on a part of their interval.
MatrixX bernstein_part(int degree, double t0, double t1) {
  MatrixX result(degree + 1, degree + 1);
  for (int j = 0; j <= degree; ++j) {
    // Blossom at (t0, degree−j times; t1, j times): de Casteljau's recursion with one argument per level
    MatrixX level = MatrixX::Identity(degree + 1, degree + 1);
    for (int r = 1; r <= degree; ++r) {
      const double t = r <= degree - j ? t0 : t1;
      for (int i = 0; i <= degree - r; ++i) level.col(i) = (1 - t) * level.col(i) + t * level.col(i + 1);
    }
    result.col(j) = level.col(0);
  }
  return result;
}

} // namespace

Space1D multi_degree_space(std::vector<double> breaks, const std::vector<int>& degrees, std::vector<int> smoothness) {
  const std::size_t count = degrees.size();
  require(count > 0 && breaks.size() == count + 1 && smoothness.size() == count + 1, "nurbs.space.breakpoints",
          {{"elements", count}, {"breakpoints", breaks.size()}, {"smoothness", smoothness.size()}});
  // The first function on element e is the number of functions that end at or before its start.
  std::vector<int> first(count, 0);
  for (std::size_t e = 0; e < count; ++e) {
    require(degrees[e] >= 0 && degrees[e] <= max_degree, "nurbs.space.degree",
            {{"degree", degrees[e]}, {"most", max_degree}});
    if (e == 0) continue;
    const int lower = std::min(degrees[e - 1], degrees[e]);
    require(smoothness[e] >= -1 && smoothness[e] <= lower, "nurbs.space.smoothness",
            {{"breakpoint", breaks[e]}, {"smoothness", smoothness[e]}, {"degree", lower}});
    first[e] = first[e - 1] + degrees[e - 1] - smoothness[e];
  }
  const int functions = first.back() + degrees.back() + 1;
  Level level{*std::max_element(degrees.begin(), degrees.end()) + 1, std::vector<MatrixX>(count)};
  while (level.missing > 0) level = integrated(level, breaks, degrees, first, functions);

  std::vector<Element1D> elements;
  for (std::size_t e = 0; e < count; ++e) {
    std::vector<int> numbers(degrees[e] + 1);
    std::iota(numbers.begin(), numbers.end(), first[e]);
    elements.push_back({degrees[e], std::move(numbers), std::move(level.elements[e])});
  }
  smoothness.front() = smoothness.back() = -1;
  return {std::move(breaks), std::move(smoothness), elements};
}

MatrixX representation(const Space1D& from, const Space1D& to) {
  MatrixX result = MatrixX::Zero(to.functions(), from.functions());
  std::vector<double> least(to.functions(), std::numeric_limits<double>::infinity());
  for (int e = 0; e < to.elements(); ++e) {
    const auto [start, end] = to.interval(e);
    const int source = from.find_element((start + end) / 2);
    const auto [low, high] = from.interval(source);
    const int p = from.degree(source);
    // N^from = A B^from, on this element A D E B^to;  N^to = C B^to  ⇒  Mᵀ = A D E C⁻¹
    const MatrixX inverse = pseudo_inverse(to.extraction(e));
    const MatrixX local = from.extraction(source)
                              .lazyProduct(bernstein_part(p, (start - low) / (high - low), (end - low) / (high - low)))
                              .lazyProduct(bernstein_elevation(p, to.degree(e)))
                              .lazyProduct(inverse);
    const std::span<const int> rows = to.functions_on(e), columns = from.functions_on(source);
    for (std::size_t a = 0; a < rows.size(); ++a) {
      const auto column = static_cast<Eigen::Index>(a);
      const double amplification = inverse.col(column).lpNorm<1>();
      if (amplification >= least[rows[a]]) continue;
      least[rows[a]] = amplification;
      result.row(rows[a]).setZero();
      for (std::size_t b = 0; b < columns.size(); ++b)
        result(rows[a], columns[b]) = local(static_cast<Eigen::Index>(b), column);
    }
  }
  return result;
}

Row with_space(const Row& row, int d, const Space1D& space) {
  const MatrixX combine = representation(row.direction(d), space);
  const Eigen::Index before = combine.cols(), after = combine.rows(), stride = row.stride(d);
  const Eigen::Index outer = row.functions() / (stride * before);
  // Columns with the same index along d are blocks of `stride`.
  MatrixX points = MatrixX::Zero(row.homogeneous().rows(), stride * after * outer);
  for (Eigen::Index o = 0; o < outer; ++o)
    for (Eigen::Index a = 0; a < after; ++a)
      for (Eigen::Index b = 0; b < before; ++b)
        if (combine(a, b) != 0)
          points.middleCols(stride * (a + after * o), stride) +=
              combine(a, b) * row.homogeneous().middleCols(stride * (b + before * o), stride);
  std::vector<Space1D> directions = row.directions();
  directions[d] = space;
  return {std::move(directions), std::move(points)};
}

} // namespace signorini::nurbs
