// A contact with points fixed to states.
#include "contact/couple.hpp"
#include "contact/couple3d.hpp"

namespace signorini::contact {
namespace fixed_state_test {

using namespace test;

std::vector<FixedContactState> all(const Pair<2>& pair, FixedContactState state) {
  return std::vector<FixedContactState>(pair.results().size(), state);
}

/// A die pressed into a slab by 0.05.
Couple pressed(double mu = 0.2) {
  Couple couple("N2", slab("N2"), {100, 100, mu}, 1.4, 1.0);
  couple.touch().move_die(0, -0.05).evaluate();
  return couple;
}

TEST(FixedContactState, OpenPointsStayOpenWhenTheyPenetrate) {
  Couple couple = pressed();
  const VectorX before = couple.dense().force;
  ASSERT_GT(couple.pair.resultant().active, 5);
  couple.pair.fix_states(all(couple.pair, FixedContactState::open));
  EXPECT_TRUE(couple.pair.holds());
  couple.evaluate();
  EXPECT_EQ(couple.pair.resultant().active, 0);
  EXPECT_TRUE(couple.pair.blocks().empty());
  couple.pair.fix_states({});
  EXPECT_FALSE(couple.pair.holds());
  couple.evaluate();
  EXPECT_LT((couple.dense().force - before).norm(), 1e-13 * before.norm());
}

TEST(FixedContactState, TouchingPointsAreInTensionAtAGap) {
  for (double mu : {0.0, 0.2}) {
    Couple couple = pressed(mu);
    couple.accept().move_die(0.01, 0.06).evaluate();
    ASSERT_EQ(couple.pair.resultant().active, 0);
    couple.pair.fix_states(all(couple.pair, FixedContactState::touching));
    couple.evaluate();
    const std::vector<double> gaps = couple.pair.gaps();
    int pulling = 0;
    for (std::size_t i = 0; i < gaps.size(); ++i) {
      const PointResult<2>& point = couple.pair.results()[i];
      if (point.beyond) continue;
      ++pulling;
      EXPECT_EQ(point.state, ContactState::stick);
      EXPECT_EQ(point.friction.norm(), 0);
      EXPECT_NEAR(point.pressure, -100 * gaps[i], 1e-12);
      EXPECT_LT(point.pressure, 0);
    }
    EXPECT_EQ(pulling, static_cast<int>(gaps.size()));
    EXPECT_LT(couple.pair.resultant().force(1), 0);
    EXPECT_EQ(couple.pair.resultant().max_penetration, 0);
    couple.pair.fix_states({});
    couple.evaluate();
    EXPECT_EQ(couple.pair.resultant().active, 0);
  }
}

TEST(FixedContactState, StickingPointsIgnoreCoulombsLimit) {
  Couple couple = pressed();
  couple.pair.accept();
  for (double drag : {1e-3, 0.2}) {
    Couple dragged = couple;
    dragged.move_die(drag, 0);
    dragged.pair.fix_states(all(dragged.pair, FixedContactState::stick));
    dragged.evaluate();
    int deep = 0;
    for (const auto& point : dragged.pair.results()) {
      if (point.pressure <= 0) continue;
      ++deep;
      EXPECT_EQ(point.state, ContactState::stick);
      EXPECT_NEAR(point.friction.norm(), 100 * drag, 1e-12);
    }
    EXPECT_GT(deep, 5);
  }
}

TEST(FixedContactState, TouchingPointsStickWhileABodyComesIntoContact) {
  Couple couple = pressed();
  couple.accept().move_die(0.2, 0).evaluate();
  ASSERT_GT(couple.pair.resultant().slipping, 5);
  const int active = couple.pair.resultant().active;
  couple.pair.land(true);
  couple.evaluate();
  EXPECT_EQ(couple.pair.resultant().slipping, 0);
  EXPECT_EQ(couple.pair.resultant().active, active);
  couple.pair.land(false);
  couple.evaluate();
  EXPECT_GT(couple.pair.resultant().slipping, 5);
}

/// After a step that slipped, all its points lie on Coulomb's cone up to rounding error.
TEST(FixedContactState, TheFirstGuessSlipsOnAStraightPathAndSticksAtATurningPoint) {
  Couple couple = pressed();
  couple.accept().move_die(0.1, 0).evaluate().accept();
  const int slipping = couple.pair.resultant().slipping;
  ASSERT_GT(slipping, 5);
  for (const double shift : {-1e-14, 0.0, 1e-14}) {
    Couple here = couple;
    here.move_die(shift, 0);
    here.pair.guess(1e-12, true);
    here.evaluate();
    EXPECT_EQ(here.pair.resultant().slipping, slipping) << shift;
    here.pair.guess(1e-12, false);
    here.evaluate();
    EXPECT_EQ(here.pair.resultant().slipping, 0) << shift;
  }
  // Points farther from the cone than the contact tolerance follow Coulomb's law.
  couple.pair.guess(1e-12, false);
  couple.move_die(1e-9, 0).evaluate();
  EXPECT_EQ(couple.pair.resultant().slipping, slipping);
  couple.pair.guess(1e-12, true);
  couple.move_die(-2e-9, 0).evaluate();
  EXPECT_EQ(couple.pair.resultant().slipping, 0);
}

TEST(FixedContactState, TangentIsTheForcesDerivativeInEveryMixture) {
  Random random(11);
  Census census;
  for (int trial = 0; trial < 12; ++trial) {
    Couple couple("N2-N2.1", trial % 2 == 0 ? slab("N2") : wavy(random, 3, 0.15, 3, 6), {100, 100, 0.3}, 1.3,
                  trial % 2 == 0 ? 1.0 : 0.1);
    couple.shake(random, 0.005).touch().move_die(0, -0.05).evaluate().accept().move_die(0.03, 0).shake(random, 0.0005);
    std::vector<FixedContactState> states;
    for (std::size_t i = 0; i < couple.pair.results().size(); ++i)
      states.push_back(static_cast<FixedContactState>(integer(random, 0, 3)));
    couple.pair.fix_states(states);
    compare_with_differences(couple, census);
  }
  census.expect({.states = 8, .stick = 50, .slip = 20});
}

TEST(FixedContactState, TangentIsTheForcesDerivativeIn3D) {
  Random random(12);
  Census census;
  const auto plate = wavy_plate(random, 2, 0.1, 2, 3);
  for (FixedContactState state : {FixedContactState::touching, FixedContactState::stick}) {
    Couple3 couple("N2", plate, InterfaceLaw{100, 100, 0.3}, {1, 1, 0.2}, 3);
    couple.touch().move_die({0, 0, -0.03}).evaluate().accept().move_die({0.02, -0.01, 0.01});
    couple.pair.fix_states(std::vector<FixedContactState>(couple.pair.results().size(), state));
    compare_with_differences(couple, random, census);
    bool pulls = false;
    for (const auto& point : couple.pair.results()) pulls = pulls || point.pressure < 0;
    EXPECT_TRUE(pulls);
  }
  census.expect({.states = 2});
}

TEST(FixedContactState, AdhesionIgnoresIt) {
  Couple couple("N2", slab("N2"), adhesive({0.02, 0.05}), 1.4, 1.02);
  couple.evaluate();
  const VectorX before = couple.dense().force;
  ASSERT_GT(before.norm(), 0);
  couple.pair.fix_states(all(couple.pair, FixedContactState::open));
  couple.evaluate();
  EXPECT_LT((couple.dense().force - before).norm(), 1e-13 * before.norm());
}

} // namespace fixed_state_test
} // namespace signorini::contact
