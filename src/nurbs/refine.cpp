#include "nurbs/refine.hpp"

#include "base/error.hpp"
#include "nurbs/directions.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace signorini::nurbs {

namespace {

/// New control points as combinations of old ones: per row the factors of the old points.
using Combinations = std::vector<std::map<int, double>>;

/// Adds factor·F(t_1, …, t_p) to row j, F being the blossom of the B-spline on `knots` as a combination of its control
/// points, t_1 … t_p consecutive knots of a refinement and t_0 the one before.
///
/// Oslo algorithm (Cohen, Lyche, Riesenfeld 1980): the basis recursion of the span that contains t_0 with the argument
/// t_k in its k-th step. All coefficients are ≥ 0, so rounding errors do not grow.
void add_blossom(const KnotVector& knots, double before, const double* t, double factor, int j, Combinations& combine) {
  const int p = knots.degree();
  const int i = knots.span(knots.find_element(before));
  const double* u = knots.knots().data() + i;
  double c[max_degree + 1] = {1};
  for (int k = 1; k <= p; ++k) {
    double carried = 0;
    for (int s = 0; s < k; ++s) {
      // A function whose support does not contain t_k already has coefficient 0.
      const double left = u[1 + s - k], right = u[1 + s];
      const double share = c[s] / (right - left);
      c[s] = carried + (right - t[k - 1]) * share;
      carried = (t[k - 1] - left) * share;
    }
    c[k] = carried;
  }
  for (int s = 0; s <= p; ++s)
    if (c[s] != 0) combine[j][i - p + s] += factor * c[s];
}

/// Replaces direction d by `knots` and the control points along it by these combinations.
Patch replace_direction(const Patch& patch, int d, KnotVector knots, const Combinations& combine) {
  const Eigen::Index before = patch.direction(d).functions(), after = knots.functions();
  const Eigen::Index stride = patch.stride(d), outer = patch.functions() / (stride * before);
  // Columns with the same index along d are blocks of `stride`.
  MatrixX points = MatrixX::Zero(patch.dimension() + 1, stride * after * outer);
  for (Eigen::Index o = 0; o < outer; ++o)
    for (Eigen::Index j = 0; j < after; ++j)
      for (const auto& [i, factor] : combine[j])
        points.middleCols(stride * (j + after * o), stride) +=
            factor * patch.homogeneous().middleCols(stride * (i + before * o), stride);

  std::vector<KnotVector> directions = patch.directions();
  directions[d] = std::move(knots);
  return {std::move(directions), std::move(points)};
}

Patch elevate_once(const Patch& patch, int d) {
  const KnotVector& old = patch.direction(d);
  const int p = old.degree();
  std::vector<double> knots;
  for (double knot : old.breaks()) knots.insert(knots.end(), old.multiplicity(knot) + 1, knot);
  KnotVector elevated(p + 1, knots);

  // The elevated blossom is the mean of the old one over all choices of an argument to omit:
  //   Q_j = 1/(p+1) Σ_k F(t_{j+1}, …, t_{j+p+1} without t_{j+k}) (Prautzsch 1984; Goldman, Pyramid Algorithms, ch. 6)
  // The knots without every (p+1)-th one (t_j kept) still refine the old ones, so each term is a knot insertion.
  Combinations combine(elevated.functions());
  for (int j = 0; j < elevated.functions(); ++j) {
    const double* t = knots.data() + j;
    for (int k = 1; k <= p + 1; ++k) {
      double arguments[max_degree + 1];
      std::copy(t + k + 1, t + p + 2, std::copy(t + 1, t + k, arguments));
      add_blossom(old, t[0], arguments, 1.0 / (p + 1), j, combine);
    }
  }
  return replace_direction(patch, d, std::move(elevated), combine);
}

} // namespace

Patch insert_knots(const Patch& patch, int d, std::vector<double> knots) {
  check_direction(patch, d);
  if (knots.empty()) return patch;
  const KnotVector& old = patch.direction(d);
  for (double knot : knots)
    require(knot > old.first() && knot < old.last(), "nurbs.insert.outside",
            {{"knot", knot}, {"first", old.first()}, {"last", old.last()}});
  std::sort(knots.begin(), knots.end());
  std::vector<double> all(old.knots().size() + knots.size());
  std::merge(old.knots().begin(), old.knots().end(), knots.begin(), knots.end(), all.begin());
  for (double knot : knots) {
    const auto [from, to] = std::equal_range(all.begin(), all.end(), knot);
    require(to - from <= old.degree(), "nurbs.insert.multiplicity",
            {{"knot", knot}, {"count", to - from}, {"degree", old.degree()}, {"present", old.multiplicity(knot)}});
  }
  KnotVector refined(old.degree(), all);

  Combinations combine(refined.functions());
  for (int j = 0; j < refined.functions(); ++j) {
    const double* t = all.data() + j;
    add_blossom(old, t[0], t + 1, 1.0, j, combine);
  }
  return replace_direction(patch, d, std::move(refined), combine);
}

Patch elevate(const Patch& patch, int d, int times) {
  check_direction(patch, d);
  const int degree = patch.direction(d).degree();
  require(times >= 0, "nurbs.elevate.times", {{"times", times}});
  require(times <= max_degree - degree, "nurbs.elevate.degree",
          {{"degree", degree}, {"times", times}, {"most", max_degree}});
  Patch result = patch;
  for (int i = 0; i < times; ++i) result = elevate_once(result, d);
  return result;
}

Patch k_refine(const Patch& patch, int d, int degree, const std::vector<double>& knots) {
  check_direction(patch, d);
  const int own = patch.direction(d).degree();
  require(degree >= own, "nurbs.elevate.lowered", {{"degree", degree}, {"own", own}, {"direction", d}});
  require(degree <= max_degree, "nurbs.elevate.highest", {{"degree", degree}, {"most", max_degree}});
  return insert_knots(elevate(patch, d, degree - own), d, knots);
}

} // namespace signorini::nurbs
