// Tabulated spaces: splines compared with their knots, joins of several degrees, and bodies with rows of such spaces.
#include "nurbs/space1d.hpp"

#include "nurbs/archive.hpp"
#include "nurbs/basis.hpp"
#include "nurbs/bezier.hpp"
#include "nurbs/bezier_element.hpp"
#include "nurbs/coincident.hpp"
#include "nurbs/joins.hpp"
#include "nurbs/random_patch.hpp"

#include <gtest/gtest.h>

namespace signorini::nurbs {
namespace space1d_test {

std::vector<Element1D> elements_of(const Space1D& space) {
  std::vector<Element1D> elements;
  for (int e = 0; e < space.elements(); ++e) elements.push_back(space.element(e));
  return elements;
}

/// Values and derivatives up to the second, functions in rows.
MatrixX derivatives_of(const Space1D& space, int element, double xi) {
  MatrixX result(static_cast<Eigen::Index>(space.functions_on(element).size()), 3);
  basis_derivatives(space, element, xi, 2, result.data());
  return result;
}

TEST(Space1D, TablesOfSplinesAgreeWithTheirKnots) {
  test::Random random(1);
  for (int degree = 0; degree <= 6; ++degree) {
    const KnotVector knots = test::random_knots(random, degree, 4);
    const Space1D space = spline_space(knots);
    const Space1D table(space.breaks(), space.smoothness(), elements_of(space));
    EXPECT_EQ(space.functions(), knots.functions());
    EXPECT_EQ(space.elements(), knots.elements());
    EXPECT_EQ(space.degree(), degree);
    EXPECT_NE(space, table); // without knots
    for (int e = 0; e < space.elements(); ++e) {
      EXPECT_EQ(space.functions_on(e).front(), knots.first_function(e));
      EXPECT_EQ(MatrixX(space.extraction(e)), bezier_extraction(knots, e));
      EXPECT_EQ(space.smoothness()[e], std::max(degree - knots.multiplicity(knots.breaks()[e]), -1));
      const auto [from, to] = space.interval(e);
      const double xi = test::uniform(random, from, to);
      EXPECT_EQ(space.find_element(xi), e);
      std::vector<double> expected(3 * (degree + 1));
      basis_derivatives(knots, e, xi, 2, expected.data());
      const MatrixX own = derivatives_of(space, e, xi), extracted = derivatives_of(table, e, xi);
      const double scale = 1 + own.cwiseAbs().maxCoeff();
      EXPECT_EQ(own, Eigen::Map<const MatrixX>(expected.data(), degree + 1, 3));
      EXPECT_LT((extracted - own).cwiseAbs().maxCoeff(), 1e-12 * scale);
    }
  }
}

TEST(Space1D, JoinOfTwoDegrees) {
  const Space1D space = test::joined({2, 4, 4, 1});
  EXPECT_EQ(space.functions(), 12);
  EXPECT_EQ(space.degree(), 4);
  EXPECT_EQ(space.degree(0), 2);
  EXPECT_EQ(space.functions_on(1).size(), 5u);
  EXPECT_EQ(space.functions_on(1).front(), 2);
  for (int e = 0; e < space.elements(); ++e) {
    const auto [from, to] = space.interval(e);
    for (double t : {0.0, 0.3, 1.0}) {
      const MatrixX own = derivatives_of(space, e, from + t * (to - from));
      EXPECT_NEAR((own.colwise().sum() - Eigen::RowVector3d(1, 0, 0)).norm(), 0, 1e-12);
      // x = ξ from its control points
      double x = 0, slope = 0;
      for (std::size_t a = 0; a < space.functions_on(e).size(); ++a) {
        const double point = test::linear_points(space)[space.functions_on(e)[a]];
        x += own(static_cast<int>(a), 0) * point;
        slope += own(static_cast<int>(a), 1) * point;
      }
      EXPECT_NEAR(x, from + t * (to - from), 1e-15);
      EXPECT_NEAR(slope, 1, 1e-14);
    }
  }
}

TEST(Space1D, RejectsInconsistentTables) {
  const std::vector<Element1D> line{{1, {0, 1}, MatrixX::Identity(2, 2)}};
  EXPECT_ERROR(Space1D({0, 0.5, 1}, {-1, 0, -1}, line),
               "nurbs.space.breakpoints: elements = 1, breakpoints = 3, smoothness = 3");
  EXPECT_ERROR(Space1D({0, 0}, {-1, -1}, line), "nurbs.space.rising: first = 0, second = 0");
  EXPECT_ERROR(Space1D({0, 1}, {-1, -1}, {{1, {0}, MatrixX::Identity(2, 2)}}),
               "nurbs.space.extraction: element = 0, degree = 1, functions = 1, rows = 2, columns = 2");
  EXPECT_ERROR(Space1D({0, 1}, {-1, -1}, {{1, {0, 1}, 2 * MatrixX::Identity(2, 2)}}), "nurbs.space.sum: element = 0");
  EXPECT_ERROR(Space1D({0, 1}, {-1, -1}, {{1, {1, 0}, MatrixX::Identity(2, 2)}}), "nurbs.space.numbers: element = 0");
  EXPECT_ERROR(Space1D({0, 1}, {-1, -1}, {{1, {0, 2}, MatrixX::Identity(2, 2)}}), "nurbs.space.unused");
}

/// A quadratic lower row, degrees 2 and 4 in the upper one.
TEST(Space1D, BodyWithARowOfTwoDegrees) {
  const Discretization space = test::strip(3, {2, 4, 2, 4});
  EXPECT_EQ(space.functions(), 9 + 13);
  EXPECT_EQ(space.degree(0, 0), 2);
  EXPECT_EQ(space.degree(1, 0), 4);
  EXPECT_TRUE(coincident_functions(space).empty());
  EXPECT_EQ(space.face({1, true}).direction(0), test::joined({2, 4, 2, 4}));
  EXPECT_EQ(space.face({0, false}).functions(), 2);
  const MatrixX points = space.points();
  test::Random random(2);
  for (int e = 0; e < space.elements(); ++e) {
    const auto [from, to] = space.interval(e, 0);
    const Eigen::Vector2d xi(test::uniform(random, from, to), test::uniform(random, 0, 1));
    EXPECT_EQ(space.find_element(xi), e);
    const ElementBasis basis = space.basis(e, xi);
    EXPECT_EQ(basis.functions.size(), e % 2 == 0 ? 6u : 8u);
    Eigen::Vector2d place = Eigen::Vector2d::Zero();
    Mat<2> jacobian = Mat<2>::Zero();
    for (std::size_t a = 0; a < basis.functions.size(); ++a) {
      place += points.col(basis.functions[a]) * basis.values(static_cast<int>(a));
      jacobian += points.col(basis.functions[a]) * basis.gradients.col(static_cast<int>(a)).transpose();
    }
    EXPECT_NEAR((place - Eigen::Vector2d(3 * xi(0), xi(1))).norm(), 0, 1e-14);
    EXPECT_NEAR((jacobian - Mat<2>(Eigen::Vector2d(3, 1).asDiagonal())).norm(), 0, 1e-13);

    // The Bézier form represents the same functions.
    const BezierElement element = bezier_element(space, e);
    EXPECT_EQ(element.functions, basis.functions);
    EXPECT_EQ(element.degrees, (std::vector{e % 2 == 0 ? 2 : 4, 1}));
    VectorX along(element.degrees[0] + 1), across(2);
    bernstein(element.degrees[0], (xi(0) - from) / (to - from), 1, 0, along.data());
    bernstein(1, xi(1), 1, 0, across.data());
    VectorX product(along.size() * 2);
    product << along * across(0), along * across(1);
    EXPECT_NEAR((element.extraction * product - basis.values).norm(), 0, 1e-14);
  }
}

TEST(Space1D, FilesPreserveAllBits) {
  for (const Discretization& space :
       {test::strip(3, {2, 4}),
        Discretization(1, spline_space(KnotVector::single(1)),
                       {test::strip(3, {2, 2}).rows()[0], test::strip(3, {2, 2}).rows()[1]}, {})}) {
    ArchiveWriter to;
    to.put(space);
    ArchiveReader from(to.bytes());
    const auto read = from.get<Discretization>();
    EXPECT_EQ(from.remaining(), 0u);
    EXPECT_EQ(read.stack(), space.stack());
    EXPECT_TRUE(read.stack().knots());
    EXPECT_EQ(read.homogeneous(), space.homogeneous());
    for (std::size_t j = 0; j < space.rows().size(); ++j)
      EXPECT_EQ(read.rows()[j].directions(), space.rows()[j].directions());
  }
}

TEST(Space1D, BodiesNeedSpacesThatInterpolateAtTheirEnds) {
  const Space1D line = spline_space(KnotVector::single(1));
  // Two functions are nonzero at the start
  const Space1D blurred({0, 1}, {-1, -1}, {{1, {0, 1}, (MatrixX(2, 2) << 0.9, 0, 0.1, 1).finished()}});
  const Row good({line}, (MatrixX(3, 2) << 0, 1, 0, 0, 1, 1).finished()), bad({blurred}, good.homogeneous());
  EXPECT_ERROR(Discretization(1, line, {good, bad}, {}), "nurbs.space.ends");
}

} // namespace space1d_test
} // namespace signorini::nurbs
