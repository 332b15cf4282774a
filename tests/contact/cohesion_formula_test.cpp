// Bonds by formula: law, energies, damage and mode mix at a point, tangents and dissipation of bonded faces.
#include "contact/bonded.hpp"
#include "contact/terms.hpp"

#include "differences.hpp"

#include <cmath>
#include <numbers>

namespace signorini::contact {
namespace cohesion_formula_test {

using namespace test;

constexpr double strength = 2, opening_energy = 0.05, shear_energy = 0.12, stiff = 150;

double energy_at(double m) {
  return opening_energy + (shear_energy - opening_energy) * m * m;
}
Term energy_of(const Term& m) {
  return opening_energy * m.constant(1) + (shear_energy - opening_energy) * power(m, 2);
}
Term exponential_of(const Term& a) {
  return {a.graph, a.graph->apply(symbolic::Operation::exp, a.node)};
}
Term smaller(const Term& a, const Term& b) {
  return 0.5 * (a + b - absolute(a - b));
}

using Formula = Term (*)(const Term& u, const Term& m);
/// K u exp(−u/c), K = e² σ²/G(0), c² = G/K
Term smooth(const Term& u, const Term& m) {
  const double K = std::exp(2) * strength * strength / opening_energy;
  return K * u * exponential_of(-std::sqrt(K) * u * power(energy_of(m), -0.5));
}
Term smooth_unmixed(const Term& u, const Term&) {
  return smooth(u, u.constant(0));
}
/// min(K u, σ (δ_f − u)/(δ_f − δ₀)), δ_f = 2 G/σ
Term linear(const Term& u, const Term& m) {
  const Term last = 2 / strength * energy_of(m), b = last - u;
  return smaller(stiff * u, 0.5 * strength * (b + absolute(b)) * power(last - strength / stiff, -1));
}
Term linear_unmixed(const Term& u, const Term&) {
  return linear(u, u.constant(0));
}

std::shared_ptr<const CohesionFormula> made(Formula formula, double shear = 1) {
  const auto graph = std::make_shared<symbolic::Graph>(cohesion_variables());
  const Term traction = formula({graph, graph->variable(0)}, {graph, graph->variable(1)});
  return make_cohesion_formula({*graph, traction.node}, shear);
}
Cohesion law(Formula formula, double shear = 1) {
  return cohesive(made(formula, shear));
}
const Cohesion exponential{strength, opening_energy}, bilinear{strength, opening_energy, Softening::bilinear, stiff};

TEST(CohesionFormula, OfALawIsTheLaw) {
  for (const auto& [formula, own] : {std::pair{&smooth_unmixed, exponential}, std::pair{&linear_unmixed, bilinear}}) {
    const Cohesion cohesion = law(formula);
    EXPECT_NEAR(cohesion.strength, strength, 1e-9 * strength);
    EXPECT_NEAR(cohesion.energy, opening_energy, 1e-13 * opening_energy);
    EXPECT_NEAR(strongest_opening(cohesion), strongest_opening(own), 1e-6 * strongest_opening(own));
    for (double x = 1e-9; x < 30; x *= 1.7) {
      const double opening = x * strongest_opening(own);
      const Separation found = separate(cohesion, opening, 0), expected = separate(own, opening, 0);
      EXPECT_NEAR(found.stiffness * opening, expected.stiffness * opening, 1e-13 * strength) << x;
      EXPECT_NEAR(found.damage, expected.damage, 1e-12) << x;
      const CohesionFormula::Loss loss = cohesion.formula->loss(1, found.left, 0);
      EXPECT_NEAR(loss.dissipated, expected.dissipated, 1e-12 * opening_energy) << x;
      // On the secant
      const Separation back = separate(cohesion, 0.4 * opening, 0, 0, found.left);
      EXPECT_EQ(back.stiffness, found.stiffness);
      EXPECT_EQ(back.rate, 0);
    }
  }
}

TEST(CohesionFormula, RatesAreDerivatives) {
  for (const Formula formula : {&smooth, &linear})
    for (const double x : {1e-4, 0.3, 0.8, 1.4, 2.5})
      for (const double m : {0.1, 0.5, 0.9}) {
        const Cohesion cohesion = law(formula);
        const double peak = strongest_opening(cohesion), u = x * peak;
        const Separation at = separate(cohesion, u, 0, m);
        const auto slope = [&](auto value, double step) { return signorini::test::derivative<double>(value, step); };
        const double scale = cohesion.formula->stiffness;
        EXPECT_NEAR(at.rate, slope([&](double h) { return separate(cohesion, u + h, 0, m).stiffness; }, 1e-3 * u),
                    1e-7 * scale / peak);
        EXPECT_NEAR(at.of_mix, slope([&](double h) { return separate(cohesion, u, 0, m + h).stiffness; }, 1e-3),
                    1e-7 * scale);
        EXPECT_EQ(at.damage_rate * scale, -at.rate);
      }
}

/// At a fixed mixture the traction works in proportion to m, and complete separation takes G(m), by any steps.
TEST(CohesionFormula, SeparationTakesTheEnergyOfTheMixture) {
  for (const Formula formula : {&smooth, &linear})
    for (const double m : {0.0, 0.25, 0.6, 1.0}) {
      const Cohesion cohesion = law(formula);
      EXPECT_NEAR(cohesion.formula->rest(0, m), energy_at(m), 1e-12 * energy_at(m));
      double left = 1, sum = 0, remaining = 1;
      for (int step = 1; step <= 60; ++step) {
        const Separation at = separate(cohesion, strongest_opening(cohesion) * step, 0, m, left);
        const CohesionFormula::Loss loss = cohesion.formula->loss(left, at.left, m);
        EXPECT_GE(loss.dissipated, 0);
        left = at.left;
        sum += loss.dissipated;
        remaining *= loss.remaining;
        EXPECT_NEAR(remaining, 1 - sum / energy_at(m), 1e-11);
      }
      EXPECT_NEAR(sum, energy_at(m), 1e-10 * energy_at(m));
    }
}

/// On random paths of opening and shear the work is what is stored and what is dissipated, which never falls.
TEST(CohesionFormula, RandomPathsDissipate) {
  Random random(7);
  for (const Formula formula : {&smooth, &linear})
    for (int path = 0; path < 12; ++path) {
      const double b = uniform(random, 0.6, 1.8);
      const Cohesion cohesion = law(formula, b);
      const double peak = strongest_opening(cohesion);
      Vec<2> apart(0, 0), force(0, 0);
      double left = 1, mix = 0, work = 0, dissipated = 0, stored = 0;
      for (int leg = 0; leg < 5; ++leg) {
        const Vec<2> to(uniform(random, -4, 4) * peak, uniform(random, 0, 4) * peak), from = apart;
        constexpr int steps = 400;
        for (int step = 1; step <= steps; ++step) {
          const Vec<2> next = from + (to - from) * step / steps, measure(b * next(0), next(1));
          const double u = measure.norm(), m = u > 0 ? measure(0) * measure(0) / (u * u) : 0;
          const Separation at = separate(cohesion, u, 0, m, left);
          const Vec<2> traction = at.stiffness * Vec<2>(b * b * next(0), next(1));
          work += 0.5 * (traction + force).dot(next - apart);
          EXPECT_LE(at.left, left);
          if (at.left < left) {
            const double loss = cohesion.formula->loss(left, at.left, left < 1 ? 0.5 * (m + mix) : m).dissipated;
            EXPECT_GE(loss, 0);
            dissipated += loss;
            mix = m;
          }
          left = at.left;
          apart = next;
          force = traction;
          stored = 0.5 * at.stiffness * u * u;
        }
      }
      EXPECT_NEAR(work, stored + dissipated, 2e-3 * opening_energy);
    }
}

TEST(CohesionFormula, ErrorsNameOpeningAndValue) {
  const auto refuses = [](Formula formula, const char* message) { EXPECT_ERROR(made(formula), message); };
  refuses([](const Term& u, const Term&) { return u - 2.0 * power(u, 2); }, "contact.cohesion.negative: opening = ");
  refuses([](const Term& u, const Term&) { return exponential_of(-1.0 * u); },
          "contact.cohesion.start: mix = 0, value = 1");
  refuses([](const Term& u, const Term&) { return -1.0 * u * exponential_of(-1.0 * u); },
          "contact.cohesion.slope: value = -1");
  refuses([](const Term& u, const Term&) { return (u + 0.1) * exponential_of(-1.0 * u); }, "contact.cohesion.start");
  refuses([](const Term& u, const Term&) { return power(u, 0.5) * exponential_of(-1.0 * u); },
          "contact.cohesion.slope");
  refuses([](const Term& u, const Term&) { return (u + 4.0 * power(u, 3)) * exponential_of(-1.0 * u); },
          "contact.cohesion.secant");
  refuses([](const Term& u, const Term&) { return u * power(u + 1, -2); }, "contact.cohesion.area");
  refuses([](const Term& u, const Term& m) { return (m + 1) * u * exponential_of(-1.0 * u); },
          "contact.cohesion.mixed_slope: mix = 0.05, value = 1.05, first = 1");
  refuses([](const Term& u, const Term& m) { return u * exponential_of(-1.0 * (power(m, 0.5) + 1) * u); },
          "contact.cohesion.finite: opening = ");
}

TEST(CohesionFormula, StiffnessIsTheSlopeAboveZero) {
  // max(0, K u (1 − u)) has a corner at u = 0.
  const auto law = made([](const Term& u, const Term&) {
    const Term rise = stiff * u * (u.constant(1) - u);
    return 0.5 * (rise + absolute(rise));
  });
  EXPECT_DOUBLE_EQ(law->stiffness, stiff);
  EXPECT_NEAR(law->left(0.25, 0).value, 0.75, 1e-15);
  EXPECT_NEAR(law->rest(0, 0), stiff / 6, 1e-9 * stiff);
}

TEST(CohesionFormula, FacesWithALawByFormulaAreThoseOfTheLaw) {
  for (const auto& [formula, own] : {std::pair{&smooth_unmixed, exponential}, std::pair{&linear_unmixed, bilinear}}) {
    Random random(3), again(3);
    Bonded<2> one(strip("N2"), "south", ground(5), "north", with(law(formula), 0.3)),
        other(strip("N2"), "south", ground(5), "north", with(own, 0.3));
    for (const Vec<2>& move : {Vec<2>(0, 0.006), Vec<2>(0.01, 0.02), Vec<2>(0, -0.015), Vec<2>(0.02, -0.03)}) {
      const Dense a = one.move_die(move).shake(random, 4e-4).evaluate().dense();
      const Dense b = other.move_die(move).shake(again, 4e-4).evaluate().dense();
      EXPECT_LE((a.force - b.force).norm(), 1e-12 * b.force.norm());
      EXPECT_LE((a.tangent - b.tangent).norm(), 1e-11 * b.tangent.norm());
      one.pair.accept();
      other.pair.accept();
    }
    EXPECT_NEAR(one.pair.history().debonding, other.pair.history().debonding, 1e-12);
    EXPECT_FALSE(one.pair.formulation().has_potential());
    EXPECT_TRUE(
        Bonded<2>(strip("N2"), "south", ground(5), "north", with(law(formula))).pair.formulation().has_potential());
  }
  EXPECT_FALSE(
      Bonded<2>(strip("N2"), "south", ground(5), "north", with(law(&smooth))).pair.formulation().has_potential());
}

TEST(CohesionFormula, TangentIsTheForcesDerivativeInThePlane) {
  Census census;
  unsigned seed = 1;
  for (const Cohesion& cohesion : {law(&smooth), law(&linear, 1.4), law(&smooth_unmixed, 0.7)})
    for (const bool revolved : {false, true}) {
      const double mu = revolved ? 0.3 : 0;
      std::vector<Bonded<2>> couples;
      couples.emplace_back(strip("N2"), "south", ground(5), "north", with(cohesion, mu), revolved);
      couples.emplace_back(strip("N3"), "south", make_plane<2>({0, 0}, {0, 1}), with(cohesion), revolved);
      couples.emplace_back(ring(0.5, 1, 6, "south"), "south", ring(1, 1.4, 5, "north"), "north", with(cohesion),
                           revolved);
      for (auto& couple : couples) move_and_compare(couple, seed++, false, census);
    }
  census.expect({.states = 60, .open = 50, .stick = 300, .slip = 20, .bonded = 300, .opening = 300, .elsewhere = 5});
}

TEST(CohesionFormula, TangentIsTheForcesDerivativeInSpace) {
  Census census;
  unsigned seed = 21;
  for (const double mu : {0.0, 0.3}) {
    std::vector<Bonded<3>> couples;
    couples.emplace_back(block(0, 0, {2, 2, 1}, "front"), "front", block(-0.5, 0.2, {3, 2, 1}, "back"), "back",
                         with(law(&smooth, 1.3), mu));
    couples.emplace_back(block(0, 0, {2, 1, 1}, "front"), "front", make_plane<3>({0, 0, 0}, {0, 0, 1}),
                         with(law(&linear), mu));
    for (auto& couple : couples) move_and_compare(couple, seed++, false, census);
  }
  census.expect({.states = 18, .stick = 100, .slip = 20, .bonded = 100});
}

/// Complete separation of faces takes G(m) per area along every direction, by the work of the forces too; shear is b
/// times as strong, and pressure changes nothing.
TEST(CohesionFormula, FacesTakeTheEnergyOfTheMixture) {
  for (const double b : {1.0, 1.5})
    for (const Formula formula : {&smooth, &linear})
      for (const double angle : {90.0, 50.0, 0.0}) {
        const Cohesion cohesion = law(formula, b);
        Bonded<2> couple(strip("N2"), "south", make_plane<2>({0, 0}, {0, 1}), with(cohesion));
        const double turn = angle * std::numbers::pi / 180, c = b * std::cos(turn), s = std::sin(turn);
        const double m = c * c / (c * c + s * s), far = formula == &smooth ? 60 * strongest_opening(cohesion) : 0.13,
                     last = far / std::hypot(c, s);
        const Vec<2> way(std::cos(turn), std::sin(turn)), pressed(0, angle == 0 ? -0.002 : 0);
        constexpr int steps = 300;
        double work = 0, most = 0;
        for (int step = 1; step <= steps; ++step) {
          couple.place_die(pressed + last * step / steps * way);
          const double force = -couple.pair.resultant().force.dot(way);
          most = std::max(most, force);
          work += force * last / steps * (step % 2 == 1 ? 4 : 2) / 3;
          couple.pair.accept();
        }
        EXPECT_NEAR(couple.pair.history().debonding, 3 * energy_at(m), 1e-10) << angle;
        EXPECT_NEAR(work, 3 * energy_at(m), 5e-3 * 3 * energy_at(m)) << angle;
        const ContactPoints<2>& points = couple.pair.formulation().points();
        EXPECT_NEAR(couple.pair.formulation().bonds()->debonded(points, couple.pair.history()), 3, 1e-10);
        for (const PointBond<2>& bond : couple.pair.history().bonds) EXPECT_NEAR(mix(bond), m, 1e-9);
        if (angle == 0) {
          EXPECT_NEAR(most, 3 * b * cohesion.formula->peak(1).traction, 1e-2 * most);
        }
      }
}

TEST(CohesionFormula, ForcesBalanceAndMomentsWithEqualWeights) {
  Bonded<2> couple(ring(0.5, 1, 6, "south"), "south", ring(1, 1.4, 5, "north"), "north", with(law(&smooth)));
  Random random(5);
  for (const double lift : {0.02, -0.01}) {
    couple.move_die({0.01, lift}).shake(random, 1e-3);
    expect_balanced(couple, 0, 1e-12);
  }
}

} // namespace cohesion_formula_test
} // namespace signorini::contact
