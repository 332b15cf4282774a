// Half passes of mortar contact: forces on the slave alone, per current area; tangents against finite differences in
// every state, in 2D, axisymmetric and 3D; weighted gaps of stretched faces, energies.
#include "contact/couple3d.hpp"
#include "contact/mortar_discs.hpp"

#include <cmath>
#include <functional>

namespace signorini::contact {
namespace mortar_half_pass_test {

using namespace test;

Method half(MultiplierSpace space, double mu) {
  return {{100, 80, mu}, space, Pass::half};
}

/// Lengthens a disc along x by a share of its width, so that current and reference areas differ.
template <class AnyCouple> void stretch(AnyCouple& couple, double share) {
  constexpr int dimension = std::is_same_v<AnyCouple, Couple> ? 2 : 3;
  const MatrixX points = couple.die.points();
  const double middle = points.row(0).mean();
  for (int i = 0; i < couple.die_dofs(); i += dimension) couple.u(i) += share * (points(0, i / dimension) - middle);
}

TEST(MortarHalfPass, TangentIsTheForcesDerivativeInEveryState) {
  Census sum;
  unsigned seed = 0;
  Random random(9);
  for (const MultiplierSpace space : multiplier_spaces)
    for (double mu : {0.0, 0.3})
      for (const char* label : {"N2", "N2-N2.2"}) {
        // Small drags stick, longer ones slip; after one longer than an element former foot points lie in others.
        const bool revolved = label[2] == '\0'; // N2
        Couple couple = pressed_disc(label, slab("N2"), half(space, mu), 0.8, 1.0, revolved);
        stretch(couple, 0.2);
        sum.add(press_and_drag(std::move(couple), ++seed, 0.06, {3e-4, 0.02, 0.5}));
        sum.add(press_and_drag(pressed_disc(label, wavy(random, 3, 0.1, 3, 6), half(space, mu), 1.3, 0.1), ++seed, 0.07,
                               {1e-3, 0.1, -0.4}));
        // Beyond the open end of the master, where the area fades
        sum.add(press_and_drag(pressed_disc(label, slab("N2"), half(space, mu), 2.9, 1.0), ++seed, 0.06, {3e-4, 0.02}));
      }
  sum.expect({.states = 45, .open = 800, .stick = 400, .slip = 150});
}

/// The slave is wider than the master, so that its outer points have no projection.
TEST(MortarHalfPass, TangentIsTheForcesDerivativeOfAPartlyProjectedFace) {
  Random random(5);
  Census census;
  for (const MultiplierSpace space : multiplier_spaces)
    for (double mu : {0.0, 0.3})
      for (int trial = 0; trial < 3; ++trial) {
        Couple couple = block_beyond_ends(random, half(space, mu));
        stretch(couple, 0.1);
        couple.move_die(0.004, -0.03);
        compare_with_differences(couple, census);
        EXPECT_GT(beyond(couple.pair), 2);
      }
  census.expect({.states = 8});
}

TEST(MortarHalfPass, TangentIsTheForcesDerivativeAtACorner) {
  const auto valley = polyline({{0, 1.6}, {1.5, 1}, {3, 1.6}});
  for (const MultiplierSpace space : multiplier_spaces)
    for (double mu : {0.0, 0.2}) {
      Couple couple = pressed_disc("N2", valley, half(space, mu), 1.5, 1.0);
      Random random(3);
      couple.shake(random, 0.001).evaluate().accept().move_die(0.01, -0.1);
      Census census;
      compare_with_differences(couple, census);
      EXPECT_EQ(census.states, 1);
    }
}

TEST(MortarHalfPass, TangentIsTheForcesDerivativeOfSolids) {
  Random random(1);
  Census census;
  for (const MultiplierSpace space : multiplier_spaces)
    for (double mu : {0.0, 0.3})
      for (const char* label : {"N2", "N2-N2.1"}) {
        Couple3 couple(label, wavy_plate(random, 3, 0.02, 2, 4), half(space, mu), {1.4, 1.5, 0.1}, 5);
        couple.shake(random, 0.003);
        stretch(couple, 0.1);
        couple.touch().move_die({0, 0, -0.08});
        compare_with_differences(couple, random, census);
        couple.pair.accept();
        drag_and_compare(couple, random, {{3e-4, 1e-4, 0}, {0.02, 0.03, 0}, {-0.3, 0.2, 0}}, census);
        couple.turn_die(0.1, {1.5, 1.5, 0});
        compare_with_differences(couple, random, census);
      }
  census.expect({.states = 30, .stick = 200, .slip = 200});
}

/// Pressed and dragged as a rigid body, whose current area is the reference one: forces on the slave are those of a
/// full pass, those on the master are zero, energies are half.
template <class AnyCouple, class Move>
void compare_with_full(AnyCouple full, AnyCouple pass, const Move& press, const Move& drag) {
  for (const Move& move : {press, drag})
    for (AnyCouple* couple : {&full, &pass}) {
      move(*couple);
      couple->evaluate();
      couple->pair.accept();
    }
  ASSERT_GT(full.pair.resultant().slipping, 0);
  const Dense all = full.dense(), own = pass.dense();
  const auto slave = full.die_dofs(), master = full.base_dofs();
  EXPECT_LE((all.force.head(slave) - own.force.head(slave)).norm(), 1e-12 * all.force.norm());
  EXPECT_EQ(own.force.tail(master).norm(), 0);
  EXPECT_EQ(own.tangent.bottomRows(master).norm(), 0);
  // Moves of the master do not change the slave's area.
  const auto of_master = [&](const Dense& dense) { return MatrixX(dense.tangent.topRightCorner(slave, master)); };
  EXPECT_LE((of_master(all) - of_master(own)).norm(), 1e-12 * all.tangent.norm());
  EXPECT_NEAR(pass.pair.potential(), 0.5 * full.pair.potential(), 1e-12 * full.pair.potential());
  EXPECT_GT(full.pair.dissipated(), 0);
  EXPECT_NEAR(pass.pair.dissipated(), 0.5 * full.pair.dissipated(), 1e-12 * full.pair.dissipated());
  EXPECT_FALSE(pass.pair.formulation().has_potential());
}

TEST(MortarHalfPass, ActsOnTheSlaveAsAFullPassDoes) {
  const std::function<void(Couple&)> down = [](Couple& c) { c.move_die(0, -0.05); };
  const std::function<void(Couple&)> along = [](Couple& c) { c.move_die(0.03, 0); };
  const std::function<void(Couple3&)> below = [](Couple3& c) { c.move_die({0, 0, -0.2}); };
  const std::function<void(Couple3&)> across = [](Couple3& c) { c.move_die({0.03, 0.02, 0}); };
  for (const MultiplierSpace space : multiplier_spaces) {
    const auto disc = [&](const Law& law) { return pressed_disc("N2", slab("N2"), law, 1.4, 1.0); };
    compare_with_full(disc(mortar(space, 0.2)), disc(half(space, 0.2)), down, along);
    const auto indenter = [&](const Law& law) {
      Random random(2);
      return Couple3("N2", wavy_plate(random, 3, 0.02, 2, 4), law, {1.4, 1.5, 0.1}, 5);
    };
    compare_with_full(indenter(mortar(space, 0.2)), indenter(half(space, 0.2)), below, across);
  }
}

/// A flat face that is stretched to double width carries the same pressure, so that its force is doubled, and the
/// springs' energy grows with its area.
TEST(MortarHalfPass, TractionsActPerCurrentArea) {
  const auto block = discretize(nurbs::rectangle(2, 0.5, Eigen::Vector2d(0, 0)), {5, 1}, "N2", "south");
  for (const MultiplierSpace space : multiplier_spaces) {
    Couple couple(block, "south", make_plane<2>({0, 0}, {0, 1}), half(space, 0), 4);
    couple.move_die(0.3, -0.02).evaluate();
    EXPECT_NEAR(couple.pair.resultant().force(1), 4, 1e-13);
    EXPECT_NEAR(couple.pair.potential(), 0.5 * (0.5 * 100 * 0.02 * 0.02 * 2), 1e-14);
    couple.pair.accept();
    EXPECT_EQ(couple.pair.history().growth, 0);
    stretch(couple, 1);
    couple.evaluate();
    for (const auto& multiplier : couple.pair.multipliers()) EXPECT_NEAR(multiplier.pressure, 2, 1e-13);
    for (const auto& point : couple.pair.results()) EXPECT_NEAR(point.pressure, 2, 1e-13);
    EXPECT_NEAR(couple.pair.resultant().force(1), 8, 1e-12);
    EXPECT_NEAR(couple.pair.area(), 4, 1e-12);
    couple.pair.accept();
    EXPECT_NEAR(couple.pair.history().growth, 0.5 * (0.5 * 100 * 0.02 * 0.02 * 2), 1e-14);
  }
}

/// Weighted gaps of a face that is stretched unevenly depend on its current shape alone: Σ a_A ḡ_A = ∫ g da and
/// Σ a_A = ∫ da, from x = 0 to 2 at gaps g = −0.1 + 0.02 x to the plane y = 0.
TEST(MortarHalfPass, GapsAreWeightedWithTheCurrentArea) {
  const auto block = discretize(nurbs::rectangle(2, 0.5, Eigen::Vector2d(0, 0)), {5, 1}, "N2", "south");
  for (const MultiplierSpace space : multiplier_spaces) {
    Couple couple(block, "south", make_plane<2>({0, 0}, {0, 1}), half(space, 0), 4);
    const MatrixX points = block.points();
    const double slope = 0.02, length = std::sqrt(1 + slope * slope);
    for (int i = 0; i < couple.die_dofs(); i += 2) {
      const double before = points(0, i / 2), x = before + 0.3 * before * (2 - before);
      couple.u(i) = x - before;
      couple.u(i + 1) = -0.1 + slope * x;
    }
    couple.evaluate();
    double area = 0, gap = 0;
    for (const auto& multiplier : couple.pair.multipliers()) {
      area += multiplier.area;
      gap += multiplier.area * multiplier.gap;
    }
    EXPECT_NEAR(area, 2 * length, 1e-13);
    EXPECT_NEAR(gap, (-0.2 + 0.5 * slope * 4) * length, 1e-14);
  }
}

} // namespace mortar_half_pass_test
} // namespace signorini::contact
