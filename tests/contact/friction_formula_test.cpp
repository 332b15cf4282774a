// Coefficients of friction that are formulas: the equation of slip, its derivatives at a point and in every
// formulation, dissipation.
#include "contact/couple3d.hpp"
#include "contact/law/slide.hpp"
#include "contact/local_cases.hpp"
#include "contact/mortar_discs.hpp"
#include "contact/terms.hpp"

#include <cmath>

namespace signorini::contact {
namespace friction_formula_test {

using namespace test;

using Formula = Term (*)(const Term& p, const Term& v, const Term& slip, const Term& x, const Term& recent);

InterfaceLaw with(Formula formula, double normal = 100, double tangential = 80) {
  const auto graph = std::make_shared<symbolic::Graph>(slip_variables());
  const auto variable = [&](int number) { return Term{graph, graph->variable(number)}; };
  const Term mu = formula(variable(0), variable(1), variable(2), variable(3), variable(6));
  InterfaceLaw law{normal, tangential, 1};
  law.frictional = true;
  law.coefficient = make_slip_formula({*graph, mu.node});
  return law;
}

/// Of the pressure, the rate, the slip, the place, the slip since sticking, and of all.
const Formula formulas[] = {
    [](const Term& p, const Term&, const Term&, const Term&, const Term&) { return 0.4 * power(p + 1, -0.5) + 0.1; },
    [](const Term&, const Term& v, const Term&, const Term&, const Term&) { return 0.2 * power(v + 0.5, 0.5) + 0.1; },
    [](const Term&, const Term&, const Term& slip, const Term&, const Term&) {
      return 0.2 * power(10 * slip + 1, -1) + 0.1;
    },
    [](const Term&, const Term&, const Term&, const Term& x, const Term&) { return 0.1 * x + 0.1; },
    [](const Term&, const Term&, const Term&, const Term&, const Term& recent) {
      return 0.2 * power(5 * recent + 1, -1) + 0.15;
    },
    [](const Term& p, const Term& v, const Term& slip, const Term& x, const Term& recent) {
      return 0.3 * power(p + 1, -0.5) + 0.02 * v + 0.1 * slip + 0.05 * x - 0.05 * recent;
    },
};
constexpr double duration = 0.3;

template <int N> void slides() {
  Random random(N);
  int stuck = 0, slid = 0;
  for (const Formula formula : formulas)
    for (int trial = 0; trial < 60; ++trial) {
      const InterfaceLaw law = with(formula);
      const Interface at{duration,
                         uniform(random, 0, 0.5),
                         uniform(random, 0, 0.1),
                         {uniform(random, 0, 2), uniform(random, 0, 2), 0}};
      const double pressure = uniform(random, 0.5, 5);
      const Vec<N> start = random_vector<N>(random, trial % 3 == 0 ? 0.1 : 3);
      const auto slide_at = [&](const Vec<N>& t, double p) {
        return slide<N>(law, t, p, FixedContactState::free, 0, at);
      };
      const Slide<N> found = slide_at(start, pressure);
      EXPECT_EQ(found.flaw, FrictionFlaw::none);
      if (found.state == ContactState::stick) {
        ++stuck;
        EXPECT_EQ(found.friction, start);
        EXPECT_LE(start.norm(), pressure * (*law.coefficient)(pressure, 0, at).value);
        continue;
      }
      ++slid;
      // |t*| − ε_T Δγ = p μ(p, Δγ/Δt, γ + Δγ, X), along the trial
      const double mu = (*law.coefficient)(pressure, found.slipped, at).value;
      EXPECT_GT(found.slipped, 0);
      EXPECT_NEAR(found.friction.norm(), pressure * mu, 1e-13 * start.norm());
      EXPECT_NEAR(start.norm() - law.tangential * found.slipped, pressure * mu, 1e-13 * start.norm());
      EXPECT_NEAR(found.friction.dot(start), found.friction.norm() * start.norm(), 1e-13 * start.squaredNorm());
      for (int k = 0; k <= N; ++k) {
        const Vec<N> along = k < N ? Vec<N>(Vec<N>::Unit(k)) : Vec<N>(Vec<N>::Zero());
        const double dp = k < N ? 0 : 1;
        const Vec<N> slope = signorini::test::derivative<Vec<N>>(
            [&](double h) { return slide_at(start + h * along, pressure + h * dp).friction; }, 1e-4);
        const Vec<N> own = found.of_trial * along + dp * found.of_pressure * found.direction;
        EXPECT_LE((slope - own).norm(), 1e-8);
      }
    }
  EXPECT_GT(stuck, 30);
  EXPECT_GT(slid, 150);
}

TEST(SlipFormula, SlipSatisfiesItsEquationAndDerivativesAreThoseOfDifferences) {
  slides<1>();
  slides<2>();
  slides<3>();
}

/// A law that falls faster than the spring can follow is reported, and the friction is still on the cone.
TEST(SlipFormula, AJumpIsReported) {
  const InterfaceLaw law = with([](const Term&, const Term&, const Term& slip, const Term&, const Term&) {
    return 0.4 * power(1000 * slip + 1, -1) + 0.1;
  });
  const Interface at{};
  const Slide<1> found = slide<1>(law, Vec<1>(2.55), 5, FixedContactState::free, 0, at);
  EXPECT_EQ(found.state, ContactState::slip);
  EXPECT_EQ(found.flaw, FrictionFlaw::jumps);
  EXPECT_NEAR(found.friction(0), 5 * (*law.coefficient)(5, found.slipped, at).value, 1e-12);
  const InterfaceLaw below =
      with([](const Term& p, const Term&, const Term&, const Term&, const Term&) { return p.constant(0.1) - 0.1 * p; });
  const Slide<1> smooth = slide<1>(below, Vec<1>(2.55), 5, FixedContactState::free, 0, at);
  EXPECT_EQ(smooth.flaw, FrictionFlaw::negative);
  EXPECT_EQ(smooth.friction(0), 0);
}

/// Work of the friction less the energy of its spring along random paths with reversals
TEST(SlipFormula, DissipatesAlongRandomPaths) {
  Random random(8);
  for (int path = 0; path < 10000; ++path) {
    const InterfaceLaw law = with(formulas[path % std::ssize(formulas)]);
    Interface at{duration};
    Vec<2> elastic = Vec<2>::Zero();
    for (int step = 0; step < 5; ++step) {
      const Vec<2> move = random_vector<2>(random, 0.05);
      const Vec<2> trial = law.tangential * (elastic + move);
      const Slide<2> found = slide<2>(law, trial, uniform(random, 0.5, 5), FixedContactState::free, 0, at);
      const Vec<2> now = found.friction / law.tangential;
      const double stored = 0.5 * law.tangential * (now.squaredNorm() - elastic.squaredNorm());
      ASSERT_GE(found.friction.dot(move) - stored, -1e-15);
      elastic = now;
      at.slipped += found.slipped;
      at.recent = found.state == ContactState::slip ? at.recent + found.slipped : 0;
    }
  }
}

TEST(SlipFormula, TangentIsTheForcesDerivativeInThePlane) {
  Census sum;
  unsigned seed = 0;
  for (const Formula formula : formulas) sum.add(press_by_law(with(formula), duration, seed));
  sum.expect({.states = 150, .stick = 1000, .slip = 1000});
}

TEST(SlipFormula, TangentIsTheResidualsDerivativeWithMultipliers) {
  Census sum;
  unsigned seed = 0;
  for (const Formula formula : formulas) sum.add(slide_by_law(with(formula), duration, seed));
  sum.expect({.states = 18, .stick = 50, .slip = 100});
}

TEST(SlipFormula, TangentIsTheForcesDerivativeOfSolids) {
  Random random(3);
  Census census;
  for (const Formula formula : formulas)
    for (const Law& any : {Law(with(formula)), Law(with(formula), MultiplierSpace::equal)}) {
      Couple3 couple("N2", wavy_plate(random, 3, 0.02, 2, 4), any, {1.4, 1.5, 0.1}, 5);
      couple.pair.take(duration);
      couple.shake(random, 0.003).touch().move_die({0, 0, -0.08}).shake(random, 0.001);
      compare_with_differences(couple, random, census);
      couple.pair.accept();
      drag_and_compare(couple, random, {{3e-4, 1e-4, 0}, {0.02, 0.03, 0}, {-0.03, 0.02, 0}}, census);
    }
  census.expect({.states = 40, .stick = 100, .slip = 100});
}

} // namespace friction_formula_test
} // namespace signorini::contact
