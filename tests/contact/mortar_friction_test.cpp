// Mortar contact with friction, in 2D and 3D: tangent against finite differences in every state,
// Coulomb's law, history, objectivity, dissipation.
#include "contact/couple3d.hpp"
#include "contact/mortar_discs.hpp"

#include <cmath>

namespace signorini::contact {
namespace mortar_friction_test {

using namespace test;

TEST(MortarFriction, TangentIsTheForcesDerivativeInEveryState) {
  Census sum;
  unsigned seed = 100;
  Random random(9);
  for (const MultiplierSpace space : multiplier_spaces) {
    // Small drags stick, longer ones slip; after one longer than an element former foot points lie in other elements.
    sum.add(
        press_and_drag(pressed_disc("N2", slab("N2"), mortar(space, 0.3), 0.8, 1.0), ++seed, 0.06, {3e-4, 0.02, 0.5}));
    for (int trial = 0; trial < 3; ++trial)
      sum.add(press_and_drag(pressed_disc("N2-N2.1", wavy(random, 3, 0.1, 3, 6), mortar(space, 0.3), 1.3, 0.1), ++seed,
                             0.07, {1e-3, 0.1, -0.4}));
    sum.add(press_and_drag(pressed_disc("N2", make_ball<2>({1, -2}, 2), mortar(space, 0.3), 1.3, 0.1), ++seed, 0.06,
                           {3e-4, -0.1}));
    sum.add(press_and_drag(pressed_disc("N3", make_plane<2>({0, 0}, {0.2, 2}), mortar(space, 0.3), 1.3, 0.1, true),
                           ++seed, 0.06, {3e-4, 0.1}));
  }
  sum.expect({.states = 25, .stick = 100, .slip = 100});
}

TEST(MortarFriction, TangentIsTheForcesDerivativeIn3D) {
  Random random(1);
  Census census;
  for (const MultiplierSpace space : multiplier_spaces)
    for (double mu : {0.0, 0.3})
      for (int kind = 0; kind < 3; ++kind) {
        Couple3 couple =
            kind < 2 ? Couple3("N2", wavy_plate(random, 3, 0.02, 2 + kind, 4), mortar(space, mu), {1.4, 1.5, 0.1}, 5)
                     : Couple3("N2", Obstacle<3>(make_ball<3>({1.5, 1.5, -2}, 2)), mortar(space, mu), {1.5, 1.5, 0.1});
        couple.shake(random, 0.003).touch().move_die({0, 0, -0.08}).shake(random, 0.001);
        compare_with_differences(couple, random, census);
        couple.pair.accept();
        drag_and_compare(couple, random, {{3e-4, 1e-4, 0}, {0.02, 0.03, 0}, {-0.3, 0.2, 0}}, census);
        couple.turn_die(0.1, {1.5, 1.5, 0});
        compare_with_differences(couple, random, census);
        couple.move_die({1e-3, 0, 0.01});
        compare_with_differences(couple, random, census);
      }
  census.expect({.states = 50, .stick = 200, .slip = 200});
}

TEST(MortarFriction, IsCoulombsAndOpposesTheSliding) {
  for (const MultiplierSpace space : multiplier_spaces)
    for (double direction : {1.0, -1.0}) {
      Couple couple = pressed_disc("N2", slab("N2"), mortar(space, 0.2), 1.4, 1.0);
      couple.touch().move_die(0, -0.05).evaluate().accept();
      double dissipated = 0;
      for (int step = 0; step < 12; ++step) {
        couple.move_die(0.01 * direction, 0).evaluate();
        for (const auto& multiplier : couple.pair.multipliers()) {
          EXPECT_LE(multiplier.friction.norm(), 0.2 * multiplier.pressure * (1 + 1e-14));
          if (multiplier.state != ContactState::slip) continue;
          EXPECT_NEAR(multiplier.friction.norm(), 0.2 * multiplier.pressure, 1e-13 * multiplier.pressure);
          EXPECT_GT(multiplier.friction(0) * direction, 0);
        }
        const Eigen::Vector2d force = couple.pair.resultant().force;
        couple.pair.accept();
        if (step < 6) continue;
        EXPECT_EQ(count(couple.pair, ContactState::stick), 0);
        EXPECT_NEAR(force(0), -0.2 * direction * force(1), 1e-12 * force(1));
        // In full slip friction dissipates force times way.
        if (step > 6) {
          EXPECT_NEAR(couple.pair.dissipated() - dissipated, 0.2 * force(1) * 0.01, 1e-12 * force(1));
        }
        dissipated = couple.pair.dissipated();
        // The accepted state has the same forces.
        couple.evaluate();
        EXPECT_NEAR((couple.pair.resultant().force - force).norm(), 0, 1e-12 * force.norm());
      }
    }
}

/// Bodies that turn together keep their tractions, which turn with them.
template <int D, class AnyCouple> void expect_turned(AnyCouple& couple, const Mat<D>& turn) {
  const VectorX before = couple.dense().force;
  const MatrixX die = couple.die.points(), base = couple.base->points();
  for (int i = 0; i < couple.u.size(); i += D) {
    const Vec<D> x = i < couple.die_dofs() ? die.col(i / D) : base.col((i - couple.die_dofs()) / D);
    couple.u.template segment<D>(i) = turn * (x + couple.u.template segment<D>(i)) - x;
  }
  couple.evaluate();
  const VectorX after = couple.dense().force;
  double difference = 0;
  for (int i = 0; i < before.size(); i += D)
    difference = std::max(difference, (after.segment<D>(i) - turn * before.segment<D>(i)).norm());
  EXPECT_LE(difference, 1e-12 * before.norm());
}

TEST(MortarFriction, IsIndependentOfTheFrame) {
  for (const MultiplierSpace space : multiplier_spaces) {
    Couple couple = pressed_disc("N2", slab("N2"), mortar(space, 0.3), 1.4, 1.0);
    couple.touch().move_die(3e-3, -0.05).evaluate().accept().evaluate();
    EXPECT_GT(std::abs(couple.pair.resultant().force(0)), 1e-2);
    expect_turned<2>(couple, Eigen::Rotation2Dd(0.7).toRotationMatrix());

    Random random(2);
    Couple3 solid("N2", wavy_plate(random, 3, 0.02, 2, 4), mortar(space, 0.3), {1.4, 1.5, 0.1}, 5);
    solid.touch().move_die({3e-3, -2e-3, -0.08}).evaluate().accept().evaluate();
    EXPECT_GT(solid.pair.resultant().force.head<2>().norm(), 1e-2);
    expect_turned<3>(solid, Eigen::AngleAxisd(0.7, Vec<3>(1, 2, -1).normalized()).toRotationMatrix());
  }
}

TEST(MortarFriction, FixedStatesBelongToMultipliers) {
  for (const MultiplierSpace space : multiplier_spaces) {
    Couple couple = pressed_disc("N2", slab("N2"), mortar(space, 0.2), 1.4, 1.0);
    couple.touch().move_die(0.02, -0.06).evaluate();
    const std::size_t size = couple.pair.multipliers().size();
    const int closed = count(couple.pair, ContactState::slip) + count(couple.pair, ContactState::stick);
    ASSERT_GT(count(couple.pair, ContactState::slip), 1);
    const VectorX before = couple.dense().force;

    couple.pair.fix_states(std::vector<FixedContactState>(size, FixedContactState::open));
    couple.evaluate();
    EXPECT_TRUE(couple.pair.blocks().empty());

    std::vector<FixedContactState> some(size, FixedContactState::free);
    some[size / 2] = FixedContactState::stick;
    some[size / 2 - 3] = FixedContactState::touching; // at a gap, so that it is in tension, without friction
    couple.pair.fix_states(some);
    couple.evaluate();
    EXPECT_EQ(couple.pair.multipliers()[size / 2].state, ContactState::stick);
    EXPECT_GT(couple.pair.multipliers()[size / 2].friction.norm(), 0.2 * couple.pair.multipliers()[size / 2].pressure);
    EXPECT_LT(couple.pair.multipliers()[size / 2 - 3].pressure, 0);
    EXPECT_EQ(couple.pair.multipliers()[size / 2 - 3].friction.norm(), 0);
    Census census;
    compare_with_differences(couple, census);
    EXPECT_EQ(census.states, 1);

    couple.pair.fix_states({});
    couple.evaluate();
    EXPECT_EQ(count(couple.pair, ContactState::slip) + count(couple.pair, ContactState::stick), closed);
    EXPECT_LT((couple.dense().force - before).norm(), 1e-13 * before.norm());
  }
}

TEST(MortarFriction, StartsAtTheAcceptedPosition) {
  Couple couple = pressed_disc("N2", slab("N2"), mortar(MultiplierSpace::reduced, 0.5), 1.3, 0.95);
  couple.evaluate();
  for (const auto& multiplier : couple.pair.multipliers()) EXPECT_NEAR(multiplier.friction.norm(), 0, 1e-13);
  couple.accept().move_die(1e-3, 0).evaluate();
  // On a straight master the slip of all points is that of the die.
  EXPECT_GT(count(couple.pair, ContactState::stick), 2);
  for (const auto& multiplier : couple.pair.multipliers())
    if (multiplier.state == ContactState::stick) {
      EXPECT_NEAR(multiplier.friction(0), 80 * 1e-3, 1e-12);
    }
}

} // namespace mortar_friction_test
} // namespace signorini::contact
