#include "nurbs/curves.hpp"

#include "measure.hpp"
#include "random_patch.hpp"

#include <gtest/gtest.h>

namespace signorini::nurbs {
namespace curves_test {

using namespace test;
using std::numbers::pi;

VectorX xi(double value) {
  return VectorX::Constant(1, value);
}

TEST(Line, IsStraightAndUniform) {
  const Patch patch = line(Vec<3>(1, 2, 3), Vec<3>(2, 4, 5));
  EXPECT_LT((evaluate(patch, xi(0.25)) - Vec<3>(1.25, 2.5, 3.5)).norm(), 1e-15);
  EXPECT_NEAR(measure(patch).content, 3, 1e-14);
  EXPECT_ERROR(line(Vec<2>(1, 2), Vec<3>(1, 2, 3)),
               "nurbs.transform.coordinates: argument = to, expected = 2, count = 3");
  EXPECT_ERROR(line(Vec<2>(1, 2), Vec<2>(1, 2)), "nurbs.line.point: point = (1, 2)");
  EXPECT_ERROR(line(VectorX::Ones(4), VectorX::Ones(4)),
               "nurbs.transform.coordinates: argument = from, expected = 2, count = 4");
  EXPECT_ERROR(line(Vec<2>(std::nan(""), 2), Vec<2>(1, 2)), "nurbs.transform.finite");
}

TEST(Arc, IsACircleOfExactLengthForAnyAngle) {
  Random random(21);
  for (int run = 0; run < 40; ++run) {
    const double radius = uniform(random, 0.1, 10), start = uniform(random, -400, 400);
    double turn = uniform(random, -360, 360);
    if (run % 5 == 0) turn = 90 * (1 + run / 5 % 4);
    const Vec<2> center(uniform(random, -1, 1), uniform(random, -1, 1));
    const Patch patch = arc(center, radius, start, start + turn);
    EXPECT_EQ(patch.direction(0).elements(), static_cast<int>(std::ceil(std::abs(turn) / 90 - 1e-9)));
    for (double t : {0.0, 0.1, 0.37, 0.5, 0.77, 1.0})
      EXPECT_NEAR((evaluate(patch, xi(t)) - center).norm(), radius, 2e-15 * (radius + 2));
    EXPECT_NEAR(measure(patch).content, radius * std::abs(turn) * pi / 180, 1e-12 * radius);
    const double stop = (start + turn) * pi / 180;
    EXPECT_LT((evaluate(patch, xi(1)) - center - radius * Vec<2>(std::cos(stop), std::sin(stop))).norm(),
              1e-14 * radius);
    // The derivative at the start points counter-clockwise for increasing angles.
    const double angle = start * pi / 180;
    const VectorX tangent = derivatives(patch, xi(0), 1)[1].value;
    EXPECT_GT(tangent.dot(Vec<2>(-std::sin(angle), std::cos(angle))) * turn, 0);
  }
}

TEST(Arc, QuarterPointsAreExactAndKnotsEquallySpaced) {
  const Patch patch = circle(Vec<2>(0, 0), 2);
  EXPECT_EQ(patch.direction(0).knots(), (std::vector<double>{0, 0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1, 1}));
  const MatrixX points = patch.points();
  EXPECT_EQ(points.col(0), Vec<2>(2, 0));
  EXPECT_EQ(points.col(2), Vec<2>(0, 2));
  EXPECT_EQ(points.col(4), Vec<2>(-2, 0));
  EXPECT_EQ(points.col(6), Vec<2>(0, -2));
  EXPECT_EQ(points.col(8), Vec<2>(2, 0));
  EXPECT_LT((points.col(1) - Vec<2>(2, 2)).norm(), 1e-15);
  EXPECT_DOUBLE_EQ(patch.weights()(1), std::sqrt(0.5));
  EXPECT_EQ(arc(Vec<2>(0, 0), 1, 10, 100).direction(0).elements(), 1);
  EXPECT_EQ(arc(Vec<2>(0, 0), 1, 59.3, 149.3).direction(0).elements(), 1); // 149.3 − 59.3 > 90 in doubles
  EXPECT_EQ(arc(Vec<2>(0, 0), 1, 0, 90.001).direction(0).elements(), 2);
}

TEST(Arc, InSpaceHasTheZOfItsCenter) {
  const Patch patch = arc(Vec<3>(1, 2, 3), 0.5, 30, 200);
  for (double t : {0.0, 0.3, 1.0}) {
    EXPECT_NEAR(evaluate(patch, xi(t))(2), 3, 1e-14);
    EXPECT_NEAR((evaluate(patch, xi(t)) - Vec<3>(1, 2, 3)).norm(), 0.5, 1e-14);
  }
}

TEST(Arc, RejectsInvalidArguments) {
  const Vec<2> origin(0, 0);
  EXPECT_ERROR(arc(origin, 0, 0, 90), "nurbs.arc.radius: radius = 0");
  EXPECT_ERROR(arc(origin, -1, 0, 90), "nurbs.arc.radius: radius = -1");
  EXPECT_ERROR(arc(origin, std::nan(""), 0, 90), "nurbs.arc.radius");
  EXPECT_ERROR(circle(origin, HUGE_VAL), "nurbs.arc.radius: radius = inf");
  EXPECT_ERROR(arc(origin, 1, 45, 45), "nurbs.arc.empty: angle = 45");
  EXPECT_ERROR(arc(origin, 1, 0, 400), "nurbs.arc.turn: start = 0, stop = 400");
  EXPECT_ERROR(arc(origin, 1, 0, HUGE_VAL), "nurbs.arc.angles: start = 0, stop = inf");
  EXPECT_ERROR(arc(VectorX::Zero(4), 1, 0, 90),
               "nurbs.transform.coordinates: argument = center, expected = 2, count = 4");
}

} // namespace curves_test
} // namespace signorini::nurbs
