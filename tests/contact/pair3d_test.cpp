// A contact of solids: force and tangent against finite differences in every state, on smooth and kinked surfaces and
// on obstacles, balance of forces and moments, Coulomb's law for any direction of slip, reversal and twisting.
#include "contact/couple3d.hpp"
#include "contact/level_sets.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace signorini::contact {
namespace pair3d_test {

using namespace test;

/// Presses, drags back and forth, twists, with a comparison after each, starting from random displacements.
void wander(Couple3 couple, unsigned seed, double depth, Census& census) {
  Random random(seed);
  couple.shake(random, 0.003).touch().move_die({0, 0, -depth}).shake(random, 0.001);
  compare_with_differences(couple, random, census);
  couple.pair.accept();
  drag_and_compare(couple, random, {{3e-4, 1e-4, 0}, {0.02, 0.03, 0}, {-0.05, 0.01, 0}, {0.3, 0.2, 0}}, census);
  couple.turn_die(0.1, {1.5, 1.5, 0});
  compare_with_differences(couple, random, census);
}

TEST(SolidPair, TangentIsTheForcesDerivativeInEveryState) {
  Random random(1);
  Census sum;
  unsigned seed = 0;
  for (const char* label : {"N2", "N3", "N2-N2.1"})
    for (double mu : {0.0, 0.3})
      for (int degree : {1, 2, 3})
        wander(Couple3(label, wavy_plate(random, 3, 0.02, degree, 4), InterfaceLaw{100, 80, mu}, {1.4, 1.5, 0.1}),
               ++seed, 0.05, sum);
  sum.expect({.states = 60, .stick = 200, .slip = 200, .elsewhere = 10});
}

TEST(SolidPair, TangentIsTheForcesDerivativeOnEdgesAndCorners) {
  // A pit of four planes: its kinks and its deepest point are the foot points of penetrating points.
  const nurbs::KnotVector two(1, {0, 0, 1, 2, 2});
  MatrixX points(3, 9);
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i)
      points.col(i + 3 * j) << 1.5 * i, 1.5 * j, 0.15 * std::max(std::abs(i - 1), std::abs(j - 1));
  const auto pit = below({two, two}, points, VectorX::Ones(9));
  for (double mu : {0.0, 0.3}) {
    Random random(5);
    Couple3 couple("N2", pit, InterfaceLaw{100, 80, mu}, {1.5, 1.5, 0.05}, 12);
    couple.touch().move_die({0.0002, 0.0001, -0.12}).evaluate();
    int off_normal = 0;
    FacePoint<3> foot;
    Master<3> master(top_of(pit));
    for (const auto& point : couple.pair.results()) {
      const Foot kind = master.project(point.position, {}, foot).foot;
      off_normal += point.state != ContactState::open && (kind == Foot::edge || kind == Foot::corner);
    }
    EXPECT_GE(off_normal, 4);
    couple.pair.accept();
    Census census;
    for (const Vec<3>& drag : {Vec<3>(2e-4, 1e-4, 0), Vec<3>(0.002, -0.001, 0)}) {
      couple.move_die(drag);
      compare_with_differences(couple, random, census);
    }
    EXPECT_EQ(census.states, 2) << census.stepped_over;
  }
}

/// Obstacles whose tops are at (1.5, 1.5, 0).
std::vector<Obstacle<3>> obstacles(Random& random) {
  return {make_plane<3>({1.5, 1.5, 0}, {0.1, -0.05, 2}), make_ball<3>({1.5, 1.5, -2}, 2),
          make_cylinder({1.5, 1.5, -1}, {1, 0.3, 0}, 1),
          nurbs::test::patch_of(wavy_plate(random, 3, 0.03, 2, 4).face(nurbs::side_of("back", 3)))};
}

/// Tori, bowls and waves whose surfaces contain (1.5, 1.5, 0).
std::vector<Obstacle<3>> curved_obstacles() {
  const auto waves = [](const std::vector<Term>& x) {
    return x[2] - 0.05 * (cosine(3 * (x[0] - 1.5)) + cosine(2 * (x[1] - 1.5)) - 2);
  };
  return {make_torus({0.3, 1.5, -0.6}, {0, 0, 1}, 1.2, 0.6), make_torus({-1.5, 1.5, 3}, {0, 0, 1}, 3, 3 - 1e-6, true),
          make_ball<3>({1.5, 1.5, 3}, 3, true), level_set<3>(waves, Vec<3>(1.5, 1.5, 0), 1.5)};
}

