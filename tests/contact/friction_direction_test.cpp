// Friction that depends on the direction of sliding: ellipses and formulas of the cosine, at a point and in every
// formulation.
#include "contact/couple3d.hpp"
#include "contact/local_cases.hpp"
#include "contact/mortar_discs.hpp"
#include "contact/terms.hpp"

#include "messages.hpp"

#include <cmath>

namespace signorini::contact {
namespace friction_direction_test {

using namespace test;

const Vec<3> along(0.9, 0.4, 0.1);

InterfaceLaw elliptic(double mu_1 = 0.4, double mu_2 = 0.15) {
  InterfaceLaw law{100, 80, std::max(mu_1, mu_2)};
  law.frictional = true;
  law.along = along;
  law.ellipse = Vec<2>(mu_1, mu_2);
  return law;
}

/// μ falls with the slip, and has another value forward than backward and across.
InterfaceLaw directed(double weakening = 0.05) {
  const auto graph = std::make_shared<symbolic::Graph>(slip_variables());
  const Term slip{graph, graph->variable(2)}, c{graph, graph->variable(7)};
  const Term mu = 0.1 * c + 0.08 * (c * c) + weakening * power(10 * slip + 1, -1) + 0.2;
  InterfaceLaw law{100, 80, 1};
  law.frictional = true;
  law.along = along;
  law.coefficient = make_slip_formula({*graph, mu.node});
  return law;
}

template <int N> Slide<N> slide_at(const InterfaceLaw& law, const Vec<N>& trial, double pressure) {
  return slide<N>(law, trial, pressure, FixedContactState::free, 0, {});
}

template <int N> void compare_derivatives(const InterfaceLaw& law, const Vec<N>& trial, double pressure) {
  const Slide<N> found = slide_at<N>(law, trial, pressure);
  for (int k = 0; k <= N; ++k) {
    const Vec<N> by = k < N ? Vec<N>(Vec<N>::Unit(k)) : Vec<N>(Vec<N>::Zero());
    const double dp = k < N ? 0 : 1;
    const Vec<N> slope = signorini::test::derivative<Vec<N>>(
        [&](double h) { return slide_at<N>(law, Vec<N>(trial + h * by), pressure + h * dp).friction; },
        1e-4 * trial.norm());
    const Vec<N> own = found.of_trial * by + dp * found.of_pressure * found.direction;
    EXPECT_LE((slope - own).norm(), 1e-8);
  }
}

// ── The return mapping ───────────────────────────────────────────────────────────────────────────────────────────────

TEST(FrictionDirection, ATrialGoesToTheClosestPointOfTheEllipse) {
  Random random(1);
  int stuck = 0, slid = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const InterfaceLaw law = elliptic(uniform(random, 0.02, 1), uniform(random, 0.02, 1));
    const Vec<2>& mu = *law.ellipse;
    const double pressure = uniform(random, 0.5, 5);
    Vec<2> start = random_vector<2>(random, trial % 3 == 0 ? 0.3 : 5);
    if (trial % 4 == 0) start *= 1.01 * pressure / start.cwiseQuotient(mu).norm(); // the onset of slip
    if (trial % 40 == 1) start(0) = 0;                                             // on an axis
    const Slide<2> found = slide_at<2>(law, start, pressure);
    const double size = found.friction.cwiseQuotient(mu).norm();
    if (found.state == ContactState::stick) {
      ++stuck;
      EXPECT_EQ(found.friction, start);
      EXPECT_LE(size, pressure * (1 + 1e-14));
      continue;
    }
    ++slid;
    EXPECT_NEAR(size, pressure, 1e-13 * pressure);
    // The slip t* − t is along the normal (t_i/μ_i²), outward.
    const Vec<2> slip = start - found.friction, normal = found.friction.cwiseQuotient(mu.cwiseAbs2());
    EXPECT_NEAR(slip(0) * normal(1) - slip(1) * normal(0), 0, 1e-12 * start.norm() * normal.norm());
    EXPECT_GT(slip.dot(normal), 0);
    EXPECT_NEAR(found.slipped, slip.norm() / law.tangential, 1e-15);
    EXPECT_NEAR(found.mu * pressure * slip.norm(), found.friction.dot(slip), 1e-11 * pressure * slip.norm());
    compare_derivatives<2>(law, start, pressure);
  }
  EXPECT_GT(stuck, 50);
  EXPECT_GT(slid, 200);
}

/// A circle is the law without an axis, with the same bits of state and derivatives to rounding error.
TEST(FrictionDirection, ACircleIsCoulombsCone) {
  Random random(2);
  const InterfaceLaw circle = elliptic(0.3, 0.3), plain{100, 80, 0.3};
  for (int trial = 0; trial < 100; ++trial) {
    const Vec<2> start = random_vector<2>(random, 2);
    const Slide<2> one = slide_at<2>(circle, start, 2), other = slide_at<2>(plain, start, 2);
    ASSERT_EQ(one.state, other.state);
    EXPECT_LE((one.friction - other.friction).norm(), 1e-14);
    EXPECT_NEAR(one.mu, 0.3, 1e-15);
    if (one.state == ContactState::stick) continue;
    EXPECT_LE((one.of_trial - other.of_trial).norm(), 1e-14);
    EXPECT_LE((one.of_pressure * one.direction - other.of_pressure * other.direction).norm(), 1e-14);
    EXPECT_NEAR(one.slipped, other.slipped, 1e-15);
  }
}

/// t_i = p μ_i² d_i/√(μ_1² d_1² + μ_2² d_2²) once a slip along d is steady.
TEST(FrictionDirection, FrictionOfAPrescribedDirection) {
  const InterfaceLaw law = elliptic();
  const Vec<2>& mu = *law.ellipse;
  for (const double angle : {0.0, 0.3, 0.8, 1.5, 2.5, 4.0}) {
    const Vec<2> d(std::cos(angle), std::sin(angle));
    Vec<2> elastic = Vec<2>::Zero();
    for (int step = 0; step < 40; ++step)
      elastic = slide_at<2>(law, Vec<2>(law.tangential * (elastic + 0.05 * d)), 2).friction / law.tangential;
    const Vec<2> exact = 2 * mu.cwiseAbs2().cwiseProduct(d) / mu.cwiseProduct(d).norm();
    EXPECT_LE((law.tangential * elastic - exact).norm(), 1e-10);
  }
}

template <int N> void cosines() {
  Random random(N);
  int slid = 0;
  const InterfaceLaw law = directed();
  for (int trial = 0; trial < 200; ++trial) {
    const double pressure = uniform(random, 0.5, 5);
    const Vec<N> start = random_vector<N>(random, 3);
    const Slide<N> found = slide_at<N>(law, start, pressure);
    const double c = start(0) / start.norm(), mu = 0.1 * c + 0.08 * c * c + 0.2;
    if (found.state == ContactState::stick) {
      EXPECT_LE(start.norm(), pressure * (mu + 0.05));
      continue;
    }
    ++slid;
    EXPECT_NEAR(found.friction.norm(), pressure * (mu + 0.05 / (10 * found.slipped + 1)), 1e-13 * start.norm());
    EXPECT_NEAR(found.friction.dot(start), found.friction.norm() * start.norm(), 1e-13 * start.squaredNorm());
    compare_derivatives<N>(law, start, pressure);
  }
  EXPECT_GT(slid, 80);
}

TEST(FrictionDirection, AFormulaSeesTheCosineOfTheSlip) {
  cosines<1>();
  cosines<2>();
}

TEST(FrictionDirection, DissipatesAlongRandomPaths) {
  Random random(8);
  for (int path = 0; path < 10000; ++path) {
    const InterfaceLaw law = path % 2 == 0 ? elliptic(uniform(random, 0.02, 1), uniform(random, 0.02, 1)) : directed();
    Vec<2> elastic = Vec<2>::Zero();
    for (int step = 0; step < 5; ++step) {
      const Vec<2> move = random_vector<2>(random, 0.05);
      const Slide<2> found = slide_at<2>(law, Vec<2>(law.tangential * (elastic + move)), uniform(random, 0.5, 5));
      const Vec<2> now = found.friction / law.tangential;
      const double stored = 0.5 * law.tangential * (now.squaredNorm() - elastic.squaredNorm());
      ASSERT_GE(found.friction.dot(move) - stored, -1e-15);
      elastic = now;
    }
  }
}

// ── Tangents ─────────────────────────────────────────────────────────────────────────────────────────────────────────

template <int D> void local_tangents(const InterfaceLaw& law, Foot foot, double reach, ContactState state) {
  Random random(static_cast<unsigned>(D));
  for (int trial = 0; trial < 20; ++trial) {
    const Variables<D> q = random_variables<D>(random, foot, -0.05, reach);
    Situation<D> situation{random_curvature<D>(random), foot, true};
    situation.axis = random_vector<D - 1>(random, 1);
    EXPECT_EQ(evaluate<D>(law, q, situation).force.state, state);
    compare_with_differences<D>(law, q, situation, 1e-4);
  }
}

TEST(FrictionDirection, TangentAtAPoint) {
  for (const Foot foot : {Foot::regular, Foot::corner})
    for (const bool slips : {false, true}) {
      const double reach = slips ? 0.3 : 0.003;
      const ContactState state = slips ? ContactState::slip : ContactState::stick;
      local_tangents<2>(directed(), foot, reach, state);
      local_tangents<3>(directed(), foot, reach, state);
      local_tangents<3>(elliptic(), foot, reach, state);
    }
}

Law solved(const InterfaceLaw& own) {
  Law law(own, MultiplierSpace::equal);
  law.law.enforcement = Enforcement::multipliers;
  return law;
}

TEST(FrictionDirection, TangentIsTheForcesDerivativeInThePlane) {
  unsigned seed = 0;
  Census sum = press_by_law(directed(), 0, seed);
  sum.add(slide_by_law(directed(), 0, seed));
  sum.expect({.states = 28, .stick = 180, .slip = 180});
}

TEST(FrictionDirection, TangentIsTheForcesDerivativeOfSolids) {
  Random random(3);
  Census census;
  for (const InterfaceLaw& law : {elliptic(), directed()})
    for (const Law& any : {Law(law), Law(law, {}, Pass::half), Law(law, MultiplierSpace::equal), solved(law)}) {
      Couple3 couple("N2", wavy_plate(random, 3, 0.02, 2, 4), any, {1.4, 1.5, 0.1}, 5);
      const bool unknown = any.law.enforcement == Enforcement::multipliers;
      couple.shake(random, 0.003).touch().move_die({0, 0, -0.08}).shake(random, 0.001);
      if (unknown) set_multipliers(couple, random, 3, 0.3);
      compare_with_differences(couple, random, census);
      couple.pair.accept();
      for (const Vec<3>& drag : {Vec<3>(3e-4, 1e-4, 0), Vec<3>(0.02, 0.03, 0), Vec<3>(-0.03, 0.02, 0)}) {
        couple.move_die(drag).shake(random, 0.0003);
        if (unknown) set_multipliers(couple, random, 3, 0.3);
        compare_with_differences(couple, random, census);
        couple.pair.accept();
      }
    }
  census.expect({.states = 24, .stick = 80, .slip = 80});
}

// ── Axes and history ─────────────────────────────────────────────────────────────────────────────────────────────────

/// Presses and drags a body over a plane, turned by 90° first if asked: what it feels turns with it.
template <class AnyLaw> Vec<3> dragged(const AnyLaw& law, bool turned) {
  Couple3 couple("N2", make_plane<3>({0, 0, 0}, {0, 0, 1}), law, {0, 0, 0.01});
  const auto place = [&](const Vec<3>& by) { return turned ? Vec<3>(-by(1), by(0), by(2)) : by; };
  if (turned) couple.turn_die(std::acos(-1) / 2, {0, 0, 0});
  couple.evaluate().accept().move_die({0, 0, -0.06}).evaluate().accept();
  for (int step = 0; step < 4; ++step) couple.move_die(place({0.02, 0.01, 0})).evaluate().accept();
  return couple.pair.resultant().force;
}

TEST(FrictionDirection, AxesTurnWithTheSlave) {
  for (const InterfaceLaw& law : {elliptic(), directed()})
    for (const Law& any : {Law(law), Law(law, MultiplierSpace::equal)}) {
      const Vec<3> straight = dragged(any, false), turned = dragged(any, true);
      EXPECT_GT(straight.head<2>().norm(), 0.05 * straight(2));
      EXPECT_LE((turned - Vec<3>(-straight(1), straight(0), straight(2))).norm(), 1e-12 * straight.norm());
      EXPECT_GT((turned.head<2>() - straight.head<2>()).norm(), 0.1 * straight.head<2>().norm());
    }
}

/// On a curved master the slip point of an accepted step keeps the friction, but for the change of the axes.
TEST(FrictionDirection, AcceptedFrictionStays) {
  Random random(9);
  for (const InterfaceLaw& law : {elliptic(), directed(0)}) {
    Couple3 couple("N2", wavy_plate(random, 3, 0.02, 2, 4), law, {1.4, 1.5, 0.1}, 5);
    couple.touch().move_die({0, 0, -0.08}).evaluate().accept().move_die({0.02, 0.03, 0}).evaluate();
    const auto before = couple.pair.results();
    couple.accept().evaluate();
    int slid = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
      if (before[i].state != ContactState::slip) continue;
      ++slid;
      EXPECT_LE((couple.pair.results()[i].friction - before[i].friction).norm(), 1e-9 * before[i].friction.norm());
      EXPECT_GT(couple.pair.history().points[i].slipped, 0);
    }
    EXPECT_GT(slid, 20);
    EXPECT_GT(couple.pair.dissipated(), 0);
  }
}

TEST(FrictionDirection, WrongLawsAreRefused) {
  const auto expect = [](const InterfaceLaw& law, const std::string& code) {
    const std::string message = signorini::test::message_of([&] { check(law); });
    EXPECT_TRUE(signorini::test::holds(message, {"contact.friction." + code}));
  };
  InterfaceLaw law = elliptic();
  law.along.reset();
  expect(law, "no_axis");
  law = directed();
  law.along.reset();
  expect(law, "no_axis");
  law = {100, 80, 0.3};
  law.along = along;
  expect(law, "idle_axis");
  law = elliptic();
  law.along = Vec<3>::Zero();
  expect(law, "zero_axis");
  expect(elliptic(0.3, 0), "ellipse");
}

} // namespace friction_direction_test
} // namespace signorini::contact
