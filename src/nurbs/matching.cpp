#include "nurbs/matching.hpp"

#include "nurbs/constants.hpp"
#include "nurbs/orientation.hpp"

#include <algorithm>
#include <limits>
#include <map>

namespace signorini::nurbs {

namespace {

/// A face with coordinates from 0 to 1 along its directions, in their order.
struct MatchedFace {
  const Discretization& space;
  Side side;
  MatrixX points;
  std::vector<int> along; ///< directions of the patch

  MatchedFace(const Discretization& of, Side on) : space(of), side(on), points(of.points()) {
    for (int d = 0; d < of.parametric_dimension(); ++d)
      if (d != on.direction) along.push_back(d);
  }

  int elements(std::size_t k) const { return space.elements(along[k]); }

  /// The element of the body behind the element with these indices.
  int element(const std::array<int, 2>& index) const {
    return space.element_behind(side, index[0] + (along.size() > 1 ? elements(0) * index[1] : 0));
  }

  /// Border i of the elements along direction k.
  double border(std::size_t k, int i) const {
    const int last = elements(k) - 1;
    const auto at_index = [&](int e) {
      std::array<int, 2> index{0, 0};
      index[k] = e;
      return space.interval(element(index), along[k]);
    };
    const double from = at_index(0)[0], to = at_index(last)[1];
    return ((i > last ? to : at_index(i)[0]) - from) / (to - from);
  }

  /// The body's functions at fractions of an element.
  ElementBasis basis(const std::array<int, 2>& index, const std::array<double, 2>& fraction) const {
    VectorX inside(space.parametric_dimension());
    inside(side.direction) = side.at_end ? 1 : 0;
    for (std::size_t k = 0; k < along.size(); ++k) inside(along[k]) = fraction[k];
    const int e = element(index);
    return space.basis(e, space.parameter(e, inside));
  }

  VectorX corner(const std::array<bool, 2>& at_end) const {
    std::array<int, 2> index{0, 0};
    std::array<double, 2> fraction{0, 0};
    for (std::size_t k = 0; k < along.size(); ++k)
      if (at_end[k]) {
        index[k] = elements(k) - 1;
        fraction[k] = 1;
      }
    return basis(index, fraction).combine(points);
  }
};

/// Functions with their values at the samples of an element, one row each; functions that are zero there are left out.
struct SampledFunctions {
  std::vector<int> functions;
  MatrixX values;
};

SampledFunctions nonzero(const std::vector<ElementBasis>& samples) {
  MatrixX all(samples.front().values.size(), static_cast<Eigen::Index>(samples.size()));
  for (std::size_t i = 0; i < samples.size(); ++i) all.col(static_cast<Eigen::Index>(i)) = samples[i].values;
  SampledFunctions result;
  std::vector<Eigen::Index> rows;
  for (Eigen::Index a = 0; a < all.rows(); ++a)
    if (all.row(a).cwiseAbs().maxCoeff() > computed) {
      rows.push_back(a);
      result.functions.push_back(samples.front().functions[a]);
    }
  result.values = all(rows, Eigen::all);
  return result;
}

/// Pairs the functions of one element; false if a function has no partner with the same values.
bool pair_functions(const SampledFunctions& first, const SampledFunctions& second, std::map<int, int>& partner) {
  if (first.functions.size() != second.functions.size()) return false;
  for (std::size_t a = 0; a < first.functions.size(); ++a) {
    const auto row = first.values.row(static_cast<Eigen::Index>(a));
    std::size_t b = 0;
    const auto differs = [&] {
      return (second.values.row(static_cast<Eigen::Index>(b)) - row).cwiseAbs().maxCoeff() > computed;
    };
    while (b < second.functions.size() && differs()) ++b;
    if (b == second.functions.size()) return false;
    if (partner.emplace(first.functions[a], second.functions[b]).first->second != second.functions[b]) return false;
  }
  return true;
}

FaceMatch compare(const MatchedFace& first, const MatchedFace& second, const Orientation& way, double tolerance) {
  const std::size_t dimensions = first.along.size();
  double apart = 0;
  for (int corner = 0; corner < 1 << dimensions; ++corner) {
    const std::array<bool, 2> here{(corner & 1) != 0, (corner & 2) != 0};
    const auto there = way.turn(here, [](std::size_t, bool end) { return !end; });
    apart = std::max(apart, (first.corner(here) - second.corner(there)).norm());
  }
  if (apart > tolerance) return {.mismatch = Mismatch::corners, .apart = apart};
  std::array<int, 2> count{1, 1};
  for (std::size_t k = 0; k < dimensions; ++k) {
    count[k] = first.elements(k);
    if (second.elements(way.to[k]) != count[k]) return {Mismatch::elements};
  }
  for (std::size_t k = 0; k < dimensions; ++k)
    for (int i = 1; i < count[k]; ++i) {
      const double other = second.border(way.to[k], way.flip[k] ? count[k] - i : i);
      if (std::abs(first.border(k, i) - (way.flip[k] ? 1 - other : other)) > computed) return {Mismatch::borders};
    }

  std::map<int, int> partner;
  for (std::array<int, 2> index{0, 0}; index[1] < count[1]; ++index[1])
    for (index[0] = 0; index[0] < count[0]; ++index[0]) {
      const auto opposite = way.turn(index, [&](std::size_t k, int i) { return count[k] - 1 - i; });
      // One more point per direction than the higher of the two degrees determines the functions.
      std::array<int, 2> points{1, 1};
      for (std::size_t k = 0; k < dimensions; ++k)
        points[k] = 1 + std::max(first.space.degree(first.element(index), first.along[k]),
                                 second.space.degree(second.element(opposite), second.along[way.to[k]]));
      std::vector<ElementBasis> here, there;
      for (int j = 0; j < points[1]; ++j)
        for (int i = 0; i < points[0]; ++i) {
          const std::array<double, 2> fraction{(i + 0.5) / points[0], (j + 0.5) / points[1]};
          here.push_back(first.basis(index, fraction));
          there.push_back(second.basis(opposite, way.turn(fraction, [](std::size_t, double t) { return 1 - t; })));
        }
      if (!pair_functions(nonzero(here), nonzero(there), partner)) return {Mismatch::functions};
    }

  FaceMatch result{Mismatch::none};
  for (const auto& [a, b] : partner) {
    if ((first.points.col(a) - second.points.col(b)).norm() > tolerance) return {Mismatch::points};
    result.pairs.push_back({a, b});
  }
  return result;
}

} // namespace

FaceMatch match_faces(const Discretization& first, Side first_side, const Discretization& second, Side second_side,
                      double relative) {
  const MatchedFace one(first, first_side), other(second, second_side);
  const MatrixX own = one.points(Eigen::all, first.face_functions(first_side));
  const double tolerance = relative * (own.rowwise().maxCoeff() - own.rowwise().minCoeff()).norm();
  FaceMatch best{.apart = std::numeric_limits<double>::infinity()};
  for (const Orientation& way : orientations(first.parametric_dimension() - 1)) {
    FaceMatch found = compare(one, other, way, tolerance);
    if (found.mismatch == Mismatch::none) {
      found.facing = outward_sign(first_side) * outward_sign(second_side) * (way.mirrors() ? -1 : 1) < 0;
      return found;
    }
    if (found.mismatch == Mismatch::corners) best.apart = std::min(best.apart, found.apart);
    best.mismatch = std::max(best.mismatch, found.mismatch);
  }
  return best;
}

} // namespace signorini::nurbs
