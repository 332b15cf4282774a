// Mortar contact with Lagrange multipliers as unknowns: tangent against finite differences in every state, symmetry,
// conditions of contact and friction at a solution.
#include "contact/couple3d.hpp"
#include "contact/mortar_discs.hpp"

#include <cmath>

namespace signorini::contact {
namespace multiplier_contact_test {

using namespace test;

TEST(MultiplierContact, TangentIsTheResidualsDerivativeInEveryState) {
  Census sum;
  unsigned seed = 0;
  Random random(9);
  for (const MultiplierSpace space : multiplier_spaces)
    for (double mu : {0.0, 0.3}) {
      const Method law = multipliers(space, mu);
      sum.add(press_and_slide(pressed_disc("N2", slab("N2"), law, 0.8, 1.0), ++seed, 0.06, mu, {3e-4, 0.02, 0.5}));
      sum.add(press_and_slide(pressed_disc("N2-N2.1", wavy(random, 3, 0.1, 3, 6), law, 1.3, 0.1), ++seed, 0.07, mu,
                              {1e-3, 0.1, -0.4}));
      sum.add(
          press_and_slide(pressed_disc("N2", make_ball<2>({1, -2}, 2), law, 1.3, 0.1), ++seed, 0.06, mu, {3e-4, -0.1}));
      sum.add(press_and_slide(pressed_disc("N3", make_plane<2>({0, 0}, {0.2, 2}), law, 1.3, 0.1, true), ++seed, 0.06,
                              mu, {3e-4, 0.1}));
    }
  sum.expect({.states = 30, .open = 500, .stick = 300, .slip = 300});
}

/// The slave is wider than the master, so that its outer points have no projection or a faded area.
TEST(MultiplierContact, TangentIsTheResidualsDerivativeAtTheEndsOfTheMaster) {
  Random random(5);
  Census census;
  for (const MultiplierSpace space : multiplier_spaces)
    for (double mu : {0.0, 0.3})
      for (int trial = 0; trial < 3; ++trial) {
        Couple couple = block_beyond_ends(random, multipliers(space, mu));
        couple.move_die(0.004, -0.03);
        set_multipliers(couple, random, mu > 0 ? 2 : 1, mu);
        compare_with_differences(couple, census);
        EXPECT_GT(beyond(couple.pair), 2);
      }
  census.expect({.states = 8});
}

TEST(MultiplierContact, TangentIsTheResidualsDerivativeIn3D) {
  Random random(1);
  Census census;
  for (const MultiplierSpace space : multiplier_spaces)
    for (double mu : {0.0, 0.3})
      for (int kind = 0; kind < 3; ++kind) {
        const Method law = multipliers(space, mu);
        const int each = mu > 0 ? 3 : 1;
        Couple3 couple = kind < 2 ? Couple3("N2", wavy_plate(random, 3, 0.02, 2 + kind, 4), law, {1.4, 1.5, 0.1}, 5)
                                  : Couple3("N2", Obstacle<3>(make_ball<3>({1.5, 1.5, -2}, 2)), law, {1.5, 1.5, 0.1});
        couple.shake(random, 0.003).touch().move_die({0, 0, -0.08});
        set_multipliers(couple, random, each, mu);
        compare_with_differences(couple, random, census);
        couple.pair.accept();
        for (const Vec<3>& drag : {Vec<3>(0.02, 0.03, 0), Vec<3>(-0.3, 0.2, 0)}) {
          couple.move_die(drag);
          set_multipliers(couple, random, each, mu);
          compare_with_differences(couple, random, census);
          couple.pair.accept();
        }
      }
  census.expect({.states = 24, .stick = 100, .slip = 100});
}

TEST(MultiplierContact, TangentIsSymmetricWithoutFriction) {
  Random random(7);
  for (const MultiplierSpace space : multiplier_spaces)
    for (bool revolved : {false, true}) {
      Couple couple = pressed_disc("N2-N2.1", wavy(random, 3, 0.1, 2, 4), multipliers(space), 1.4, 0.0, revolved);
      couple.touch().move_die(0, -0.07);
      set_multipliers(couple, random, 1, 0);
      couple.evaluate();
      ASSERT_GT(couple.pair.resultant().active, 1);
      const Dense at = couple.dense();
      EXPECT_LE((at.tangent - at.tangent.transpose()).norm(), 1e-13 * at.tangent.norm());
    }
}

} // namespace multiplier_contact_test
} // namespace signorini::contact
