// Tractions per reference area: tangents against finite differences in every state, and without friction their
// symmetry; forces of stretched faces, multipliers, dissipation, and the energy of the springs.
#include "contact/couple.hpp"
#include "contact/couple3d.hpp"
#include "contact/local_cases.hpp"

#include <numbers>

namespace signorini::contact {
namespace reference_area_test {

using namespace test;

InterfaceLaw per_reference(double mu, double normal = 100, double tangential = 100) {
  return {normal, tangential, mu, TractionArea::reference};
}

// ── One point ────────────────────────────────────────────────────────────────────────────────────────────────────────

/// K of the variables xˢ, x̄ᵐ, τ_α at one point without friction, with F = t_N n̄ dA: rows −∂F, ∂F and F ∂ξ̄^α.
template <int D> MatrixX point_tangent(const LocalForce<D>& at) {
  using Force = LocalForce<D>;
  constexpr int used = D * (2 + Force::tangents); // without the slave's tangents and the slip point
  const auto kept = [used](const MatrixX& all) {
    MatrixX result(all.rows(), used);
    result << all.leftCols(D), all.middleCols(Force::master_column, D * (1 + Force::tangents));
    return result;
  };
  MatrixX sum(used, used);
  sum.topRows(D) = -kept(at.tangent);
  sum.middleRows(D, D) = kept(at.tangent);
  for (int a = 0; a < Force::tangents; ++a) sum.middleRows(D * (2 + a), D) = at.force * kept(at.shift.row(a));
  return sum;
}

template <int D> void tangent_at_a_point(Foot foot, double reach, double mu, bool revolved = false) {
  Random random(static_cast<unsigned>(D));
  const InterfaceLaw law = per_reference(mu, 100, 80);
  for (int trial = 0; trial < 40; ++trial) {
    const Variables<D> q = random_variables<D>(random, foot, -0.05, reach);
    const Situation<D> situation{random_curvature<D>(random), foot, reach > 0, revolved, uniform(random, 0.5, 2)};
    const LocalForce<D> at = evaluate<D>(law, q, situation).force;
    ASSERT_EQ(at.state, reach > 0.1 && mu > 0 ? ContactState::slip : ContactState::stick);
    EXPECT_EQ(at.measure, situation.reference_measure);
    compare_with_differences<D>(law, q, situation, 1e-4);
    if (mu > 0) continue;
    const MatrixX k = point_tangent(at);
    EXPECT_LE((k - k.transpose()).norm(), 1e-14 * k.norm());
    EXPECT_GT(k.norm(), 0);
  }
}

TEST(ReferenceArea, TangentAtAPoint) {
  for (Foot foot : {Foot::regular, Foot::corner}) {
    for (double reach : {0.0, 0.01, 0.3}) {
      tangent_at_a_point<2>(foot, reach, 0.3);
      tangent_at_a_point<2>(foot, reach, 0.3, true);
      tangent_at_a_point<3>(foot, reach, 0.3);
    }
    tangent_at_a_point<2>(foot, 0, 0);
    tangent_at_a_point<2>(foot, 0, 0, true);
    tangent_at_a_point<3>(foot, 0, 0);
  }
}

/// Per current area the same matrix is not symmetric: the test above can fail.
TEST(ReferenceArea, PerCurrentAreaATangentIsNotSymmetric) {
  Random random(1);
  const Variables<2> q = random_variables<2>(random, Foot::regular, -0.05, 0);
  const LocalForce<2> at = evaluate<2>(InterfaceLaw{100}, q, {random_curvature<2>(random)}).force;
  EXPECT_GT(at.tangent.middleCols<2>(LocalForce<2>::slave_tangent_column).norm(), 0.1);
}

// ── Faces ────────────────────────────────────────────────────────────────────────────────────────────────────────────

/// Whether the tangent is symmetric to rounding error.
template <class AnyCouple> bool is_symmetric(const AnyCouple& couple) {
  const MatrixX k = couple.dense().tangent;
  return (k - k.transpose()).norm() <= 1e-14 * k.norm();
}

/// As press_and_drag(), with the symmetry of frictionless tangents.
Census press_and_drag(Couple couple, unsigned seed, double depth, double mu) {
  Random random(seed);
  Census census;
  couple.shake(random, 0.005).touch().move_die(0, -depth).shake(random, 0.002).evaluate();
  for (double drag : {0.0, 3e-4, 0.02, 0.2}) {
    couple.move_die(drag, 0).shake(random, 0.0005);
    compare_with_differences(couple, census);
    if (mu == 0) {
      EXPECT_TRUE(is_symmetric(couple));
    }
    couple.pair.accept();
  }
  return census;
}

TEST(ReferenceArea, TangentInEveryState) {
  Census sum;
  unsigned seed = 300;
  Random random(3);
  for (double mu : {0.0, 0.3})
    for (int trial = 0; trial < 2; ++trial)
      for (bool revolved : {false, true}) {
        const InterfaceLaw law = per_reference(mu);
        sum.add(press_and_drag(Couple("N2-N2.1", slab("N2"), law, 1.3, 1.0, revolved), ++seed, 0.06, mu));
        // A wavy face with kinks, and a polyline whose kink is the foot point of many points
        sum.add(press_and_drag(Couple("N2", wavy(random, 3, 0.1, 3, 6), law, 1.3, 0.1, revolved), ++seed, 0.06, mu));
        sum.add(press_and_drag(Couple("N2", polyline({{0, 0.3}, {1.35, 0}, {3, 0.3}}), law, 1.3, 0.1, revolved), ++seed,
                               0.06, mu));
        sum.add(
            press_and_drag(Couple("N2", make_plane<2>({0, 0}, {0.2, 2}), law, 1.3, 0.1, revolved), ++seed, 0.06, mu));
        sum.add(press_and_drag(Couple("N2", make_ball<2>({1, -2}, 2), law, 1.3, 0.1, revolved), ++seed, 0.06, mu));
      }
  sum.expect({.states = 100, .open = 500, .stick = 200, .slip = 200});
}

TEST(ReferenceArea, TangentOfSolidsInEveryState) {
  Census sum;
  Random random(4);
  for (double mu : {0.0, 0.3}) {
    const InterfaceLaw law = per_reference(mu, 100, 80);
    std::vector<Couple3> couples;
    couples.emplace_back("N2", wavy_plate(random, 3, 0.02, 2, 4), law, Vec<3>(1.4, 1.5, 0.1));
    couples.emplace_back("N2-N2.1", wavy_plate(random, 3, 0.02, 1, 4), law, Vec<3>(1.4, 1.5, 0.1)); // with edges
    couples.emplace_back("N2", make_ball<3>({1.5, 1.5, -2}, 2), law, Vec<3>(1.5, 1.5, 0.1));
    for (Couple3& couple : couples) {
      couple.shake(random, 0.003).touch().move_die({0, 0, -0.05});
      for (const Vec<3>& drag : {Vec<3>(0, 0, 0), Vec<3>(3e-4, 1e-4, 0), Vec<3>(0.05, 0.03, 0)}) {
        couple.move_die(drag).shake(random, 0.0003);
        compare_with_differences(couple, random, sum);
        if (mu == 0) {
          EXPECT_TRUE(is_symmetric(couple));
        }
        couple.pair.accept();
      }
    }
  }
  sum.expect({.states = 12, .stick = 100, .slip = 50});
}

/// Beyond an open end the tractions fade, with an unsymmetric tangent; everywhere else it is symmetric.
TEST(ReferenceArea, OnlyFadingPointsMakeTheTangentUnsymmetric) {
  Census sum;
  Random random(5);
  for (double x : {2.4, 2.95}) // above the slab, whose end is x = 3, and at the end
    for (double mu : {0.0, 0.3})
      for (bool revolved : {false, true}) {
        Couple couple("N2", slab("N2"), per_reference(mu), x, 1.0, revolved);
        couple.touch().move_die(0, -0.06).shake(random, 0.0005);
        compare_with_differences(couple, sum);
        int beyond = 0;
        for (const auto& point : couple.pair.results())
          beyond += point.state != ContactState::open && point.position(0) > 3;
        EXPECT_EQ(beyond > 0, x > 2.5);
        EXPECT_EQ(is_symmetric(couple), x < 2.5 && mu == 0);
      }
  sum.expect({.states = 6});
  Couple3 solid("N2", wavy_plate(random, 3, 0.02, 2, 4), per_reference(0), {2.9, 2.9, 0.1}); // at a corner
  Census solids;
  solid.touch().move_die({0, 0, -0.05}).evaluate();
  compare_with_differences(solid, random, solids);
  EXPECT_EQ(solids.states, 1);
  EXPECT_FALSE(is_symmetric(solid));
}

// ── Results ──────────────────────────────────────────────────────────────────────────────────────────────────────────

/// The lower side of a strip of length 3, on a plane, stretched along it to `times` its length; axisymmetric: a disc.
Couple stretched(const InterfaceLaw& law, double depth, double times, bool revolved = false) {
  Couple couple(discretize(nurbs::rectangle(3, 0.5, Eigen::Vector2d(0, 0)), {6, 1}, "N2", "south"), "south",
                make_plane<2>({0, 0}, {0, 1}), law, 4, revolved);
  const MatrixX points = couple.die.points();
  for (int a = 0; a < points.cols(); ++a) couple.u.segment<2>(2 * a) << (times - 1) * points(0, a), -depth;
  couple.evaluate();
  return couple;
}

TEST(ReferenceArea, AStretchedFaceKeepsItsForceAndSpreadsItsPressure) {
  const double depth = 0.01, nominal = 100 * depth;
  for (bool revolved : {false, true}) {
    const double area = revolved ? 9 * std::numbers::pi : 3, wider = revolved ? 4 * area : 2 * area;
    const Couple couple = stretched(per_reference(0), depth, 2, revolved);
    const Resultant<2> sum = couple.pair.resultant();
    EXPECT_NEAR(sum.force(1), nominal * area, 1e-13 * area);
    EXPECT_NEAR(couple.pair.area(), wider, 1e-13 * wider);
    for (const auto& point : couple.pair.results()) {
      EXPECT_NEAR(point.pressure, nominal * area / wider, 1e-13);
      EXPECT_NEAR(point.force.norm(), point.pressure * point.area, 1e-14);
    }
    // ½ ε g² per reference area, and stiffness ε √(Σ A²)
    EXPECT_NEAR(couple.pair.potential(), 0.5 * nominal * depth * area, 1e-13 * area);
    const Couple before = stretched(per_reference(0), depth, 1, revolved), usual = stretched({100}, depth, 1, revolved);
    EXPECT_NEAR(couple.pair.stiffness(), before.pair.stiffness(), 1e-12 * before.pair.stiffness());
    // The undeformed face: no difference
    EXPECT_NEAR((before.dense().force - usual.dense().force).norm(), 0, 1e-13 * usual.dense().force.norm());
  }
}

/// A stretched strip dragged by `way`: the dissipation is μ F times the way of the slip points.
TEST(ReferenceArea, DissipationIsTheFrictionForceTimesTheSlip) {
  const double mu = 0.3, way = 0.5, depth = 0.01, force = mu * 100 * depth * 3;
  Couple couple = stretched(per_reference(mu), -depth, 2);
  couple.accept().move_die(0, -2 * depth).evaluate().accept();
  for (int step = 0; step < 10; ++step) {
    couple.move_die(way / 10, 0).evaluate();
    EXPECT_NEAR(couple.pair.resultant().force(0), -force, 1e-12);
    couple.pair.accept();
  }
  EXPECT_NEAR(couple.pair.dissipated(), force * (way - mu * depth), 1e-12); // stick as far as ε_T s < μ ε_N g
}

/// Changes of the springs' energy are the work of the forces, for random displacements of both faces: its error falls
/// with the third power of their size in one step.
template <class AnyCouple> void springs_store_the_work(AnyCouple couple, unsigned seed) {
  Random random(seed);
  VectorX direction(couple.u.size());
  for (int i = 0; i < direction.size(); ++i) direction(i) = uniform(random, -1, 1);
  const VectorX from = couple.u;
  const auto error = [&](double size) {
    couple.evaluate(from);
    const VectorX before = couple.dense().force;
    const double stored = couple.pair.potential();
    couple.evaluate(from + size * direction);
    const VectorX after = couple.dense().force;
    // f is the residual: −f acts on the bodies, so that f·du is work done on the springs
    return std::abs(couple.pair.potential() - stored - 0.5 * size * (before + after).dot(direction));
  };
  EXPECT_GT(error(1e-3) / error(5e-4), 6);
}

TEST(ReferenceArea, SpringsStoreTheWorkOfFrictionlessContact) {
  Random random(6);
  Couple couple("N2", slab("N2"), per_reference(0), 1.4, 0.95);
  springs_store_the_work(couple, 1);
  Couple3 solid("N2", wavy_plate(random, 3, 0.02, 2, 4), per_reference(0), {1.5, 1.5, 0});
  solid.touch().move_die({0, 0, -0.05});
  springs_store_the_work(solid, 2);
}

/// Per current area the springs of a face that is stretched from 3 to 6 get ½ ε g² times its growth without work.
TEST(ReferenceArea, GrowthOfTheAreaIsCountedWhereTractionsActOnIt) {
  const double depth = 0.01, density = 0.5 * 100 * depth * depth;
  for (const InterfaceLaw& law : {InterfaceLaw{100}, per_reference(0)}) {
    Couple couple = stretched(law, depth, 1);
    couple.pair.accept();
    for (int step = 0; step < 4; ++step) {
      const MatrixX points = couple.die.points();
      for (int a = 0; a < points.cols(); ++a) couple.u(2 * a) += 0.25 * points(0, a);
      couple.evaluate().accept();
    }
    EXPECT_NEAR(couple.pair.history().growth, law.per == TractionArea::current ? density * 3 : 0, 1e-14);
  }
}

} // namespace reference_area_test
} // namespace signorini::contact
