// Bonded faces in 2D and 3D: tangent, symmetry, balance of forces, energies, history.
#include "contact/bonded.hpp"

#include <cmath>
#include <numbers>

namespace signorini::contact {
namespace cohesive_pair_test {

using namespace test;

const Cohesion exponential{2, 0.05}, bilinear{2, 0.05, Softening::bilinear, 150};

TEST(CohesivePair, TangentIsTheForcesDerivativeInThePlane) {
  Census census;
  for (const Cohesion& cohesion : {exponential, bilinear})
    for (const bool revolved : {false, true}) {
      std::vector<Bonded<2>> couples;
      couples.emplace_back(strip("N2"), "south", ground(5), "north", with(cohesion), revolved);
      couples.emplace_back(strip("N3"), "south", make_plane<2>({0, 0}, {0, 1}), with(cohesion), revolved);
      couples.emplace_back(ring(0.5, 1, 6, "south"), "south", ring(1, 1.4, 5, "north"), "north", with(cohesion),
                           revolved);
      unsigned seed = 1;
      // Points of the ring move beyond the master's ends, where the area fades.
      for (auto& couple : couples) move_and_compare(couple, seed++, &couple != &couples[2], census);
    }
  census.expect({.states = 50, .open = 50, .stick = 300, .bonded = 300, .opening = 300, .elsewhere = 5});
}

TEST(CohesivePair, TangentIsTheForcesDerivativeWithFriction) {
  Census census;
  for (const Cohesion& cohesion : {exponential, bilinear}) {
    std::vector<Bonded<2>> couples;
    couples.emplace_back(strip("N2"), "south", ground(5), "north", with(cohesion, 0.3));
    couples.emplace_back(strip("N3"), "south", make_plane<2>({0, 0}, {0, 1}), with(cohesion, 0.3));
    unsigned seed = 11;
    for (auto& couple : couples) move_and_compare(couple, seed++, false, census);
  }
  census.expect({.states = 15, .stick = 40, .slip = 40});
}

TEST(CohesivePair, TangentIsTheForcesDerivativeInSpace) {
  Census census;
  for (const double mu : {0.0, 0.3}) {
    std::vector<Bonded<3>> couples;
    couples.emplace_back(block(0, 0, {2, 2, 1}, "front"), "front", block(-0.5, 0.2, {3, 2, 1}, "back"), "back",
                         with(exponential, mu));
    couples.emplace_back(block(0, 0, {2, 1, 1}, "front"), "front", make_plane<3>({0, 0, 0}, {0, 0, 1}),
                         with(bilinear, mu));
    unsigned seed = 21;
    for (auto& couple : couples) move_and_compare(couple, seed++, mu == 0, census);
  }
  census.expect({.states = 18, .stick = 100, .slip = 20, .bonded = 100});
}

/// Forces and moments vanish in sum without friction, because each acts along the line between its two points.
TEST(CohesivePair, ForcesAndMomentsBalance) {
  Bonded<2> couple(ring(0.5, 1, 6, "south"), "south", ring(1, 1.4, 5, "north"), "north", with(exponential));
  Random random(5);
  for (const double lift : {0.02, -0.01}) {
    couple.move_die({0.01, lift}).shake(random, 1e-3);
    expect_balanced(couple, 0, 1e-12);
  }
}

double energy(const Bonded<2>& couple) {
  return couple.pair.potential() + couple.pair.history().debonding;
}

/// Complete separation takes G_c per area, whatever the mixture of opening and shear, also pressed (without friction).
TEST(CohesivePair, SeparationTakesTheEnergyForAnyMixture) {
  for (const Cohesion& cohesion : {exponential, bilinear}) {
    const double last = cohesion.softening == Softening::bilinear ? 2 * cohesion.energy / cohesion.strength
                                                                  : 40 * strongest_opening(cohesion);
    for (const double angle : {90.0, 60.0, 25.0, 0.0}) {
      Bonded<2> couple(strip("N2"), "south", make_plane<2>({0, 0}, {0, 1}), with(cohesion));
      const double turn = angle * std::numbers::pi / 180;
      const Vec<2> way(std::cos(turn), std::sin(turn)), pressed(0, angle == 0 ? -0.002 : 0);
      constexpr int steps = 400;
      double work = 0;
      for (int step = 1; step <= steps; ++step) {
        couple.place_die(pressed + 1.01 * last * step / steps * way);
        // Simpson's rule on the force on the slave, which is the same along the whole path
        work -= couple.pair.resultant().force.dot(way) * 1.01 * last / steps * (step % 2 == 1 ? 4 : 2) / 3;
        couple.pair.accept();
      }
      const double springs = 3 * 0.5 * 100 * pressed.squaredNorm();
      EXPECT_NEAR(energy(couple) - springs, 3 * cohesion.energy, 1e-10) << angle;
      EXPECT_NEAR(work, 3 * cohesion.energy, 2e-3 * cohesion.energy) << angle;
    }
  }
}

/// The force falls along the secant to zero at the bonded point, and rises again along it.
TEST(CohesivePair, ClosesToTheOrigin) {
  for (const Cohesion& cohesion : {exponential, bilinear}) {
    Bonded<2> couple(strip("N2"), "south", make_plane<2>({0, 0}, {0, 1}), with(cohesion));
    const double most = 1.7 * strongest_opening(cohesion);
    const Vec<2> way(0.6, 0.8);
    couple.place_die(most * way);
    const Vec<2> force = couple.pair.resultant().force;
    EXPECT_NEAR(force.norm(), 3 * separate(cohesion, most, 0).stiffness * most, 1e-12);
    EXPECT_NEAR((force + force.norm() * way).norm(), 0, 1e-12);
    couple.pair.accept();
    for (const double part : {0.5, 0.0, 0.7}) {
      couple.place_die(part * most * way);
      EXPECT_NEAR((couple.pair.resultant().force - part * force).norm(), 0, 1e-12);
      couple.pair.accept();
    }
    EXPECT_NEAR(couple.pair.history().debonding, 3 * separate(cohesion, most, 0).dissipated, 1e-13);
  }
}

TEST(CohesivePair, RollBackForgetsTheOpening) {
  Bonded<2> couple(strip("N2"), "south", ground(5), "north", with(exponential, 0.2));
  couple.place_die({0, 0.01});
  couple.pair.accept();
  couple.place_die({0, 0.008});
  const VectorX before = couple.dense().force;
  couple.place_die({0.02, 0.09});
  couple.pair.rollback();
  couple.place_die({0, 0.008});
  EXPECT_EQ((couple.dense().force - before).norm(), 0);
}

/// Where the bond is broken, friction reaches μ p; where it holds, pressure alone opens nothing.
TEST(CohesivePair, PressureNeitherOpensNorIsHeld) {
  Bonded<2> couple(strip("N2"), "south", make_plane<2>({0, 0}, {0, 1}), with(bilinear, 0.3));
  couple.place_die({0, -0.02});
  EXPECT_NEAR(couple.pair.resultant().force(1), 3 * 100 * 0.02, 1e-12);
  EXPECT_NEAR(couple.pair.resultant().force(0), 0, 1e-12);
  for (const auto& bond : couple.pair.present().bonds) EXPECT_LT(bond.largest, 1e-10);
  couple.pair.accept();
  for (int step = 1; step <= 40; ++step) {
    couple.place_die({0.005 * step, -0.02});
    couple.pair.accept();
  }
  EXPECT_NEAR(couple.pair.resultant().force(0), -0.3 * 3 * 100 * 0.02, 1e-12);
  EXPECT_NEAR(couple.pair.history().debonding, 3 * bilinear.energy, 1e-12);
}

TEST(CohesivePair, ErrorsNameTheArgument) {
  const auto at = [](double y) {
    return Bonded<2>(strip("N2"), "south", make_plane<2>({0, y}, {0, 1}), with(exponential));
  };
  EXPECT_ERROR(at(-0.1), "contact.cohesion.apart: distance = 0.1");
  EXPECT_NEAR(strongest_opening(exponential), 0.05 / (2 * std::numbers::e), 1e-15);
  at(-9e-6); // a thousandth of it
}

} // namespace cohesive_pair_test
} // namespace signorini::contact
