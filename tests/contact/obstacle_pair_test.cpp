// A face on a rigid obstacle, a closed-form shape or a curve: forces and tangents with the obstacle's translation, and
// friction around a disc.
#include "contact/couple.hpp"

#include <cmath>
#include <functional>
#include <numbers>

namespace signorini::contact {
namespace obstacle_pair_test {

using namespace test;

/// A curve from right to left, so that its outside is above.
nurbs::Patch reversed(const nurbs::Patch& curve) {
  std::vector<double> knots = curve.direction(0).knots();
  std::reverse(knots.begin(), knots.end());
  for (double& knot : knots) knot = -knot;
  return {{nurbs::KnotVector(curve.direction(0).degree(), knots)}, curve.homogeneous().rowwise().reverse()};
}

/// Obstacles with their top at (1.3, 0): a plane, a disc, and a wavy curve.
std::vector<Obstacle<2>> obstacles(Random& random) {
  return {make_plane<2>({1.3, 0}, {0.1, 2}), make_ball<2>({1.3, -2}, 2), make_ball<2>({1.3, -0.4}, 0.4),
          reversed(nurbs::test::patch_of(wavy(random, 3, 0.15, 3, 6).face(nurbs::side_of("north", 2))))};
}

TEST(ObstaclePair, TangentIsTheForcesDerivativeInEveryState) {
  Random random(1);
  Census sum;
  unsigned seed = 100;
  for (double mu : {0.0, 0.3})
    for (int round = 0; round < 3; ++round)
      for (const Obstacle<2>& obstacle : obstacles(random))
        sum.add(press_and_drag(Couple("N2-N2.1", obstacle, InterfaceLaw{100, 100, mu}, 1.3, 0.1), ++seed, 0.06,
                               {1e-3, 0.1, 0.25}));
  sum.expect({.states = 50, .open = 500, .stick = 100, .slip = 100});
  EXPECT_EQ(sum.elsewhere, 0); // one node for all slip points
}

/// Presses and drags back and forth, with friction; calls look(couple) in every state.
void wander(Couple& couple, const std::function<void(Couple&)>& look) {
  couple.touch().move_die(0, -0.05);
  for (double drag : {0.0, 0.001, 0.03, 0.05, -0.02, -0.1, 0.08}) {
    couple.move_die(drag, 0).evaluate();
    look(couple);
    couple.pair.accept();
  }
}

TEST(ObstaclePair, ForceOnTheObstacleIsMinusThatOnTheBody) {
  Random random(2);
  for (double mu : {0.0, 0.3})
    for (const Obstacle<2>& obstacle : obstacles(random)) {
      Couple couple("N2", obstacle, InterfaceLaw{100, 100, mu}, 1.3, 0.1);
      wander(couple, [&](Couple& now) {
        const Dense at = now.dense();
        Vec<2> on_die = Vec<2>::Zero();
        VectorX together = VectorX::Zero(now.u.size());
        for (int i = 0; i < now.die_dofs(); i += 2) on_die += at.force.segment<2>(i);
        const double size = at.force.norm();
        ASSERT_GT(size, 0);
        EXPECT_NEAR((on_die + at.force.tail<2>()).norm(), 0, 1e-14 * size);
        EXPECT_NEAR((now.pair.resultant().force - at.force.tail<2>()).norm(), 0, 1e-14 * size);
        // A common translation changes nothing.
        for (int c = 0; c < 2; ++c) {
          for (int i = c; i < now.u.size(); i += 2) together(i) = 1;
          EXPECT_NEAR((at.tangent * together).norm(), 0, 1e-13 * at.tangent.norm());
        }
        if (const auto* ball = std::get_if<Ball<2>>(&obstacle); ball && mu == 0) {
          // Without friction all forces pass through the center.
          const MatrixX points = now.die.points();
          double moment = 0;
          for (int a = 0; a < now.die.functions(); ++a) {
            const Vec<2> arm = Vec<2>(points.col(a)) + now.u.segment<2>(2 * a) - ball->center;
            moment += arm(0) * at.force(2 * a + 1) - arm(1) * at.force(2 * a);
          }
          EXPECT_NEAR(moment, 0, 1e-13 * size);
        }
      });
    }
}

TEST(ObstaclePair, OnlyRelativeMotionMatters) {
  Random random(3);
  for (const Obstacle<2>& obstacle : obstacles(random)) {
    Couple die("N2", obstacle, InterfaceLaw{100, 100, 0.3}, 1.3, 0.1), moved = die;
    die.touch();
    moved.touch();
    for (const Vec<2>& by : {Vec<2>(0, -0.05), Vec<2>(0.002, 0), Vec<2>(0.1, 0.01), Vec<2>(-0.03, 0)}) {
      die.move_die(by(0), by(1));
      moved.u.tail<2>() -= by;
      die.evaluate();
      moved.evaluate();
      const Dense a = die.dense(), b = moved.dense();
      ASSERT_GT(a.force.norm(), 0);
      EXPECT_NEAR((a.force - b.force).norm(), 0, 1e-12 * a.force.norm());
      EXPECT_NEAR((a.tangent - b.tangent).norm(), 0, 1e-12 * a.tangent.norm());
      die.pair.accept();
      moved.pair.accept();
    }
  }
}

/// A disc and a plane, as closed-form shapes and as exact NURBS curves, along a path with stick and slip.
TEST(ObstaclePair, CurvesAgreeWithClosedForms) {
  const Eigen::Vector2d center(1.3, -2);
  const std::vector<std::pair<Obstacle<2>, Obstacle<2>>> twins = {
      {make_ball<2>(center, 2), nurbs::arc(center, 2, 20, 160)}, // its C⁰ knot lies at the top
      {make_ball<2>(center, 2), nurbs::arc(center, 2, 50, 150)},
      {make_plane<2>({1.3, 0}, {0, 1}), nurbs::line(Eigen::Vector2d(3, 0), Eigen::Vector2d(0, 0))}};
  for (double mu : {0.0, 0.3})
    for (const auto& [form, curve] : twins) {
      std::vector<Dense> by_form, by_curve;
      Census census;
      Couple closed("N2", form, InterfaceLaw{100, 100, mu}, 1.33, 0.1),
          exact("N2", curve, InterfaceLaw{100, 100, mu}, 1.33, 0.1);
      wander(closed, [&](Couple& now) {
        by_form.push_back(now.dense());
        census.count(now.pair);
      });
      wander(exact, [&](Couple& now) { by_curve.push_back(now.dense()); });
      EXPECT_GT(census.stick, 20);
      EXPECT_EQ(census.slip > 20, mu > 0);
      for (std::size_t k = 0; k < by_form.size(); ++k) {
        EXPECT_NEAR((by_form[k].force - by_curve[k].force).norm(), 0, 1e-12 * by_form[k].force.norm()) << k;
        EXPECT_NEAR((by_form[k].tangent - by_curve[k].tangent).norm(), 0, 1e-12 * by_form[k].tangent.norm()) << k;
      }
    }
}

constexpr double radius = 0.8;

/// A die dragged around a disc at constant depth, by `turn` degrees per step. Returns the forces in the frame of the
/// first contact point.
std::vector<Resultant<2>> around(const Obstacle<2>& disc, double start, double turn, int steps) {
  constexpr double depth = 0.03;
  // The half annulus bulges downwards; rotated, it faces the disc.
  const nurbs::Patch arc = nurbs::half_annulus(0.3, 0.5, Eigen::Vector2d(0, 0));
  const auto direction = [](double degrees) { return Vec<2>(nurbs::direction_of(degrees)); };
  const nurbs::Patch facing =
      nurbs::translate(nurbs::rotate(arc, start - 90, Eigen::Vector2d(0, 0)), (radius + 0.5) * direction(start));
  Couple couple(discretize(facing, {6, 2}, "N2", "south"), "south", disc, InterfaceLaw{100, 100, 0.2}, 9);
  couple.evaluate().accept();
  const MatrixX points = couple.die.points();
  std::vector<Resultant<2>> results;
  for (int step = 0; step <= steps; ++step) {
    // The die rotates about the disc's center as a rigid body and is pressed towards it.
    const Mat<2> rotation = nurbs::rotation(step * turn, Eigen::Vector3d(0, 0, 1)).topLeftCorner<2, 2>();
    const Vec<2> press = -depth * direction(start + step * turn);
    for (int a = 0; a < points.cols(); ++a)
      couple.u.segment<2>(2 * a) = rotation * points.col(a) - points.col(a) + press;
    couple.evaluate();
    Resultant<2> resultant = couple.pair.resultant();
    couple.pair.accept();
    // After accepting, every slipping point is on the cone.
    const auto before = couple.pair.results();
    couple.evaluate();
    for (std::size_t i = 0; i < before.size(); ++i) {
      const auto& after = couple.pair.results()[i];
      EXPECT_EQ(after.state == ContactState::open, before[i].state == ContactState::open);
      if (before[i].state != ContactState::slip) continue;
      EXPECT_NEAR(after.friction.norm(), 0.2 * after.pressure, 1e-12 * after.pressure);
      EXPECT_GT(after.friction.dot(before[i].friction), 0.99 * before[i].friction.squaredNorm());
    }
    const Mat<2> back = nurbs::rotation(-(start + step * turn), Eigen::Vector3d(0, 0, 1)).topLeftCorner<2, 2>();
    resultant.force = back * resultant.force;
    results.push_back(resultant);
  }
  return results;
}

/// Results must not depend on the start angle, also where the angle jumps from π to −π or a closed curve ends.
TEST(ObstaclePair, FrictionAroundADiscIsIndependentOfTheSeam) {
  constexpr int steps = 40;
  const Obstacle<2> ball = make_ball<2>({0, 0}, radius), circle = nurbs::circle(Eigen::Vector2d(0, 0), radius);
  for (double turn : {1.0, -1.0}) {
    const auto seamless = around(ball, 90, turn, steps);
    for (const auto& across : {around(ball, 180 - 10 * turn, turn, steps), around(circle, -10 * turn, turn, steps)})
      for (std::size_t k = 0; k <= steps; ++k) {
        EXPECT_EQ(across[k].slipping, seamless[k].slipping) << k;
        EXPECT_EQ(across[k].active, seamless[k].active);
        EXPECT_NEAR((across[k].force - seamless[k].force).norm(), 0, 1e-11 * seamless[k].force.norm());
      }
    EXPECT_LT(seamless[0].slipping, seamless[0].active / 2); // only the edges slip during pressing
    EXPECT_NEAR(seamless[0].force(1), 0, 1e-12 * seamless[0].force(0));
    // All points slip, with friction against the motion: μ times the normal force, up to the spread of the normals
    EXPECT_EQ(seamless[steps].slipping, seamless[steps].active);
    EXPECT_GT(seamless[steps].force(0), 0);
    EXPECT_NEAR(seamless[steps].force(1) * turn, -0.2 * seamless[steps].force(0), 0.01 * seamless[steps].force(0));
  }
}

} // namespace obstacle_pair_test
} // namespace signorini::contact