TEST(SolidPair, TangentIsTheForcesDerivativeOnCurvedObstacles) {
  Census sum;
  unsigned seed = 300;
  for (double mu : {0.0, 0.3})
    for (const Obstacle<3>& obstacle : curved_obstacles())
      wander(Couple3("N2", obstacle, InterfaceLaw{100, 80, mu}, {1.5, 1.5, 0.1}), ++seed, 0.05, sum);
  sum.expect({.states = 30, .stick = 50, .slip = 50});
}

TEST(SolidPair, TangentIsTheForcesDerivativeOnObstacles) {
  Random random(2);
  Census sum;
  unsigned seed = 50;
  for (double mu : {0.0, 0.3})
    for (const Obstacle<3>& obstacle : obstacles(random))
      wander(Couple3("N2", obstacle, InterfaceLaw{100, 80, mu}, {1.5, 1.5, 0.1}), ++seed, 0.05, sum);
  sum.expect({.states = 25, .stick = 100, .slip = 100});
}

TEST(SolidPair, ForcesBalanceAndWithoutFrictionMomentsToo) {
  Random random(4);
  for (double mu : {0.0, 0.3})
    for (int trial = 0; trial < 4; ++trial) {
      Couple3 couple("N2", wavy_plate(random, 3, 0.03, 2, 4), InterfaceLaw{100, 100, mu}, {1.4, 1.5, 0.1});
      couple.touch().move_die({0.02, 0.01, -0.06}).shake(random, 0.003);
      expect_balanced(couple, mu);
    }
}

TEST(SolidPair, SlipFollowsAnyDirectionAtCoulombsLimit) {
  // On a plane with fixed control points the traction is parallel to the motion in any direction.
  Random random(6);
  const double mu = 0.25;
  for (const Obstacle<3>& obstacle : obstacles(random)) {
    Couple3 couple("N2", obstacle, InterfaceLaw{100, 100, mu}, {1.5, 1.5, 0.1});
    couple.touch().move_die({0, 0, -0.05}).evaluate().accept();
    for (int step = 0; step < 12; ++step) {
      const double angle = 0.5 * step; // turns and comes back
      const Vec<3> drag(0.02 * std::cos(angle), 0.02 * std::sin(angle), 0);
      couple.move_die(drag).evaluate();
      for (const auto& point : couple.pair.results()) {
        if (point.state == ContactState::open) continue;
        EXPECT_LE(point.friction.norm(), mu * point.pressure * (1 + 1e-12));
        if (point.state == ContactState::slip) {
          EXPECT_NEAR(point.friction.norm(), mu * point.pressure, 1e-12 * point.pressure);
        }
      }
      const Resultant<3> here = couple.pair.resultant();
      couple.pair.accept();
      // The accepted slip points give the same forces; on curved faces up to the chord to the slip point, whose
      // inclination decreases with its length.
      couple.evaluate();
      const double tolerance = std::holds_alternative<Plane<3>>(obstacle) ? 1e-12 : 5e-3;
      EXPECT_LE((couple.pair.resultant().force - here.force).norm(), tolerance * here.force.norm()) << "step " << step;
    }
  }
}

TEST(SolidPair, TwistingIsMuTimesPressureTimesRadius) {
  // Far beyond the limit of sticking every point slips around the axis: M = μ ∫ p r da.
  const double mu = 0.4;
  Couple3 couple("N2", make_plane<3>({0, 0, 0}, {0, 0, 1}), InterfaceLaw{100, 1e4, mu}, {0, 0, 0.1});
  couple.touch().move_die({0, 0, -0.05}).evaluate().accept();
  for (int step = 0; step < 20; ++step) {
    couple.turn_die(0.05, Vec<3>::Zero()).evaluate().accept();
  }
  double moment = 0, expected = 0;
  for (const auto& point : couple.pair.results()) {
    moment += point.position.head<2>().dot(Eigen::Vector2d(point.force(1), -point.force(0)));
    expected += mu * point.pressure * point.area * point.position.head<2>().norm();
  }
  EXPECT_GT(expected, 0);
  EXPECT_NEAR(std::abs(moment), expected, 2e-3 * expected);
}

} // namespace pair3d_test
} // namespace signorini::contact
