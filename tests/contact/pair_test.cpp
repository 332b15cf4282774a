// An assembled contact: force and tangent against finite differences in every state, balance of forces and moments,
// Coulomb's law, history, and skipping of far points.
#include "contact/couple.hpp"

#include <cmath>

namespace signorini::contact {
namespace pair_test {

using namespace test;

TEST(Pair, TangentIsTheForcesDerivativeInEveryState) {
  Census sum;
  unsigned seed = 0;
  for (const char* label : {"N2", "N4", "N2-N2.2", "L1"}) {
    // Small drags stick, longer ones slip; after one longer than an element the slip point lies in another element.
    if (std::string(label) != "L1")
      sum.add(press_and_drag(Couple(label, slab(label), {100, 100, 0.2}, 0.8, 1.0), ++seed, 0.06, {3e-4, 0.02, 0.5}));
    sum.add(press_and_drag(Couple("N2", slab(label), {100, 50, 0.4}, 1.6, 1.0), ++seed, 0.04, {-2e-4, -0.05, -0.45}));
  }
  Random random(9);
  for (int trial = 0; trial < 6; ++trial)
    sum.add(press_and_drag(Couple("N2-N2.1", wavy(random, 3, 0.15, 3, 6), {100, 100, 0.3}, 1.3, 0.1), ++seed, 0.06,
                           {1e-3, 0.1, 0.4}));
  sum.expect({.states = 30, .open = 500, .stick = 100, .slip = 100, .elsewhere = 10});
}

TEST(Pair, TangentIsTheForcesDerivativeAtACorner) {
  // A valley whose vertex is the foot point of penetrating points
  const auto valley = polyline({{0, 1.6}, {1.5, 1}, {3, 1.6}});
  for (double drag : {2e-4, 0.02}) {
    Couple couple("N2", valley, {100, 100, 0.2}, 1.5, 1.0);
    Random random(3);
    couple.shake(random, 0.001).evaluate().accept().move_die(0, -0.1).evaluate();
    int corners = 0;
    for (const auto& point : couple.pair.results()) {
      const Eigen::Vector2d down = point.position - couple.pair.master().surface()->points().col(1);
      corners += point.state != ContactState::open && std::abs(std::abs(point.gap) - down.norm()) < 1e-14;
    }
    EXPECT_GE(corners, 2);
    couple.accept().move_die(drag, 0);
    Census census;
    compare_with_differences(couple, census);
    EXPECT_EQ(census.states, 1);
  }
}

TEST(Pair, ForcesBalanceAndWithoutFrictionMomentsToo) {
  Random random(4);
  for (double mu : {0.0, 0.3})
    for (int trial = 0; trial < 10; ++trial) {
      Couple couple("N2-N4", wavy(random, 3, 0.15, 3, 6), {100, 100, mu}, 1.3, 0.1);
      couple.touch().move_die(0.02, -0.06).shake(random, 0.01);
      expect_balanced(couple, mu);
    }
}

TEST(Pair, FrictionIsCoulombsAndOpposesTheSliding) {
  for (double direction : {1.0, -1.0}) {
    Couple couple("N2", slab("N2"), {100, 100, 0.2}, 1.4, 1.0);
    couple.touch().move_die(0, -0.05).evaluate().accept();
    for (int step = 0; step < 20; ++step) {
      couple.move_die(0.01 * direction, 0).evaluate();
      int slipping = 0;
      for (const auto& point : couple.pair.results()) {
        EXPECT_LE(point.friction.norm(), 0.2 * point.pressure * (1 + 1e-14));
        if (point.state != ContactState::slip) continue;
        ++slipping;
        EXPECT_NEAR(point.friction.norm(), 0.2 * point.pressure, 1e-13 * point.pressure);
        EXPECT_GT(point.friction(0) * direction, 0);
      }
      const Resultant<2> resultant = couple.pair.resultant();
      EXPECT_EQ(resultant.slipping, slipping);
      EXPECT_LT(resultant.force(0) * direction, 0);
      EXPECT_GT(resultant.force(1), 0);
      if (step > 5) {
        EXPECT_NEAR(std::abs(resultant.force(0)), 0.2 * resultant.force(1), 1e-12 * resultant.force(1));
      }
      EXPECT_NEAR(resultant.max_penetration, 0.05, 1e-3);
      EXPECT_NEAR(resultant.max_pressure, 100 * resultant.max_penetration, 1e-12);
      couple.pair.accept();
    }
  }
}

bool same(const std::vector<Block>& a, const std::vector<Block>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Block& s, const Block& t) {
    return s.slave_element == t.slave_element && s.master_element == t.master_element &&
           s.slip_element == t.slip_element && s.force == t.force && s.matrix == t.matrix;
  });
}

