// Searches that end at their limit of iterations are counted.

#include "contact/faces.hpp"

#include <gtest/gtest.h>

namespace signorini::contact {
namespace unsettled_test {

using namespace test;

/// The line y = 0 from x = 1 to −1, outward up, as x = −(2ξ − 1)⁷: at ξ = 1/2 six derivatives vanish, so that Newton's
/// method for the closest point to (0, y) takes off 1/13 of the distance in each iteration.
nurbs::Patch singular_line() {
  MatrixX points = MatrixX::Zero(2, 8);
  for (int i = 0; i < 8; ++i) points(0, i) = i % 2 == 0 ? 1 : -1; // Bernstein coefficients
  return nurbs::make_patch({nurbs::KnotVector::single(7)}, points, VectorX::Ones(8));
}

TEST(Unsettled, ProjectionSaysThatItRanOutOfIterations) {
  const Surface<2> line(singular_line());
  ElementBoxes<2> boxes;
  boxes.update(line);
  Projection<2> seed;
  seed.element = 0;
  seed.xi(0) = 0.99;
  FacePoint<2> point;
  EXPECT_EQ(project(line, boxes, {0, 0.1}, seed, point).foot, Foot::regular);
  EXPECT_FALSE(point.settled);
  EXPECT_NEAR(project(line, boxes, {-0.7, 0.1}, seed, point).gap, 0.1, 1e-14);
  EXPECT_TRUE(point.settled);
}

TEST(Unsettled, PairCountsAcceptedStatesOnly) {
  const nurbs::Discretisation block =
      discretise(nurbs::rectangle(2, 1, Eigen::Vector2d(-1, 0.1)), {1, 1}, "N1", "south");
  Pair<2> pair(Surface<2>(block, nurbs::side_of("south", 2)), Obstacle<2>(singular_line()), PenaltyLaw{1}, 1);
  const Vec<2> rest = Vec<2>::Zero();
  const auto evaluate = [&](double x) { // of the only contact point
    const MatrixX u = Eigen::Vector2d(x, 0).replicate(1, block.functions());
    pair.evaluate(u.data(), rest.data());
  };
  evaluate(-0.9);
  evaluate(0);
  EXPECT_FALSE(pair.results().front().settled);
  EXPECT_EQ(pair.unsettled(), 0u);
  pair.accept();
  EXPECT_EQ(pair.unsettled(), 1u);
  EXPECT_EQ(pair.unsettled_position(), Vec<2>(0, 0.1));
  evaluate(0.7);
  pair.accept();
  EXPECT_EQ(pair.unsettled(), 1u);
}

} // namespace unsettled_test
} // namespace signorini::contact
