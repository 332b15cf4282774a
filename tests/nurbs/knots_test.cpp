#include "nurbs/knots.hpp"

#include "random_patch.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace signorini::nurbs {
namespace knots_test {

using namespace test;

TEST(Knots, CountsSpansAndFunctions) {
  const KnotVector knots(2, {0, 0, 0, 1, 1, 3, 4, 4, 4});
  EXPECT_EQ(knots.functions(), 6);
  EXPECT_EQ(knots.elements(), 3);
  EXPECT_EQ(knots.breaks(), (std::vector<double>{0, 1, 3, 4}));
  EXPECT_EQ(knots.span(0), 2);
  EXPECT_EQ(knots.span(1), 4);
  EXPECT_EQ(knots.span(2), 5);
  EXPECT_EQ(knots.first_function(1), 2);
  EXPECT_EQ(knots.multiplicity(0), 3);
  EXPECT_EQ(knots.multiplicity(1), 2);
  EXPECT_EQ(knots.multiplicity(3), 1);
  EXPECT_EQ(knots.multiplicity(2), 0);
}

TEST(Knots, FindsTheElementFromTheLeftAndTheLastAtTheEnd) {
  const KnotVector knots(2, {0, 0, 0, 1, 1, 3, 4, 4, 4});
  EXPECT_EQ(knots.find_element(0), 0);
  EXPECT_EQ(knots.find_element(0.999), 0);
  EXPECT_EQ(knots.find_element(1), 1);
  EXPECT_EQ(knots.find_element(3), 2);
  EXPECT_EQ(knots.find_element(4), 2);
  EXPECT_ERROR(knots.find_element(-1e-9),
               "nurbs.knots.just_outside: xi = -1e-09, first = 0, last = 4, distance = 1e-09");
  EXPECT_ERROR(knots.find_element(4 + 1e-11), "nurbs.knots.just_outside");
  EXPECT_EQ(knots.find_element(-1e-13), 0); // rounding
  EXPECT_EQ(knots.find_element(4 + 1e-13), knots.elements() - 1);
  EXPECT_ERROR(knots.find_element(4.1), "nurbs.knots.outside: xi = 4.1, first = 0, last = 4");
  EXPECT_ERROR(knots.find_element(std::numeric_limits<double>::quiet_NaN()), "outside");
}

TEST(Knots, GrevilleAbscissaeAreKnotAverages) {
  EXPECT_EQ(KnotVector(2, {0, 0, 0, 1, 1, 3, 4, 4, 4}).greville(), (std::vector<double>{0, 0.5, 1, 2, 3.5, 4}));
  EXPECT_EQ(KnotVector(0, {0, 1, 4}).greville(), (std::vector<double>{0.5, 2.5}));
  const std::vector<double> ends = KnotVector(3, {0.1, 0.1, 0.1, 0.1, 0.7, 0.7, 0.7, 0.7}).greville();
  EXPECT_EQ(ends.front(), 0.1);
  EXPECT_EQ(ends.back(), 0.7);
}

TEST(Knots, SingleIsOneBezierElement) {
  EXPECT_EQ(KnotVector::single(2), KnotVector(2, {0, 0, 0, 1, 1, 1}));
  EXPECT_FALSE(KnotVector::single(2) == KnotVector::single(1));
  EXPECT_ERROR(KnotVector::single(16), "nurbs.knots.degree: degree = 16, most = 15");
}

TEST(Knots, InvalidOnesAreRejectedWithTheReason) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_ERROR(KnotVector(-1, {0, 1}), "nurbs.knots.degree: degree = -1, most = 15");
  EXPECT_ERROR(KnotVector(16, std::vector<double>(40)), "nurbs.knots.degree: degree = 16, most = 15");
  EXPECT_ERROR(KnotVector(2, {0, 0, 1, 1}), "nurbs.knots.count: degree = 2, least = 6, ends = 3, count = 4");
  EXPECT_ERROR(KnotVector(1, {}), "nurbs.knots.count: degree = 1, least = 4, ends = 2, count = 0");
  EXPECT_ERROR(KnotVector(1, {0, 0, nan, 1, 1}), "nurbs.knots.finite");
  EXPECT_ERROR(KnotVector(1, {0, 0, 1, std::numeric_limits<double>::infinity()}),
               "nurbs.knots.finite: number = 3, knot = inf");
  EXPECT_ERROR(KnotVector(1, {0, 0, 0.6, 0.4, 1, 1}),
               "nurbs.knots.order: number = 3, knot = 0.4, before = 2, knot_before = 0.6");
  EXPECT_ERROR(KnotVector(1, {2, 2, 2, 2}), "nurbs.knots.equal: knot = 2");
  EXPECT_ERROR(KnotVector(2, {0, 0, 0.5, 1, 1, 1}),
               "nurbs.knots.first_ends: knot = 0, count = 2, degree = 2, expected = 3");
  EXPECT_ERROR(KnotVector(2, {0, 0, 0, 0, 1, 1, 1}),
               "nurbs.knots.first_ends: knot = 0, count = 4, degree = 2, expected = 3");
  EXPECT_ERROR(KnotVector(2, {0, 0, 0, 1, 1, 1, 1}),
               "nurbs.knots.last_ends: knot = 1, count = 4, degree = 2, expected = 3");
  EXPECT_ERROR(KnotVector(2, {0, 0, 0, 0.5, 0.5, 0.5, 1, 1, 1}),
               "nurbs.knots.interior: knot = 0.5, count = 3, degree = 2");
  EXPECT_ERROR(KnotVector(1, {0, 0, 0.5, 0.5 + 1e-15, 1, 1}), "nurbs.knots.close");
}

} // namespace knots_test
} // namespace signorini::nurbs