TEST(Pair, RollbackRestoresBitwise) {
  Random random(5);
  for (int trial = 0; trial < 10; ++trial) {
    Couple couple("N2-N2.1", trial % 2 == 0 ? slab("N2") : wavy(random, 3, 0.15, 3, 6), {100, 100, 0.2}, 1.3,
                  trial % 2 == 0 ? 1.0 : 0.1);
    couple.touch().move_die(0, -0.1).evaluate().accept().move_die(0.03, 0).shake(random, 0.002).evaluate();
    const std::vector<Block> blocks = couple.pair.blocks();
    ASSERT_FALSE(blocks.empty());
    for (int wild = 0; wild < 5; ++wild) {
      VectorX elsewhere = couple.u;
      for (int i = 0; i < elsewhere.size(); ++i) elsewhere(i) += uniform(random, -0.2, 0.2);
      couple.evaluate(elsewhere);
    }
    couple.pair.rollback();
    couple.evaluate();
    EXPECT_TRUE(same(blocks, couple.pair.blocks()));
  }
}

/// The traction is on the cone before and after accepting: on a straight master it is the same, on a curved one it has
/// the same magnitude (the chord to the slip point rotates as that follows the curve).
TEST(Pair, AcceptedSlipKeepsTheTraction) {
  Random random(6);
  for (bool straight : {true, false}) {
    Couple couple("N2", straight ? slab("N2") : wavy(random, 3, 0.1, 3, 3), {100, 100, 0.2}, 1.3, straight ? 1.0 : 0.0);
    couple.touch().move_die(0, -0.05).evaluate().accept().move_die(0.1, 0).evaluate();
    const auto before = couple.pair.results();
    couple.accept().evaluate();
    const auto after = couple.pair.results();
    int slipped = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
      EXPECT_EQ(before[i].state == ContactState::open, after[i].state == ContactState::open);
      if (before[i].state != ContactState::slip) continue;
      ++slipped;
      EXPECT_NEAR(after[i].friction.norm(), before[i].friction.norm(), 1e-12 * before[i].pressure);
      if (straight) {
        EXPECT_NEAR((after[i].friction - before[i].friction).norm(), 0, 1e-12 * before[i].pressure);
      }
    }
    EXPECT_GT(slipped, 3);
  }
}

TEST(Pair, FrictionStartsAtTheAcceptedFirstContact) {
  Couple couple("N2", slab("N2"), {100, 100, 0.2}, 1.3, 0.95);
  couple.evaluate();
  // Rounding error of positions times the penalty parameter
  for (const auto& point : couple.pair.results()) EXPECT_NEAR(point.friction.norm(), 0, 1e-13);
  couple.accept().move_die(1e-3, 0).evaluate();
  int sticking = 0;
  for (const auto& point : couple.pair.results())
    if (point.state == ContactState::stick) {
      ++sticking;
      EXPECT_NEAR(point.friction(0), 100 * 1e-3, 1e-12);
    }
  EXPECT_GT(sticking, 3);
}

TEST(Pair, SkippingFarPointsMissesNoContact) {
  Random random(8);
  for (double mu : {0.0, 0.2})
    for (int trial = 0; trial < 4; ++trial) {
      const auto master = trial % 2 == 0 ? slab("N2") : wavy(random, 3, 0.15, 3, 6);
      Couple couple("N2", master, {100, 100, mu}, 1.3, trial % 2 == 0 ? 1.02 : 0.2);
      couple.touch().move_die(0, 0.02);
      int touched = 0;
      for (int jump = 0; jump < 60; ++jump) {
        VectorX u = couple.u;
        couple.move_die(uniform(random, -0.6, 0.6), uniform(random, -0.25, 0.3)).shake(random, 0.03).evaluate();
        Couple fresh("N2", master, {100, 100, mu}, 1.3, trial % 2 == 0 ? 1.02 : 0.2);
        fresh.evaluate(couple.u);
        for (std::size_t i = 0; i < fresh.pair.results().size(); ++i)
          EXPECT_NEAR(couple.pair.results()[i].pressure, fresh.pair.results()[i].pressure, 1e-9)
              << "jump " << jump << " point " << i;
        touched += fresh.pair.resultant().active > 0;
        if (jump % 3 == 0) couple.pair.accept();
        if (jump % 3 == 1) couple.pair.rollback();
        couple.u = u;
      }
      EXPECT_GT(touched, 10);
      EXPECT_LT(touched, 60);
    }
}

TEST(Pair, GapsIncludeOpenPoints) {
  Couple couple("N2", slab("N2"), {100, 100, 0.2}, 1.3, 1.1);
  couple.evaluate();
  const std::vector<double> gaps = couple.pair.gaps();
  ASSERT_EQ(gaps.size(), couple.pair.results().size());
  for (std::size_t i = 0; i < gaps.size(); ++i) EXPECT_NEAR(gaps[i], couple.pair.results()[i].position(1) - 1, 1e-14);
}

TEST(Pair, ErrorsNameTheArgument) {
  const auto build = [](InterfaceLaw law) { Couple("N2", slab("N2"), law, 1, 1); };
  EXPECT_ERROR(build({0, 100, 0.2}), "contact.penalty.normal: value = 0");
  EXPECT_ERROR(build({-1, 100, 0.2}), "contact.penalty.normal: value = -1");
  EXPECT_ERROR(build({100, 100, -0.1}), "contact.penalty.friction: value = -0.1");
  EXPECT_ERROR(build({100, 0, 0.2}), "contact.penalty.tangential: value = 0");
}

} // namespace pair_test
} // namespace signorini::contact
