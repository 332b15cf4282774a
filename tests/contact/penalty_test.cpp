// The penalty law's tangent and the shift of the foot point against finite differences: 2D, axisymmetric and 3D.
#include "contact/local_cases.hpp"

#include <numbers>

namespace signorini::contact {
namespace penalty_test {

using namespace test;

template <int D> void tangent_and_shift(Foot foot, double reach, ContactState expected, bool revolved = false) {
  Random random(static_cast<unsigned>(D));
  const InterfaceLaw law{100, 80, 0.3};
  for (int trial = 0; trial < 40; ++trial) {
    const Variables<D> q = random_variables<D>(random, foot, -0.05, reach);
    const Situation<D> situation{random_curvature<D>(random), foot, reach > 0, revolved};
    const LocalForce<D> at = evaluate<D>(law, q, situation).force;
    ASSERT_EQ(at.state, expected);
    EXPECT_GT(at.pressure, 0);
    EXPECT_LE(at.friction.norm(), law.friction * at.pressure * (1 + 1e-14));
    compare_with_differences<D>(law, q, situation, 1e-4);
  }
}

TEST(Penalty, FirstTouchHasNoFriction) {
  tangent_and_shift<2>(Foot::regular, 0, ContactState::stick);
  tangent_and_shift<3>(Foot::regular, 0, ContactState::stick);
}
TEST(Penalty, Stick) {
  tangent_and_shift<2>(Foot::regular, 0.01, ContactState::stick);
  tangent_and_shift<3>(Foot::regular, 0.01, ContactState::stick);
}
TEST(Penalty, Slip) {
  tangent_and_shift<2>(Foot::regular, 0.3, ContactState::slip);
  tangent_and_shift<3>(Foot::regular, 0.3, ContactState::slip);
}
TEST(Penalty, CornerStickAndSlip) {
  tangent_and_shift<2>(Foot::corner, 0.01, ContactState::stick);
  tangent_and_shift<2>(Foot::corner, 0.3, ContactState::slip);
  tangent_and_shift<3>(Foot::corner, 0.01, ContactState::stick);
  tangent_and_shift<3>(Foot::corner, 0.3, ContactState::slip);
}

TEST(Penalty, Axisymmetric) {
  for (Foot foot : {Foot::regular, Foot::corner}) {
    tangent_and_shift<2>(foot, 0, ContactState::stick, true);
    tangent_and_shift<2>(foot, 0.01, ContactState::stick, true);
    tangent_and_shift<2>(foot, 0.3, ContactState::slip, true);
  }
}

/// The same traction on the full circle's area 2πr ds.
TEST(Penalty, AxisymmetricAreaIsThatOfTheFullCircle) {
  Random random(5);
  const InterfaceLaw law{100, 80, 0.3};
  for (int trial = 0; trial < 20; ++trial) {
    const Variables<2> q = random_variables<2>(random, Foot::regular, -0.05, trial % 2 == 0 ? 0.01 : 0.3);
    Situation<2> situation{random_curvature<2>(random), Foot::regular, true};
    const LocalForce<2> plane = evaluate<2>(law, q, situation).force;
    situation.revolved = true;
    const LocalForce<2> ring = evaluate<2>(law, q, situation).force;
    const double circle = 2 * std::numbers::pi * q(0);
    EXPECT_EQ(ring.pressure, plane.pressure);
    EXPECT_EQ(ring.friction, plane.friction);
    EXPECT_NEAR(ring.measure, circle * plane.measure, 1e-14 * ring.measure);
    EXPECT_NEAR((ring.force - circle * plane.force).norm(), 0, 1e-14 * ring.force.norm());
  }
}

/// t_T follows the slip, so that the traction on the slave, t_N n̄ − t_T, resists it.
TEST(Penalty, FrictionOpposesTheMotion) {
  Random random(7);
  const InterfaceLaw law{100, 80, 0.3};
  const Situation<3> flat{{Vec<3>::Zero(), Vec<3>::Zero(), Vec<3>::Zero()}, Foot::regular, true};
  for (double reach : {0.01, 0.3}) {
    const Variables<3> q = random_variables<3>(random, Foot::regular, -0.05, reach);
    const auto at = evaluate<3>(law, q, flat);
    const Vec<3> traveled = q.segment<3>(LocalForce<3>::master_column) - q.segment<3>(LocalForce<3>::slip_column);
    EXPECT_NEAR(at.force.friction.normalized().dot(traveled.normalized()), 1, 1e-14);
    EXPECT_LT(at.force.force.dot(traveled), 0);
    EXPECT_NEAR(at.force.pressure, 100 * 0.05, 1e-13);
    EXPECT_NEAR(at.force.friction.norm(), std::min(80 * reach, 0.3 * at.force.pressure), 1e-13);
  }
}

// ── Points with a fixed state ────────────────────────────────────────────────────────────────────────────────────────

/// Checks state and force at a given gap, with the slip point at distance `reach`.
template <int D> void fixed(Foot foot, double gap, double reach, FixedContactState fixed_state, ContactState expected) {
  Random random(static_cast<unsigned>(D));
  const InterfaceLaw law{100, 80, 0.3};
  for (int trial = 0; trial < 20; ++trial) {
    const Variables<D> q = random_variables<D>(random, foot, gap, reach);
    const Situation<D> situation{random_curvature<D>(random), foot, reach > 0, false, 1, fixed_state};
    const Outcome<D> at = evaluate<D>(law, q, situation);
    EXPECT_EQ(at.force.state, expected);
    EXPECT_NEAR(at.force.pressure, -100 * at.gap, 1e-12);
    if (at.force.state == ContactState::slip) {
      EXPECT_NEAR(at.force.friction.norm(), 0.3 * std::abs(at.force.pressure), 1e-12);
    } else if (fixed_state == FixedContactState::touching && at.force.pressure < 0) {
      EXPECT_EQ(at.force.friction.norm(), 0); // in tension
    } else if (foot == Foot::regular) {
      EXPECT_NEAR(at.force.friction.norm(), 80 * reach, 1e-12);
    }
    compare_with_differences<D>(law, q, situation, 1e-4);
  }
}

template <int D> void points_with_fixed_state() {
  const ContactState stick = ContactState::stick;
  for (Foot foot : {Foot::regular, Foot::corner}) {
    fixed<D>(foot, 0.05, 0.01, FixedContactState::touching, stick);
    fixed<D>(foot, 0.05, 0.3, FixedContactState::touching, stick);
    for (double gap : {-0.05, 0.05}) // beyond Coulomb's cone
      fixed<D>(foot, gap, 0.3, FixedContactState::stick, stick);
  }
}

TEST(Penalty, PointsWithAFixedStateMayPullAndStick) {
  points_with_fixed_state<2>();
  points_with_fixed_state<3>();
}

TEST(Penalty, FixedTouchingPointsFollowCoulombsLaw) {
  fixed<2>(Foot::regular, -0.05, 0.01, FixedContactState::touching, ContactState::stick);
  fixed<2>(Foot::regular, -0.05, 0.3, FixedContactState::touching, ContactState::slip);
  fixed<3>(Foot::regular, -0.05, 0.01, FixedContactState::touching, ContactState::stick);
  fixed<3>(Foot::regular, -0.05, 0.3, FixedContactState::touching, ContactState::slip);
}

} // namespace penalty_test
} // namespace signorini::contact
