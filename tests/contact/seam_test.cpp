// Seams of tied faces: polygons, areas opposite the master, exact integrals of both faces' functions, distances.
#include "contact/faces3d.hpp"
#include "contact/tie/polygon.hpp"
#include "contact/tie/tie.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

namespace signorini::contact {
namespace seam_test {

using namespace test;

TEST(Polygon, ClippedAreaIsThatOfTheIntersection) {
  const Polygon diamond{{1, 0}, {2, 1}, {1, 2}, {0, 1}};
  EXPECT_NEAR(area(diamond), 2, 1e-15);
  EXPECT_NEAR(area(clip(diamond, {0, 0}, {1, 1})), 0.5, 1e-15);
  EXPECT_NEAR(area(clip(diamond, {0.5, 0.5}, {1.5, 1.5})), 1, 1e-15);
  EXPECT_NEAR(area(clip(diamond, {-1, -1}, {3, 3})), 2, 1e-15);
  EXPECT_LT(clip(diamond, {3, 3}, {4, 4}).size(), 3u);
  // The order of corners does not matter.
  const Polygon reversed(diamond.rbegin(), diamond.rend());
  EXPECT_NEAR(area(clip(reversed, {0, 0}, {1, 2})), 1, 1e-15);
}

/// ∫ x^i y^j over a polygon by Gauss points.
double moment(const Polygon& polygon, int i, int j) {
  const solid::ElementQuadrature rule = quadrature(polygon, std::max(i, j));
  double sum = 0;
  for (Eigen::Index q = 0; q < rule.weights.size(); ++q)
    sum += rule.weights(q) * std::pow(rule.points(0, q), i) * std::pow(rule.points(1, q), j);
  return sum;
}

TEST(Polygon, QuadratureIsExactForPolynomials) {
  const Polygon triangle{{0, 0}, {1, 0}, {0, 1}}, box{{0, 0}, {2, 0}, {2, 3}, {0, 3}};
  const auto factorial = [](int n) { return std::tgamma(n + 1.0); };
  for (int i = 0; i <= 5; ++i)
    for (int j = 0; j <= 5; ++j) {
      const double exact = factorial(i) * factorial(j) / factorial(i + j + 2);
      EXPECT_NEAR(moment(triangle, i, j), exact, 1e-14 * exact + 1e-18) << i << j;
      const double product = std::pow(2, i + 1) / (i + 1) * std::pow(3, j + 1) / (j + 1);
      EXPECT_NEAR(moment(box, i, j), product, 1e-13 * product) << i << j;
    }
}

Surface<2> line(double from, double to, double height, int elements, bool is_lower, const char* label = "N2") {
  const auto patch = nurbs::rectangle(to - from, 1, Eigen::Vector2d(from, is_lower ? height - 1 : height));
  const char* side = is_lower ? "north" : "south";
  return {discretize(patch, {elements, 1}, label, side), nurbs::side_of(side, 2)};
}

TEST(Seam, CutsElementsAtBordersOfBothFaces) {
  const Seam<2> seam = find_seam(line(0, 2, 0, 3, true), line(0, 2, 0, 5, false), false);
  EXPECT_NEAR(seam.area, 2, 1e-14);
  EXPECT_NEAR(seam.whole, 2, 1e-14);
  EXPECT_NEAR(seam.distance.value, 0, 1e-15);
  EXPECT_NEAR(seam.facing.value, -1, 1e-15);
  // 3 + 5 − 1 intervals of 4 points, each within one element of both
  EXPECT_EQ(seam.points.size(), 7 * 4u);
}

TEST(Seam, OnlyThePartOppositeTheMasterIsTied) {
  for (const double to : {0.3, 1.0, 1.7}) {
    const Seam<2> seam = find_seam(line(0, 2, 0, 3, true), line(0, to, 0, 5, false), false);
    EXPECT_NEAR(seam.area, to, 1e-12) << to;
    EXPECT_NEAR(seam.whole, 2, 1e-14);
  }
  EXPECT_TRUE(find_seam(line(0, 2, 0, 3, true), line(3, 4, 0, 5, false), false).points.empty());
}

TEST(Seam, ReportsDistanceAndOrientation) {
  const Seam<2> apart = find_seam(line(0, 2, 0, 4, true), line(0, 2, 0.03, 4, false), false);
  EXPECT_NEAR(apart.distance.value, 0.03, 1e-15);
  EXPECT_NEAR(apart.length, 0.5, 1e-14);
  EXPECT_NEAR(find_seam(line(0, 2, 0, 4, true), line(0, 2, 0, 4, true), false).facing.value, 1, 1e-15);
}

TEST(Seam, AxisymmetricAreasAreThoseOfTheFullCircle) {
  const Seam<2> seam = find_seam(line(1, 2, 0, 3, true), line(1, 2, 0, 5, false), true);
  EXPECT_NEAR(seam.area, 3 * std::numbers::pi, 1e-12);
}

/// A square in z = 0, turned about its center.
Surface<3> square_face(double width, int elements, bool is_lower, double turn) {
  const nurbs::Patch patch =
      nurbs::block({width, width, 1}, Eigen::Vector3d(-width / 2, -width / 2, is_lower ? -1 : 0));
  MatrixX linear = MatrixX::Identity(3, 3);
  linear.topLeftCorner<2, 2>() << std::cos(turn), -std::sin(turn), std::sin(turn), std::cos(turn);
  const char* side = is_lower ? "back" : "front";
  return {discretize(nurbs::transform(patch, linear, Eigen::Vector3d::Zero()), {elements, elements, 1}, "N2", side),
          nurbs::side_of(side, 3)};
}

/// ∫ R dA over the seam for each function of one of its faces.
std::map<int, double> integrals(const Seam<3>& seam, const Surface<3>& face, bool is_master) {
  std::map<int, double> sums;
  FacePoint<3> at;
  for (const SeamPoint<3>& point : seam.points) {
    at.element = is_master ? point.master_element : point.slave_element;
    at.xi = is_master ? point.master_xi : point.slave_xi;
    face.functions(at, 0);
    for (int a = 0; a < face.functions_on(at.element); ++a)
      sums[face.nodes(at.element)[a]] += point.area * at.value[static_cast<std::size_t>(a)];
  }
  return sums;
}

/// Faces whose elements cross at an angle, the smaller one inside the larger one: whichever is the slave, the functions
/// of both are integrated exactly.
TEST(Seam, TurnedFacesInSpaceAreCutExactly) {
  const Surface<3> large = square_face(2, 3, true, 0), small = square_face(1, 4, false, 0.4);
  const Seam<3> one = find_seam(large, small, false), other = find_seam(small, large, false);
  EXPECT_NEAR(one.whole, 4, 1e-13);
  EXPECT_NEAR(other.whole, 1, 1e-13);
  EXPECT_NEAR(one.area, 1, 1e-12);
  EXPECT_NEAR(other.area, 1, 1e-12);
  for (const bool is_large : {true, false}) {
    const Surface<3>& face = is_large ? large : small;
    const auto first = integrals(one, face, !is_large);
    auto second = integrals(other, face, is_large);
    for (const auto& [function, value] : first) EXPECT_NEAR(value, second[function], 1e-13) << is_large << function;
  }
}

TEST(Tie, RowsSumToTheAreaOnBothSides) {
  for (const MultiplierSpace kind : {MultiplierSpace::equal, MultiplierSpace::reduced})
    for (const char* label : {"N2", "N3", "N2-N2.2"}) {
      const Surface<2> slave = line(0, 2, 0, 3, true, label), master = line(0, 2, 0, 5, false, label);
      const Tie<2> tie(slave, master, find_seam(slave, master, false), kind);
      double whole = 0;
      for (const auto& row : tie.rows()) {
        double sums[2] = {0, 0};
        for (const auto& [function, value] : row.slave) sums[0] += value;
        for (const auto& [function, value] : row.master) sums[1] += value;
        EXPECT_NEAR(sums[0], row.area, 1e-14);
        EXPECT_NEAR(sums[1], row.area, 1e-14);
        whole += row.area;
      }
      EXPECT_NEAR(whole, 2, 1e-13);
    }
}

TEST(Tie, MultipliersWithoutSupportAreLeftOut) {
  const Surface<2> slave = line(0, 2, 0, 8, true);
  const auto rows = [&](double to) {
    const Surface<2> master = line(0, to, 0, 5, false);
    return Tie<2>(slave, master, find_seam(slave, master, false), MultiplierSpace::equal).rows().size();
  };
  EXPECT_EQ(rows(2), 10u);
  EXPECT_EQ(rows(1), 6u); // on the first four elements
  EXPECT_EQ(rows(1.1), 7u);
}

} // namespace seam_test
} // namespace signorini::contact
