// Counts of searches that end at their limit of iterations.

#include "contact/faces.hpp"

#include <gtest/gtest.h>

namespace signorini::contact {
namespace unsettled_test {

using namespace test;

/// The line y = 0 from x = 1 to −1, outward up, as x = −(2ξ − 1)⁷: at ξ = 1/2 six derivatives vanish, so that Newton's
/// method for the closest point to (0, y) reduces the distance by 1/13 in each iteration.
nurbs::Patch singular_line() {
  MatrixX points = MatrixX::Zero(2, 8);
  for (int i = 0; i < 8; ++i) points(0, i) = i % 2 == 0 ? 1 : -1; // Bernstein coefficients
  return nurbs::make_patch({nurbs::KnotVector::single(7)}, points, VectorX::Ones(8));
}

TEST(Unsettled, ProjectionReportsItsLimitOfIterations) {
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
  const nurbs::Discretization block =
      discretize(nurbs::rectangle(2, 1, Eigen::Vector2d(-1, -0.1)), {1, 1}, "N1", "south");
  Pair<2> pair(Surface<2>(block, nurbs::side_of("south", 2)), Obstacle<2>(singular_line()), InterfaceLaw{1}, 1);
  const Vec<2> rest = Vec<2>::Zero();
  const auto evaluate = [&](double x) { // of the only contact point
    const MatrixX u = Eigen::Vector2d(x, 0).replicate(1, block.functions());
    pair.evaluate(u.data(), rest.data());
  };
  evaluate(-0.9);
  evaluate(0);
  EXPECT_FALSE(pair.results().front().settled);
  EXPECT_EQ(pair.formulation().counters.unsettled, 0);
  pair.accept();
  EXPECT_EQ(pair.formulation().counters.unsettled, 1);
  EXPECT_EQ(pair.formulation().counters.unsettled_at, Vec<2>(0, -0.1));
  evaluate(0.7);
  pair.accept();
  EXPECT_EQ(pair.formulation().counters.unsettled, 1);
}

/// A roof: two planes that meet at a right angle above the y-axis, with the outside above.
nurbs::Patch roof() {
  MatrixX points(3, 6);
  points << -1, 0, 1, -1, 0, 1, -1, -1, -1, 1, 1, 1, -1, 0, -1, -1, 0, -1;
  return nurbs::make_patch({nurbs::KnotVector(1, {0, 0, 1, 2, 2}), nurbs::KnotVector::single(1)}, points,
                           VectorX::Ones(6));
}

/// Presses a contact point on the left plane of the roof, then on the right one, in one step across the ridge. Returns
/// the number of unsettled points. `length`: distance of the slip point from the foot point that friction allows.
std::size_t unsettled_across(double length) {
  constexpr double depth = 0.1, tangential = 1;
  const auto place = [](double x) -> Vec<3> { // its foot point is at x, z = −|x|
    return Vec<3>(x, 0, -std::abs(x)) - depth / std::sqrt(2.0) * Vec<3>(x < 0 ? -1 : 1, 0, 1);
  };
  const Vec<3> start = place(-0.4);
  const nurbs::Discretization block =
      discretize(nurbs::block({0.2, 0.2, 0.2}, start - Vec<3>(0.1, 0.1, 0)), {1, 1, 1}, "N1", "front");
  Pair<3> pair(Surface<3>(block, nurbs::side_of("front", 3)), Obstacle<3>(roof()),
               InterfaceLaw{1, tangential, tangential * length / depth}, 1);
  const Vec<3> rest = Vec<3>::Zero();
  const auto press = [&](double x) {
    const MatrixX u = (place(x) - start).replicate(1, block.functions());
    pair.evaluate(u.data(), rest.data());
    pair.accept();
  };
  press(-0.4);
  EXPECT_EQ(pair.results().front().state, ContactState::stick);
  EXPECT_EQ(pair.formulation().counters.unsettled, 0);
  press(0.4);
  EXPECT_EQ(pair.results().front().state, ContactState::slip);
  EXPECT_TRUE(pair.formulation().counters.unsettled == 0 || pair.formulation().counters.unsettled_at.isApprox(start));
  return pair.formulation().counters.unsettled;
}

TEST(Unsettled, PairCountsSlipPointsNotFound) {
  // The slip point is the projection of a point of the chord, 0.8 long, between the planes. The chord's midpoint is as
  // near to a point 0.4/√2 from the foot point as to one on the other plane, 0.4 √5/√2 from it; points in between are
  // not the closest to any point of the chord.
  EXPECT_EQ(unsettled_across(0.2), 0u);
  EXPECT_EQ(unsettled_across(0.6), 1u);
}

} // namespace unsettled_test
} // namespace signorini::contact
