// Multipliers of the augmented Lagrangian method, and scaled penalty parameters.
#include "contact/couple.hpp"
#include "contact/couple3d.hpp"

namespace signorini::contact {
namespace augment_test {

using namespace test;

Couple pressed(double mu = 0.2) {
  Couple couple("N2", slab("N2"), {100, 100, mu}, 1.4, 1.0);
  couple.touch().move_die(0, -0.05).evaluate();
  return couple;
}

std::vector<double> pressures(const Pair<2>& pair) {
  std::vector<double> result;
  for (const auto& point : pair.results()) result.push_back(point.pressure);
  return result;
}

/// Each value is `factor` times the other, up to rounding error.
void expect_times(const std::vector<double>& values, double factor, const std::vector<double>& others) {
  ASSERT_EQ(values.size(), others.size());
  for (std::size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(values[i], factor * others[i], 1e-13 * factor * 5) << i;
}

TEST(Augment, PressuresOfTheLastEvaluationBecomeMultipliers) {
  Couple couple = pressed();
  const std::vector<double> plain = pressures(couple.pair);
  ASSERT_GT(*std::max_element(plain.begin(), plain.end()), 4);
  ASSERT_EQ(*std::min_element(plain.begin(), plain.end()), 0); // some are open
  for (int loop = 2; loop <= 4; ++loop) {
    couple.pair.augment();
    couple.evaluate();
    expect_times(pressures(couple.pair), loop, plain); // λ + ε |g|, λ the last one
  }
}

TEST(Augment, RollBackRestoresAcceptedMultipliersAndHistoryContainsThem) {
  Couple couple = pressed();
  const std::vector<double> plain = pressures(couple.pair);
  couple.pair.accept();
  const auto early = couple.pair.history();
  couple.pair.augment();
  couple.evaluate();
  couple.pair.rollback();
  couple.evaluate();
  expect_times(pressures(couple.pair), 1, plain);

  couple.pair.augment();
  couple.evaluate().accept();
  const auto late = couple.pair.history();
  couple.pair.augment();
  couple.evaluate();
  expect_times(pressures(couple.pair), 3, plain);
  couple.pair.rollback();
  couple.evaluate();
  expect_times(pressures(couple.pair), 2, plain);

  couple.pair.restore(early);
  couple.evaluate();
  expect_times(pressures(couple.pair), 1, plain);
  couple.pair.restore(late);
  couple.evaluate();
  expect_times(pressures(couple.pair), 2, plain);
}

/// The lower side of a strip from x = 0 to 3, flat on a plane: every point has the same gap.
struct Flat {
  Couple couple{discretize(nurbs::rectangle(3, 0.5, Eigen::Vector2d(0, 0)), {6, 1}, "N2", "south"), "south",
                make_plane<2>({0, 0}, {0, 1}), PenaltyLaw{100}, 3};

  /// The pressure at a gap, the same at all points.
  double at(double gap) {
    for (int i = 1; i < couple.die_dofs(); i += 2) couple.u(i) = gap;
    couple.evaluate();
    const std::vector<double> all = pressures(couple.pair);
    EXPECT_NEAR(*std::min_element(all.begin(), all.end()), *std::max_element(all.begin(), all.end()), 1e-12);
    return all.front();
  }
};

TEST(Augment, IsClosedUpToAGapOfMultiplierOverPenalty) {
  Flat flat;
  EXPECT_NEAR(flat.at(-0.01), 1, 1e-13);
  flat.couple.pair.augment();
  EXPECT_NEAR(flat.at(0.005), 0.5, 1e-13);
  EXPECT_NEAR(flat.at(0.0099), 0.01, 1e-12);
  EXPECT_EQ(flat.at(0.0101), 0);
  EXPECT_EQ(flat.couple.pair.resultant().active, 0);
  // After large motions away and back skipped points must be projected in time.
  Random random(3);
  for (int round = 0; round < 50; ++round) {
    const double gap = uniform(random, -0.01, round % 5 == 0 ? 0.2 : 0.03);
    EXPECT_NEAR(flat.at(gap), std::max(0.0, 1 - 100 * gap), 1e-12) << gap;
  }
  // Open points lose their multipliers.
  flat.at(0.02);
  flat.couple.pair.augment();
  EXPECT_EQ(flat.at(0.005), 0);
  EXPECT_NEAR(flat.at(-0.005), 0.5, 1e-13);
}

TEST(Augment, TangentIsTheForcesDerivative) {
  Random random(21);
  Census census;
  for (int trial = 0; trial < 8; ++trial) {
    Couple couple("N2", trial % 2 == 0 ? slab("N2") : wavy(random, 3, 0.15, 3, 6), {100, 100, 0.3}, 1.3,
                  trial % 2 == 0 ? 1.0 : 0.1);
    couple.shake(random, 0.005).touch().move_die(0, -0.04).evaluate();
    couple.pair.augment();
    couple.pair.accept();
    for (const auto& [x, y] : {std::pair{2e-4, 0.0}, {0.03, 0.02}, {0.0, 0.03}}) {
      couple.move_die(x, y).shake(random, 0.0005);
      compare_with_differences(couple, census);
    }
    EXPECT_GT(couple.pair.resultant().active, 3); // although lifted by more than the penetration
  }
  census.expect({.states = 15, .stick = 30, .slip = 30});
}

TEST(Augment, TangentIsTheForcesDerivativeIn3D) {
  Random random(22);
  Census census;
  const auto plate = wavy_plate(random, 2, 0.1, 2, 3);
  Couple3 couple("N2", plate, PenaltyLaw{100, 100, 0.3}, {1, 1, 0.2}, 3);
  couple.touch().move_die({0, 0, -0.03}).evaluate();
  couple.pair.augment();
  couple.pair.accept();
  for (const Vec<3>& by : {Vec<3>(1e-4, 1e-4, 0), Vec<3>(0.02, -0.01, 0.02), Vec<3>(0, 0, 0.02)}) {
    couple.move_die(by);
    compare_with_differences(couple, random, census);
  }
  EXPECT_GT(couple.pair.resultant().active, 2); // although lifted by more than the penetration
  EXPECT_GE(census.states, 2) << census.stepped_over << " states lay on a change of state";
  EXPECT_GT(census.slip, 0);
}

// ── Scaled penalties ─────────────────────────────────────────────────────────────────────────────────────────────────

TEST(ScalePenalty, ForcesFollowAndFrictionToo) {
  Couple couple = pressed();
  couple.accept().move_die(2e-3, 0).evaluate();
  const Dense plain = couple.dense();
  const auto before = couple.pair.results();
  int sticking = 0, slipping = 0;
  for (double factor : {2.0, 1e-3}) {
    couple.pair.scale_penalty(factor);
    couple.evaluate();
    EXPECT_LT((couple.dense().force - factor * plain.force).norm(), 1e-13 * factor * plain.force.norm());
    EXPECT_LT((couple.dense().tangent - factor * plain.tangent).norm(), 1e-13 * factor * plain.tangent.norm());
    for (std::size_t i = 0; i < before.size(); ++i) {
      const PointResult<2>& now = couple.pair.results()[i];
      EXPECT_EQ(now.state, before[i].state);
      EXPECT_NEAR((now.friction - factor * before[i].friction).norm(), 0, 1e-13 * factor);
      sticking += now.state == ContactState::stick;
      slipping += now.state == ContactState::slip;
    }
  }
  EXPECT_GT(sticking, 3);
  EXPECT_GT(slipping, 1);
  // Factors multiply the given penalty, not the previous factor.
  couple.pair.scale_penalty(1);
  couple.evaluate();
  EXPECT_LT((couple.dense().force - plain.force).norm(), 1e-13 * plain.force.norm());
}

/// With λ = 1 a point with a gap of 0.05 is open if ε = 100, closed if ε = 10.
TEST(ScalePenalty, ASofterPenaltyClosesLargerGaps) {
  Flat flat;
  flat.at(-0.01);
  flat.couple.pair.augment();
  EXPECT_EQ(flat.at(0.05), 0);
  flat.couple.pair.scale_penalty(0.1);
  EXPECT_NEAR(flat.at(0.05), 0.5, 1e-13);
  flat.couple.pair.accept();
  EXPECT_NEAR(flat.at(0.09), 0.1, 1e-13);
  EXPECT_EQ(flat.at(0.12), 0);
  flat.couple.pair.scale_penalty(0.05);
  flat.couple.pair.rollback();
  EXPECT_NEAR(flat.at(0.12), 0.4, 1e-13);
}

TEST(ScalePenalty, DoesNotAffectAdhesion) {
  Couple couple("N2", slab("N2"), Adhesion{0.02, 0.05}, 1.4, 1.02);
  couple.evaluate();
  const VectorX before = couple.dense().force;
  couple.pair.scale_penalty(7);
  couple.pair.augment();
  couple.evaluate();
  EXPECT_LT((couple.dense().force - before).norm(), 1e-13 * before.norm());
}

} // namespace augment_test
} // namespace signorini::contact
