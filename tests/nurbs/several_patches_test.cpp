#include "nurbs/several_patches.hpp"

#include "measure.hpp"
#include "random_patch.hpp"

#include <gtest/gtest.h>

namespace signorini::nurbs {
namespace several_patches_test {

using namespace test;
using std::numbers::pi;

const Vec<3> center(1, 2, 3);

double content(const SeveralPatches& shape) {
  double sum = 0;
  for (const Patch& patch : shape.patches) sum += measure(patch).content;
  return sum;
}

/// Area or length of a boundary.
double content(const SeveralPatches& shape, const std::string& name) {
  double sum = 0;
  for (const Boundary& boundary : shape.boundaries)
    if (boundary.name == name)
      for (const auto& [patch, side] : boundary.faces) sum += measure(face(shape.patches[patch], side)).content;
  return sum;
}

/// Largest distance(x) of random points of a boundary.
template <class Distance> double farthest(const SeveralPatches& shape, int boundary, Distance distance) {
  Random random(7);
  double most = 0;
  for (const auto& [patch, side] : shape.boundaries[boundary].faces) {
    const Patch surface = face(shape.patches[patch], side);
    for (int n = 0; n < 100; ++n)
      most = std::max(most, std::abs(distance(evaluate(surface, random_parameter(random, surface)))));
  }
  return most;
}

/// Least Jacobian determinant divided by the lengths of the columns, on a grid with the boundary.
double least_scaled_jacobian(const SeveralPatches& shape) {
  double least = 1;
  for (const Patch& patch : shape.patches) {
    const int dimension = patch.dimension(), steps = 12;
    for (int n = 0; n < std::pow(steps + 1, dimension); ++n) {
      VectorX xi(dimension);
      for (int d = 0, rest = n; d < dimension; ++d, rest /= steps + 1) xi(d) = rest % (steps + 1) / double(steps);
      const auto all = derivatives(patch, xi, 1);
      MatrixX jacobian(dimension, dimension);
      for (int d = 0; d < dimension; ++d) jacobian.col(d) = all[d + 1].value.normalized();
      least = std::min(least, jacobian.determinant());
    }
  }
  return least;
}

/// Homogeneous control points of a face, sorted: equal for faces that match in any orientation.
std::vector<std::vector<double>> sorted_points(const Patch& surface) {
  std::vector<std::vector<double>> points;
  for (const auto& point : surface.homogeneous().colwise()) {
    points.emplace_back();
    for (double value : point) points.back().push_back(std::round(value * 1e12) / 1e12 + 0.0);
  }
  std::sort(points.begin(), points.end());
  return points;
}

/// Number of faces with a partner: another face with the same degrees, numbers of knots, control points and weights.
int matching_faces(const SeveralPatches& shape) {
  std::vector<Patch> faces;
  for (const Patch& patch : shape.patches)
    for (int d = 0; d < patch.dimension(); ++d)
      for (const bool at_end : {false, true}) faces.push_back(face(patch, {d, at_end}));
  int count = 0;
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (std::size_t j = 0; j < faces.size(); ++j)
      count += i != j && sorted_points(faces[i]) == sorted_points(faces[j]);
  return count;
}

TEST(SeveralPatches, DiscIsExactAndMatches) {
  const SeveralPatches shape = disc(2, center.head<2>());
  ASSERT_EQ(shape.patches.size(), 5u);
  EXPECT_LT(farthest(shape, 0, [&](const VectorX& x) { return (x - center.head<2>()).norm() - 2; }), 1e-14);
  EXPECT_NEAR(content(shape), 4 * pi, 1e-12);
  EXPECT_NEAR(content(shape, "outer"), 4 * pi, 1e-12);
  EXPECT_EQ(matching_faces(shape), 16);                             // 4 radial borders and 4 sides of the core
  EXPECT_NEAR(least_scaled_jacobian(shape), std::sqrt(0.5), 1e-12); // at the core's corners, 135°
  const Vec<2> lowest(1, 0), middle(0.5, 0);
  EXPECT_LT((evaluate(shape.patches[0], middle) - lowest).norm(), 1e-14);
  EXPECT_ERROR(disc(-2, Vec<2>(0, 0)), "nurbs.shapes.length: argument = radius, length = -2");
  EXPECT_ERROR(disc(1e-20, Vec<2>(1, 0)),
               "nurbs.shapes.rounding: argument = radius, length = 1e-20, coordinate = center x, start = 1");
}

TEST(SeveralPatches, CylinderIsTheExtrudedDisc) {
  const SeveralPatches shape = cylinder(2, 3, center);
  EXPECT_LT(farthest(shape, 0, [](const VectorX& x) { return std::hypot(x(0) - 1, x(2) - 3) - 2; }), 1e-14);
  EXPECT_LT(farthest(shape, 1, [](const VectorX& x) { return x(1) - 2; }), 1e-14);
  EXPECT_LT(farthest(shape, 2, [](const VectorX& x) { return x(1) - 5; }), 1e-14);
  EXPECT_NEAR(content(shape), 12 * pi, 1e-11);
  EXPECT_NEAR(content(shape, "outer"), 12 * pi, 1e-11);
  EXPECT_NEAR(content(shape, "south"), 4 * pi, 1e-12);
  EXPECT_NEAR(content(shape, "north"), 4 * pi, 1e-12);
  EXPECT_EQ(matching_faces(shape), 16);
  EXPECT_NEAR(least_scaled_jacobian(shape), std::sqrt(0.5), 1e-12);
  EXPECT_ERROR(cylinder(1, 0, center), "nurbs.shapes.length: argument = width, length = 0");
}

TEST(SeveralPatches, TorusIsExactAndClosed) {
  const SeveralPatches shape = torus(3, 1, center);
  EXPECT_LT(
      farthest(shape, 0, [](const VectorX& x) { return std::hypot(std::hypot(x(0) - 1, x(1) - 2) - 3, x(2) - 3) - 1; }),
      1e-14);
  EXPECT_NEAR(content(shape), 2 * pi * pi * 3, 1e-10);
  EXPECT_NEAR(content(shape, "outer"), 4 * pi * pi * 3, 1e-10);
  EXPECT_EQ(matching_faces(shape), 16 + 10); // five seams
  EXPECT_NEAR(least_scaled_jacobian(shape), std::sqrt(0.5), 1e-12);
  EXPECT_ERROR(torus(1, 1, center), "nurbs.shapes.torus: section = 1, radius = 1");
  EXPECT_ERROR(torus(1, 0, center), "nurbs.shapes.length: argument = section, length = 0");
}

TEST(SeveralPatches, BallIsExactAndHasNoSingularPoints) {
  const SeveralPatches shape = ball(2, center);
  ASSERT_EQ(shape.patches.size(), 7u);
  EXPECT_LT(farthest(shape, 0, [](const VectorX& x) { return (x - center).norm() - 2; }), 1e-14);
  EXPECT_NEAR(content(shape), 4 * pi / 3 * 8, 1e-9);
  EXPECT_NEAR(content(shape, "outer"), 16 * pi, 1e-9);
  for (int n = 0; n < 6; ++n) EXPECT_NEAR(measure(face(shape.patches[n], {2, false})).content, 16 * pi / 6, 1e-10) << n;
  EXPECT_EQ(matching_faces(shape), 2 * (12 + 6));
  // At the core's corners: two edges of the cube and its diagonal.
  EXPECT_NEAR(least_scaled_jacobian(shape), 1 / std::sqrt(3.0), 1e-12);
  const Vec<3> directions[] = {-Vec<3>::UnitZ(), Vec<3>::UnitX(),  Vec<3>::UnitY(),
                               -Vec<3>::UnitX(), -Vec<3>::UnitY(), Vec<3>::UnitZ()};
  for (int n = 0; n < 6; ++n)
    EXPECT_LT((evaluate(shape.patches[n], Vec<3>(0.5, 0.5, 0)) - center - 2 * directions[n]).norm(), 1e-14) << n;
  EXPECT_ERROR(ball(std::nan(""), center), "nurbs.shapes.length");
  EXPECT_ERROR(ball(1, Vec<2>(0, 0)), "nurbs.transform.coordinates: argument = center, expected = 3, count = 2");
}

} // namespace several_patches_test
} // namespace signorini::nurbs
