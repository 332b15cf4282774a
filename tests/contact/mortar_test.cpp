// Mortar contact without friction: tangent against finite differences in every state, symmetry, energy, balance of
// forces and moments, weighted gaps, history.
#include "contact/couple3d.hpp"
#include "contact/mortar_discs.hpp"

#include <cmath>

namespace signorini::contact {
namespace mortar_test {

using namespace test;

TEST(Mortar, TangentIsTheForcesDerivativeInEveryState) {
  Census sum;
  unsigned seed = 0;
  Random random(9);
  for (const MultiplierSpace space : multiplier_spaces)
    for (const char* label : {"N2", "N2-N2.2"}) {
      sum.add(press_and_drag(pressed_disc(label, slab(label), mortar(space), 0.8, 1.0), ++seed, 0.06, {0.02, 0.5}));
      for (int trial = 0; trial < 2; ++trial)
        sum.add(press_and_drag(pressed_disc(label, wavy(random, 3, 0.15, 3, 6), mortar(space), 1.3, 0.1), ++seed, 0.06,
                               {0.1, 0.4}));
      sum.add(
          press_and_drag(pressed_disc(label, make_ball<2>({1, -2}, 2), mortar(space), 1.3, 0.1), ++seed, 0.06, {0.1}));
      sum.add(press_and_drag(pressed_disc(label, make_plane<2>({0, 0}, {0.2, 2}), mortar(space), 1.3, 0.1, true),
                             ++seed, 0.06, {0.1}));
    }
  sum.expect({.states = 35, .open = 500, .stick = 500});
}

/// A ring touches with its seam, where one multiplier function belongs to the first and the last element.
TEST(Mortar, TangentIsTheForcesDerivativeAtASeam) {
  Census census;
  for (const double mu : {0.0, 0.3}) {
    const Eigen::Vector2d center(1, 0.5);
    auto ring = discretize(nurbs::rotate(nurbs::ring(0.3, 0.5, center), 180, center), {16, 2}, "N2", "south");
    const std::vector<int> shared = shared_numbers(ring, nurbs::side_of("south", 2));
    census.add(press_and_drag({std::move(ring), "south", make_plane<2>({0, 0}, {0.2, 2}),
                               mortar(MultiplierSpace::equal, mu), 6, false, shared},
                              3, 0.06, {0.02, 0.1}));
  }
  census.expect({.states = 4});
}

/// The slave is wider than the master, so that its outer points have no projection or a faded area.
TEST(Mortar, TangentIsTheForcesDerivativeAtTheEndsOfTheMaster) {
  Random random(5);
  Census census;
  for (const MultiplierSpace space : multiplier_spaces)
    for (double mu : {0.0, 0.3})
      for (int trial = 0; trial < 3; ++trial) {
        Couple couple = block_beyond_ends(random, mortar(space, mu));
        couple.move_die(0.004, -0.03);
        compare_with_differences(couple, census);
        EXPECT_GT(beyond(couple.pair), 2);
        EXPECT_GT(count(couple.pair, ContactState::open), 0);
        // Areas are reduced beyond the ends.
        double area = 0;
        for (const auto& multiplier : couple.pair.multipliers()) area += multiplier.area;
        EXPECT_GT(area, 0.55);
        EXPECT_LT(area, 0.75);
      }
  census.expect({.states = 8});
}

TEST(Mortar, TangentIsTheForcesDerivativeAtACorner) {
  const auto valley = polyline({{0, 1.6}, {1.5, 1}, {3, 1.6}});
  for (const MultiplierSpace space : multiplier_spaces)
    for (double mu : {0.0, 0.2}) {
      Couple couple = pressed_disc("N2", valley, mortar(space, mu), 1.5, 1.0);
      Random random(3);
      couple.shake(random, 0.001).evaluate().accept().move_die(0.01, -0.1);
      Census census;
      compare_with_differences(couple, census);
      EXPECT_EQ(census.states, 1);
      int corners = 0;
      for (const auto& point : couple.pair.results()) {
        const Eigen::Vector2d down = point.position - couple.pair.master().surface()->points().col(1);
        corners += point.state != ContactState::open && std::abs(std::abs(point.gap) - down.norm()) < 1e-14;
      }
      EXPECT_GE(corners, 2);
    }
}

TEST(Mortar, TangentIsSymmetricAndTheForceThatOfAnEnergy) {
  Random random(7);
  for (const MultiplierSpace space : multiplier_spaces)
    for (bool revolved : {false, true}) {
      Couple couple = pressed_disc("N2-N2.1", wavy(random, 3, 0.1, 2, 4), mortar(space), 1.4, 0.0, revolved);
      couple.touch().move_die(0, -0.07).shake(random, 0.001).evaluate();
      ASSERT_GT(count(couple.pair, ContactState::stick), 1);
      const Dense at = couple.dense();
      EXPECT_LE((at.tangent - at.tangent.transpose()).norm(), 1e-13 * at.tangent.norm());
      const VectorX start = couple.u;
      for (int k = 0; k < 5; ++k) {
        VectorX direction(start.size());
        for (int i = 0; i < direction.size(); ++i) direction(i) = uniform(random, -1, 1);
        const double slope = signorini::test::derivative<double>(
            [&](double h) {
              couple.evaluate(start + h * direction);
              return couple.pair.potential();
            },
            1e-5);
        EXPECT_NEAR(slope, at.force.dot(direction), 1e-7 * at.force.norm() * direction.norm());
      }
    }
}

/// A flat face at a uniform gap: each multiplier has this gap and ε times it as pressure, in sum 1 per area.
TEST(Mortar, WeightedGapsOfAFlatFaceAreUniform) {
  const auto block = discretize(nurbs::rectangle(2, 0.5, Eigen::Vector2d(0, 0)), {5, 1}, "N2", "south");
  for (const MultiplierSpace space : multiplier_spaces) {
    Couple couple(block, "south", make_plane<2>({0, 0}, {0, 1}), mortar(space), 4);
    couple.move_die(0.3, -0.02).evaluate();
    double area = 0;
    for (const auto& multiplier : couple.pair.multipliers()) {
      EXPECT_NEAR(multiplier.gap, -0.02, 1e-15);
      EXPECT_NEAR(multiplier.pressure, 2, 1e-13);
      area += multiplier.area;
    }
    EXPECT_NEAR(area, 2, 1e-14);
    for (const auto& point : couple.pair.results()) EXPECT_NEAR(point.pressure, 2, 1e-13);
    const Resultant<2> sum = couple.pair.resultant();
    EXPECT_NEAR(sum.force(1), 4, 1e-13);
    EXPECT_NEAR(couple.pair.area(), 2, 1e-13);
    EXPECT_NEAR(couple.pair.potential(), 0.5 * 100 * 0.02 * 0.02 * 2, 1e-14);
    // Tractions act on the reference area: a face stretched to twice its width carries the same force.
    for (int i = 0; i < couple.die_dofs(); i += 2) couple.u(i) = couple.die.points()(0, i / 2);
    couple.evaluate();
    EXPECT_NEAR(couple.pair.resultant().force(1), 4, 1e-13);
  }
}

TEST(Mortar, ForcesBalanceAndWithoutFrictionMomentsToo) {
  Random random(4);
  for (const MultiplierSpace space : multiplier_spaces)
    for (double mu : {0.0, 0.3})
      for (int trial = 0; trial < 5; ++trial) {
        Couple couple = pressed_disc("N2-N4", wavy(random, 3, 0.1, 3, 6), mortar(space, mu), 1.3, 0.1);
        couple.touch().move_die(0.02, -0.07).shake(random, 0.005);
        expect_balanced(couple, mu);
      }
}

TEST(Mortar, RollbackRestoresBitwise) {
  Random random(5);
  for (const MultiplierSpace space : multiplier_spaces) {
    Couple couple = pressed_disc("N2-N2.1", slab("N2"), mortar(space, 0.2), 1.3, 1.0);
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
    const auto& again = couple.pair.blocks();
    ASSERT_EQ(again.size(), blocks.size());
    for (std::size_t k = 0; k < blocks.size(); ++k) {
      EXPECT_EQ(again[k].force, blocks[k].force);
      EXPECT_EQ(again[k].matrix, blocks[k].matrix);
    }
  }
}

TEST(Mortar, SkippingFarElementsMissesNoContact) {
  Random random(8);
  for (const MultiplierSpace space : multiplier_spaces)
    for (double mu : {0.0, 0.2}) {
      const auto fresh_couple = [&] { return pressed_disc("N2", slab("N2"), mortar(space, mu), 1.3, 1.02); };
      Couple couple = fresh_couple();
      couple.touch().move_die(0, 0.02);
      int touched = 0;
      for (int jump = 0; jump < 60; ++jump) {
        const VectorX u = couple.u;
        couple.move_die(uniform(random, -0.6, 0.6), uniform(random, -0.25, 0.3)).shake(random, 0.02).evaluate();
        Couple fresh = fresh_couple();
        fresh.evaluate(couple.u);
        for (std::size_t i = 0; i < fresh.pair.results().size(); ++i)
          EXPECT_NEAR(couple.pair.results()[i].pressure, fresh.pair.results()[i].pressure, 1e-9) << "jump " << jump;
        touched += fresh.pair.resultant().active > 0;
        if (jump % 3 == 0) couple.pair.accept();
        if (jump % 3 == 1) couple.pair.rollback();
        couple.u = u;
      }
      EXPECT_GT(touched, 10);
      EXPECT_LT(touched, 60);
    }
}

TEST(Mortar, ErrorsNameTheArgument) {
  const auto build = [](const InterfaceLaw& own) {
    pressed_disc("N2", slab("N2"), Law(own, MultiplierSpace::equal), 1, 1);
  };
  EXPECT_ERROR(build({0, 100, 0.2}), "contact.penalty.normal: value = 0");
  EXPECT_ERROR(build({100, 0, 0.2}), "contact.penalty.tangential: value = 0");
  EXPECT_ERROR(Couple(polyline({{0, 2}, {1, 2}}), "north", slab("N2"), mortar(MultiplierSpace::reduced), 3),
               "contact.mortar.reduced_degree: degree = 1");
}

} // namespace mortar_test
} // namespace signorini::contact
