// Scaled penalty parameters.
#include "contact/couple.hpp"
#include "contact/couple3d.hpp"

namespace signorini::contact {
namespace scale_penalty_test {

using namespace test;

Couple pressed(double mu = 0.2) {
  Couple couple("N2", slab("N2"), {100, 100, mu}, 1.4, 1.0);
  couple.touch().move_die(0, -0.05).evaluate();
  return couple;
}

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

TEST(ScalePenalty, DoesNotAffectAdhesion) {
  Couple couple("N2", slab("N2"), adhesive({0.02, 0.05}), 1.4, 1.02);
  couple.evaluate();
  const VectorX before = couple.dense().force;
  couple.pair.scale_penalty(7);
  couple.evaluate();
  EXPECT_LT((couple.dense().force - before).norm(), 1e-13 * before.norm());
}

} // namespace scale_penalty_test
} // namespace signorini::contact
