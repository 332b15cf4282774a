// Pressures that are formulas of the gap: value, slope and energy at a point, tangents in every formulation, adhesion.
#include "contact/couple3d.hpp"
#include "contact/local_cases.hpp"
#include "contact/mortar_discs.hpp"
#include "contact/terms.hpp"

#include <cmath>
#include <limits>

namespace signorini::contact {
namespace pressure_formula_test {

using namespace test;

using Formula = Term (*)(const Term& g, const Term& x);
constexpr double everywhere = std::numeric_limits<double>::infinity();

Term larger(const Term& a, const Term& b) {
  return 0.5 * (a + b + absolute(a - b));
}

InterfaceLaw with(Formula formula, double clearance, double mu = 0, TractionArea per = TractionArea::current) {
  const auto graph = std::make_shared<symbolic::Graph>(pressure_variables());
  const Term p = formula({graph, graph->variable(0)}, {graph, graph->variable(1)});
  InterfaceLaw law{0, 80, mu, per};
  law.pressure = make_pressure_formula({*graph, p.node}, clearance);
  return law;
}

/// 1000 (0.03 − g)² and a layer whose stiffness depends on the place
Term squared(const Term& g, const Term&) {
  return 1000.0 * power(g - 0.03, 2);
}
Term layer(const Term& g, const Term& x) {
  return -1.0 * ((100.0 * (0.2 * x + 1)) * g);
}

const Adhesion film{0.02, 0.05};

/// T(r) of `film`, below its equilibrium distance along its tangent
Term attraction(const Term& g, const Term&) {
  const double nearest = equilibrium_distance(film),
               strength = traction(film, 1) / (std::pow(film.distance, 9) / 45 - std::pow(film.distance, 3) / 3);
  const Term r = larger(g, g.constant(nearest)), below = g - r;
  return strength * (std::pow(film.distance, 9) / 45 * power(r, -9) - std::pow(film.distance, 3) / 3 * power(r, -3)) +
         stiffness(film, nearest) * below;
}

TEST(PressureFormula, HasItsSlopeAndEnergy) {
  const InterfaceLaw law = with(squared, 0.03), uneven = with(layer, 0);
  EXPECT_EQ(reach(law), 0.03);
  for (double g : {0.029, 0.01, 0.0, -0.02, -0.1}) {
    const GapResponse found = respond(law, g, {});
    EXPECT_NEAR(found.pressure, 1000 * std::pow(0.03 - g, 2), 1e-12);
    EXPECT_NEAR(found.rate, -2000 * (0.03 - g), 1e-11);
    EXPECT_NEAR(energy(law, g, {}), 1000 * std::pow(0.03 - g, 3) / 3, 1e-13);
  }
  const Interface at{.place = {2, 0, 0}};
  EXPECT_NEAR(respond(uneven, -0.1, at).pressure, 14, 1e-13);
  EXPECT_NEAR(energy(uneven, -0.1, at.place), 0.7, 1e-13);
}

TEST(PressureFormula, OfAdhesionIsAdhesion) {
  const InterfaceLaw law = with(attraction, everywhere, 0, TractionArea::reference), own = adhesive(film);
  for (double g : {-0.02, 0.0, 0.02, 0.03, 0.04, 0.1, 0.5}) {
    const GapResponse found = respond(law, g, {}), expected = respond(own, g, {});
    const double largest = std::abs(traction(film, strongest_distance(film)));
    EXPECT_NEAR(found.pressure, expected.pressure, 1e-13 * std::max(largest, std::abs(expected.pressure)));
    EXPECT_NEAR(found.rate, expected.rate, 1e-12 * std::abs(stiffness(film, 0)));
    EXPECT_NEAR(energy(law, g, {}), energy(own, g, {}), 2e-3 * std::abs(potential(film, equilibrium_distance(film))));
  }
  // In a contact
  Random random(3);
  Couple formula("N2-N2.1", slab("N2"), law, 1.3, 1.02), built("N2-N2.1", slab("N2"), own, 1.3, 1.02);
  for (int step = 0; step < 4; ++step) {
    formula.move_die(0.01, -0.01);
    built.move_die(0.01, -0.01);
    const Dense one = formula.evaluate().dense(), other = built.evaluate().dense();
    EXPECT_LE((one.force - other.force).norm(), 1e-12 * other.force.norm());
    EXPECT_LE((one.tangent - other.tangent).norm(), 1e-12 * other.tangent.norm());
    EXPECT_TRUE(formula.pair.formulation().has_potential());
  }
}

TEST(PressureFormula, TangentIsTheForcesDerivativeInThePlane) {
  Census sum;
  unsigned seed = 0;
  for (const auto& [formula, clearance] : {std::pair{&squared, 0.03}, std::pair{&layer, 0.0}})
    for (const double mu : {0.0, 0.3}) sum.add(press_by_law(with(formula, clearance, mu), 0, seed));
  sum.expect({.states = 100, .stick = 500, .slip = 300});
}

TEST(PressureFormula, TangentIsTheForcesDerivativeOfSolids) {
  Random random(3);
  Census census;
  for (const double mu : {0.0, 0.3})
    for (const Law& any : {Law(with(squared, 0.03, mu)), Law(with(squared, 0.03, mu), MultiplierSpace::equal)}) {
      Couple3 couple("N2", wavy_plate(random, 3, 0.02, 2, 4), any, {1.4, 1.5, 0.1}, 5);
      couple.shake(random, 0.003).touch().move_die({0, 0, -0.08}).shake(random, 0.001);
      compare_with_differences(couple, random, census);
      couple.pair.accept();
      drag_and_compare(couple, random, {{3e-4, 1e-4, 0}, {0.02, 0.03, 0}, {-0.03, 0.02, 0}}, census);
    }
  census.expect({.states = 10, .stick = 20});
}

TEST(PressureFormula, MultipliersAreRefused) {
  InterfaceLaw law = with(layer, 0);
  law.enforcement = Enforcement::multipliers;
  EXPECT_ERROR(Couple("N2", slab("N2"), Law(law, MultiplierSpace::equal), 1, 1), "contact.enforcement.pressure");
}

} // namespace pressure_formula_test
} // namespace signorini::contact
