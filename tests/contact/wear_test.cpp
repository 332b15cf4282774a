// Wear: the two equations of a step at a point, their derivatives there and in every formulation, and stability.
#include "contact/law/wear.hpp"

#include "contact/couple3d.hpp"
#include "contact/local_cases.hpp"
#include "contact/mortar_discs.hpp"
#include "contact/terms.hpp"

#include <cmath>
#include <numbers>

namespace signorini::contact {
namespace wear_test {

using namespace test;

using Formula = Term (*)(const Term& p, const Term& v, const Term& slip);

std::shared_ptr<const SlipFormula> formula_of(Formula formula) {
  const auto graph = std::make_shared<symbolic::Graph>(slip_variables());
  const auto variable = [&](int number) { return Term{graph, graph->variable(number)}; };
  const Term result = formula(variable(0), variable(1), variable(2));
  return make_slip_formula({*graph, result.node});
}
Term number(const Term& p, const Term&, const Term&) {
  return p.constant(0.05);
}
Term formula(const Term& p, const Term& v, const Term& slip) {
  return 0.03 * power(p + 1, -0.5) + 0.02 * power(v + 0.5, 0.5) + 0.02 * power(10 * slip + 1, -1);
}
Term mu_formula(const Term& p, const Term&, const Term& slip) {
  return 0.3 * power(p + 1, -0.5) + 0.1 * power(10 * slip + 1, -1);
}

constexpr double duration = 0.3, normal = 100, tangential = 80;

/// Wear by a number or a formula, without friction, with a number and with a formula of it.
std::vector<InterfaceLaw> laws() {
  std::vector<InterfaceLaw> list;
  for (const Formula rate : {&number, &formula})
    for (const double mu : {0.0, 0.3, 1.0}) {
      InterfaceLaw law{normal, tangential, mu};
      if (mu == 1) law.coefficient = formula_of(mu_formula);
      law.wear = {formula_of(rate)};
      list.push_back(std::move(law));
    }
  return list;
}

/// Wear with friction that depends on the direction: in the plane by its sign, in space also on an ellipse.
std::vector<InterfaceLaw> directed(int dimension) {
  const auto graph = std::make_shared<symbolic::Graph>(slip_variables());
  const Term cosine{graph, graph->variable(7)};
  InterfaceLaw formula{normal, tangential, 1};
  const Term mu = 0.1 * cosine + 0.3;
  formula.coefficient = make_slip_formula({*graph, mu.node});
  InterfaceLaw ellipse{normal, tangential, 0.4};
  ellipse.ellipse = Vec<2>(0.2, 0.4);
  std::vector<InterfaceLaw> list{formula};
  if (dimension == 3) list.push_back(ellipse);
  for (InterfaceLaw& law : list) {
    law.along = Vec<3>(1, dimension == 3 ? 0.3 : 0, 0);
    law.wear = {formula_of(number)};
  }
  return list;
}

std::vector<InterfaceLaw> joined(std::vector<InterfaceLaw> one, const std::vector<InterfaceLaw>& other) {
  one.insert(one.end(), other.begin(), other.end());
  return one;
}

template <int N> void wears() {
  Random random(N);
  int worn = 0;
  for (const InterfaceLaw& law : laws())
    for (int trial = 0; trial < 60; ++trial) {
      const Interface at{duration, uniform(random, 0, 0.5), uniform(random, 0, 0.1)};
      const double gap = uniform(random, -0.05, -0.005), held = trial % 2 ? uniform(random, 0, 2) : 0;
      const Vec<N> start = random_vector<N>(random, 3);
      const auto rub_at = [&](double g, double part, const Vec<N>& t) {
        GapResponse unworn = respond(law, g, at);
        unworn.pressure += part;
        return rub<N>(law, unworn, g, t, FixedContactState::free, 0, at);
      };
      const Rubbing<N> found = rub_at(gap, held, start);
      const double p = found.response.pressure;
      if (found.worn == 0) {
        EXPECT_EQ(found.slide.state, ContactState::stick);
        continue;
      }
      ++worn;
      // p = p₀ + f(g + k p Δγ),  |t*| − ε_T Δγ = p μ(p, Δγ)
      const double slipped = found.slide.slipped, k = (*law.wear->rate)(p, slipped, at).value;
      const double scale = held - normal * gap + start.norm();
      EXPECT_GT(p, 0);
      EXPECT_NEAR(found.worn, k * p * slipped, 1e-15);
      EXPECT_NEAR(p, held - normal * (gap + found.worn), 1e-13 * scale);
      EXPECT_NEAR(start.norm() - tangential * slipped, p * coefficient(law, p, slipped, at).value, 1e-13 * scale);
      for (int i = 0; i < N + 2; ++i) {
        const Vec<N> along = i < N ? Vec<N>(Vec<N>::Unit(i)) : Vec<N>(Vec<N>::Zero());
        const double dg = i == N, dp = i == N + 1;
        const auto moved = [&](double h) { return rub_at(gap + h * dg, held + h * dp, start + h * along); };
        const double slope =
            signorini::test::derivative<double>([&](double h) { return moved(h).response.pressure; }, 1e-5);
        const double own = found.response.rate * dg + found.of_held * dp + found.of_trial.dot(along);
        EXPECT_NEAR(slope, own, 1e-7 * (1 + std::abs(slope)));
        const Vec<N> by = signorini::test::derivative<Vec<N>>([&](double h) { return moved(h).slide.friction; }, 1e-5);
        const Vec<N> friction = found.slide.of_trial * along + own * found.slide.of_pressure * found.slide.direction;
        EXPECT_LE((by - friction).norm(), 1e-7 * (1 + by.norm()));
      }
    }
  EXPECT_GT(worn, 200);
}

TEST(Wear, SatisfiesItsEquationsAndDerivativesAreThoseOfDifferences) {
  wears<1>();
  wears<2>();
  wears<3>();
}

/// A block between fixed walls whose spring K loses pressure as it wears: backward Euler p_n = p_{n−1}/(1 + k K Δγ), of
/// order 1 to p₀ exp(−k K s), at any slip of a step; the explicit update p_n = p_{n−1} (1 − k K Δγ) diverges above
/// k K Δγ = 2.
TEST(Wear, OfAHeldBlockIsStableWithinTheStepOnly) {
  InterfaceLaw law{normal, tangential};
  law.wear = {formula_of(number)};
  const double k = 0.05, gap = -0.02, way = 0.4;
  const auto pressure_after = [&](WearUpdate update, double length, int steps) {
    law.wear->update = update;
    double worn = 0, pressure = 0;
    for (int step = 0; step < steps; ++step) {
      const double g = gap + worn;
      if (g >= 0) return 0.0; // open
      const Rubbing<1> found =
          rub<1>(law, respond(law, g, {}), g, Vec<1>(tangential * length / steps), FixedContactState::free, 0, {});
      worn += found.worn;
      pressure = -normal * (gap + worn);
    }
    return pressure;
  };
  const double exact = -normal * gap * std::exp(-k * normal * way);
  double before = 0;
  for (const int steps : {20, 40, 80}) {
    const double error = pressure_after(WearUpdate::within, way, steps) / exact - 1;
    EXPECT_NEAR(pressure_after(WearUpdate::within, way, steps),
                -normal * gap * std::pow(1 + k * normal * way / steps, -steps), 1e-14);
    if (before > 0) {
      EXPECT_NEAR(before / error, 2, 0.1);
    }
    before = error;
  }
  const double longer = 2.5 * 10 / (k * normal); // ten steps with k K Δγ = 2.5
  EXPECT_NEAR(pressure_after(WearUpdate::within, longer, 10), -normal * gap * std::pow(3.5, -10), 1e-15);
  EXPECT_LT(pressure_after(WearUpdate::after, longer, 1), normal * gap); // beyond the other side
}

/// As press_and_drag, with a face that has worn before.
Census wear_and_drag(Couple couple, unsigned seed) {
  Random random(seed);
  Census census;
  couple.pair.take(duration);
  couple.shake(random, 0.005).touch().move_die(0, -0.06).evaluate();
  for (const double way : {0.05, 0.1}) {
    couple.pair.accept();
    couple.move_die(way, -0.005).shake(random, 0.002).evaluate();
  }
  couple.pair.accept();
  for (const double way : {0.02, 0.1, -0.05}) {
    couple.move_die(way, 0).shake(random, 0.0005);
    compare_with_differences(couple, census);
  }
  return census;
}

TEST(Wear, TangentIsTheForcesDerivativeWhereFacesHaveWorn) {
  Census sum;
  unsigned seed = 0;
  for (const InterfaceLaw& law : laws()) {
    sum.add(wear_and_drag(Couple("N2-N2.1", slab("N2"), law, 0.8, 1.0), ++seed));
    sum.add(wear_and_drag(pressed_disc("N2", slab("N2"), Law(law, MultiplierSpace::equal), 0.8, 1.0), ++seed));
  }
  sum.expect({.states = 20, .stick = 0, .slip = 100});
}

TEST(Wear, TangentIsTheForcesDerivativeInThePlane) {
  Census sum;
  unsigned seed = 0;
  for (const InterfaceLaw& law : joined(laws(), directed(2))) sum.add(press_by_law(law, duration, seed));
  sum.expect({.states = 150, .stick = 500, .slip = 1000});
}

TEST(Wear, TangentIsTheResidualsDerivativeWithMultipliers) {
  Census sum;
  unsigned seed = 0;
  for (const InterfaceLaw& law : joined(laws(), directed(2))) sum.add(slide_by_law(law, duration, seed));
  sum.expect({.states = 18, .stick = 30, .slip = 100});
}

TEST(Wear, TangentIsTheForcesDerivativeOfSolids) {
  Random random(3);
  Census census;
  for (const InterfaceLaw& law : joined(laws(), directed(3)))
    for (const Law& any : {Law(law), Law(law, MultiplierSpace::equal)}) {
      Couple3 couple("N2", wavy_plate(random, 3, 0.02, 2, 4), any, {1.4, 1.5, 0.1}, 5);
      couple.pair.take(duration);
      couple.shake(random, 0.003).touch().move_die({0, 0, -0.08}).shake(random, 0.001);
      compare_with_differences(couple, random, census);
      couple.pair.accept();
      drag_and_compare(couple, random, {{3e-4, 1e-4, 0}, {0.02, 0.03, 0}, {-0.03, 0.02, 0}}, census);
    }
  census.expect({.states = 40, .stick = 100, .slip = 100});
}

} // namespace wear_test
} // namespace signorini::contact
