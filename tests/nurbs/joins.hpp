#pragma once
// Spaces with elements of several degrees, joined C⁰, and a strip with such a row: spaces without a knot vector.

#include "nurbs/discretization.hpp"

namespace signorini::nurbs::test {

/// Bernstein polynomials of `degrees`, one degree per element of equal length on [0, 1]; neighbors share one function.
inline Space1D joined(const std::vector<int>& degrees) {
  std::vector<double> breaks{0};
  std::vector<int> smoothness{-1};
  std::vector<Element1D> elements;
  for (int first = 0; const int degree : degrees) {
    elements.push_back({degree, {}, MatrixX::Identity(degree + 1, degree + 1)});
    for (int k = 0; k <= degree; ++k) elements.back().functions.push_back(first + k);
    first += degree;
    breaks.push_back(static_cast<double>(elements.size()) / static_cast<double>(degrees.size()));
    smoothness.push_back(0);
  }
  smoothness.back() = -1;
  return {std::move(breaks), std::move(smoothness), elements};
}

/// The control points of x = ξ in such a space: equidistant in every element.
inline std::vector<double> linear_points(const Space1D& space) {
  std::vector<double> points(space.functions());
  for (int e = 0; e < space.elements(); ++e) {
    const auto [from, to] = space.interval(e);
    const std::span<const int> functions = space.functions_on(e);
    for (std::size_t k = 0; k < functions.size(); ++k)
      points[functions[k]] = from + (to - from) * static_cast<double>(k) / space.degree(e);
  }
  return points;
}

/// The rectangle of `width` and height 1 above y = 0; the row on `side`, "north" or "south", joins `degrees`, the
/// opposite row is quadratic and C⁰.
inline Discretization strip(double width, const std::vector<int>& degrees, const std::string& side = "north") {
  const auto row = [&](const Space1D& space, double y) {
    MatrixX homogeneous = MatrixX::Ones(3, space.functions());
    const std::vector<double> points = linear_points(space);
    for (int i = 0; i < space.functions(); ++i) homogeneous.col(i) << width * points[i], y, 1;
    return Row({space}, std::move(homogeneous));
  };
  const Space1D many = joined(degrees), two = joined(std::vector<int>(degrees.size(), 2));
  const bool north = side == "north";
  return {1,
          spline_space(KnotVector::single(1)),
          {row(north ? two : many, 0), row(north ? many : two, 1)},
          {side_of(side, 2)}};
}

} // namespace signorini::nurbs::test
