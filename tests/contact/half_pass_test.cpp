// Half passes: forces on the slave alone, equal to those of a full pass; tangents against finite differences in every
// state, in 2D, axisymmetric and 3D; energies that count half.
#include "contact/couple.hpp"
#include "contact/couple3d.hpp"

#include <functional>

namespace signorini::contact {
namespace half_pass_test {

using namespace test;

Method half(double mu, double tangential = 100) {
  return {{100, tangential, mu}, {}, Pass::half};
}

TEST(HalfPass, TangentIsTheForcesDerivativeInEveryState) {
  Census sum;
  unsigned seed = 0;
  Random random(9);
  for (const char* label : {"N2", "N4", "N2-N2.2"})
    for (double mu : {0.0, 0.2}) {
      // Small drags stick, longer ones slip; after one longer than an element the slip point lies in another element.
      sum.add(press_and_drag(Couple(label, slab("N2"), half(mu), 0.8, 1.0), ++seed, 0.06, {3e-4, 0.02, 0.5}));
      sum.add(press_and_drag(Couple(label, slab("N2"), half(mu), 0.8, 1.0, true), ++seed, 0.06, {3e-4, 0.02, 0.5}));
      sum.add(press_and_drag(Couple(label, wavy(random, 3, 0.15, 3, 6), half(mu, 50), 1.3, 0.1), ++seed, 0.06,
                             {1e-3, 0.1, 0.4}));
      // Beyond the open end of the master, where the area fades
      sum.add(press_and_drag(Couple(label, slab("N2"), half(mu), 2.9, 1.0), ++seed, 0.06, {3e-4, 0.02}));
    }
  sum.expect({.states = 50, .open = 500, .stick = 100, .slip = 100, .elsewhere = 10});
}

TEST(HalfPass, TangentIsTheForcesDerivativeAtAKinkOfTheMaster) {
  const auto valley = polyline({{0, 1.6}, {1.5, 1}, {3, 1.6}});
  for (double drag : {2e-4, 0.02}) {
    Couple couple("N2", valley, half(0.2), 1.5, 1.0);
    Random random(3);
    couple.shake(random, 0.001).evaluate().accept();
    couple.move_die(drag, -0.1); // closes within the step
    Census census;
    compare_with_differences(couple, census);
    couple.accept().move_die(drag, 0);
    compare_with_differences(couple, census);
    EXPECT_EQ(census.states, 2);
    EXPECT_GT(census.slip + census.stick, 10);
  }
}

TEST(HalfPass, TangentIsTheForcesDerivativeOfSolids) {
  Random random(1);
  Census census;
  for (const char* label : {"N2", "N2-N2.1"})
    for (double mu : {0.0, 0.3})
      for (int degree : {1, 2}) {
        Couple3 couple(label, wavy_plate(random, 3, 0.02, degree, 4), half(mu, 80), {1.4, 1.5, 0.1});
        couple.shake(random, 0.003).touch().move_die({0, 0, -0.05});
        compare_with_differences(couple, random, census);
        couple.pair.accept();
        drag_and_compare(couple, random, {{3e-4, 1e-4, 0}, {-0.05, 0.01, 0}, {0.3, 0.2, 0}}, census);
      }
  census.expect({.states = 25, .stick = 100, .slip = 50, .elsewhere = 3});
}

/// Pressed and dragged: the slave's rows are bitwise those of a full pass, the master's are zero, energies are half.
template <class AnyCouple, class Move>
void compare_with_full(AnyCouple full, AnyCouple pass, const Move& press, const Move& drag) {
  const auto go = [&](const Move& move) {
    for (AnyCouple* couple : {&full, &pass}) {
      move(*couple);
      couple->evaluate();
      couple->pair.accept();
    }
  };
  go(press);
  go(drag);
  ASSERT_GT(full.pair.resultant().slipping, 0);
  const Dense all = full.dense(), own = pass.dense();
  const auto slave = full.die_dofs(), master = full.base_dofs();
  EXPECT_EQ((all.force.head(slave) - own.force.head(slave)).norm(), 0);
  EXPECT_EQ(own.force.tail(master).norm(), 0);
  EXPECT_EQ(own.tangent.bottomRows(master).norm(), 0);
  EXPECT_LE((all.tangent.topRows(slave) - own.tangent.topRows(slave)).norm(), 1e-15 * all.tangent.norm());
  EXPECT_EQ(pass.pair.potential(), 0.5 * full.pair.potential());
  EXPECT_GT(full.pair.dissipated(), 0);
  EXPECT_EQ(pass.pair.dissipated(), 0.5 * full.pair.dissipated());
  EXPECT_EQ(pass.pair.history().growth, 0.5 * full.pair.history().growth);
  EXPECT_FALSE(pass.pair.formulation().has_potential());
}

TEST(HalfPass, ActsOnTheSlaveAsAFullPassDoes) {
  const std::function<void(Couple&)> down = [](Couple& c) { c.move_die(0, -0.05); };
  const std::function<void(Couple&)> along = [](Couple& c) { c.move_die(0.03, 0); };
  const InterfaceLaw law = half(0.2).law;
  compare_with_full(Couple("N2", slab("N2"), law, 1.4, 1.0), Couple("N2", slab("N2"), half(0.2), 1.4, 1.0), down,
                    along);
  Random one(2), same(2);
  const std::function<void(Couple3&)> below = [](Couple3& c) { c.move_die({0, 0, -0.2}); };
  const std::function<void(Couple3&)> across = [](Couple3& c) { c.move_die({0.03, 0.02, 0}); };
  compare_with_full(Couple3("N2", wavy_plate(one, 3, 0.02, 2, 4), law, {1.4, 1.5, 0.1}),
                    Couple3("N2", wavy_plate(same, 3, 0.02, 2, 4), half(0.2), {1.4, 1.5, 0.1}), below, across);
}

} // namespace half_pass_test
} // namespace signorini::contact
