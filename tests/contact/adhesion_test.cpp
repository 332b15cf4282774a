// Van der Waals adhesion at one point: the law against its formula and its derivative, the tangent of the force against
// finite differences in 2D and 3D.
#include "contact/local_cases.hpp"

#include <cmath>
#include <numbers>

namespace signorini::contact {
namespace adhesion_test {

using namespace test;

/// A_H in nN·nm and r₀ in nm of the published peeling problem, and another pair.
const Adhesion laws[] = {{0.1, 0.4}, {3.0, 2.5}};

TEST(Adhesion, TractionIsThePublishedFunction) {
  for (const Adhesion& law : laws) {
    const auto [a, r0] = law;
    const double nearest = equilibrium_distance(law);
    EXPECT_NEAR(nearest, std::pow(1.0 / 15, 1.0 / 6) * r0, 1e-15 * r0);
    for (double r = nearest; r < 20 * r0; r *= 1.07) {
      // thesis 3.85, 3.88
      const double t = a / (2 * std::numbers::pi * std::pow(r0, 3)) *
                       (std::pow(r0 / r, 9) / 45 - std::pow(r0 / r, 3) / 3),
                   slope =
                       -a / (2 * std::numbers::pi * std::pow(r0, 4)) * (std::pow(r0 / r, 10) / 5 - std::pow(r0 / r, 4));
      EXPECT_NEAR(traction(law, r), t, 1e-14 * std::abs(stiffness(law, nearest)) * r);
      EXPECT_NEAR(stiffness(law, r), slope, 1e-14 * std::abs(stiffness(law, nearest)));
    }
    // Equilibrium, and the strongest attraction (thesis 3.86)
    const double strongest = strongest_distance(law), scale = a / (9 * std::numbers::pi * std::pow(r0, 3));
    EXPECT_NEAR(traction(law, nearest), 0, 1e-14 * scale);
    EXPECT_NEAR(strongest, std::pow(3.0, 1.0 / 6) * nearest, 1e-15 * r0);
    EXPECT_NEAR(traction(law, strongest), -std::sqrt(5.0) * scale, 1e-14 * scale);
    EXPECT_NEAR(stiffness(law, strongest) * r0, 0, 1e-13 * scale);
    for (double r : {0.9 * strongest, 1.1 * strongest}) EXPECT_GT(traction(law, r), traction(law, strongest));
  }
}

/// Below r_eq the law is extended by its tangent (thesis 3.87), also to r ≤ 0.
TEST(Adhesion, IsExtendedByItsTangentBelowEquilibrium) {
  for (const Adhesion& law : laws) {
    const double nearest = equilibrium_distance(law), slope = stiffness(law, nearest), r0 = law.distance;
    EXPECT_LT(slope, 0);
    for (double r : {0.99 * nearest, 0.5 * nearest, 0.0, -2 * nearest}) {
      EXPECT_NEAR(traction(law, r), slope * (r - nearest), 1e-15 * std::abs(slope) * r0);
      EXPECT_EQ(stiffness(law, r), slope);
    }
    // Continuously differentiable: differences across r_eq are of first and second order.
    for (double h : {1e-4 * r0, 1e-5 * r0}) {
      EXPECT_NEAR(traction(law, nearest + h) - traction(law, nearest - h), 2 * h * slope,
                  20 * h * h * std::abs(slope) / r0);
      EXPECT_NEAR(stiffness(law, nearest + h), stiffness(law, nearest - h), 40 * h * std::abs(slope) / r0);
    }
  }
}

TEST(Adhesion, StiffnessIsTheTractionsDerivative) {
  for (const Adhesion& law : laws)
    for (double r : {-0.3, 0.2, 0.6, 0.65, 0.75, 1.0, 2.5, 10.0}) {
      const double at = r * law.distance;
      const double slope =
          signorini::test::derivative<double>([&](double h) { return traction(law, at + h); }, 1e-3 * law.distance);
      EXPECT_NEAR(stiffness(law, at), slope, 1e-9 * std::abs(stiffness(law, 0))) << r;
    }
}

TEST(Adhesion, TractionIsMinusThePotentialsDerivative) {
  for (const Adhesion& law : laws) {
    for (double r : {-0.3, 0.2, 0.6, 0.65, 0.75, 1.0, 2.5, 10.0}) {
      const double at = r * law.distance;
      const double slope =
          signorini::test::derivative<double>([&](double h) { return potential(law, at + h); }, 1e-3 * law.distance);
      EXPECT_NEAR(traction(law, at), -slope, 1e-9 * std::abs(stiffness(law, 0)) * law.distance) << r;
    }
    EXPECT_NEAR(potential(law, 1e6 * law.distance), 0, 1e-10 * std::abs(potential(law, law.distance)));
  }
}

template <int D> void tangent_and_shift(Foot foot) {
  Random random(10 + static_cast<unsigned>(D));
  const Adhesion law{0.1, 0.1};
  int below = 0, attracting = 0, open = 0;
  for (int trial = 0; trial < 150; ++trial) {
    // A regular foot point may be penetrated; at a corner the slave point is outside the kink.
    const double gap = law.distance * (foot == Foot::regular ? uniform(random, -0.3, 1.2) : uniform(random, 0.3, 1.2));
    const Variables<D> q = random_variables<D>(random, foot, gap, 0);
    const Situation<D> situation{random_curvature<D>(random), foot, false, D == 2 && trial % 2 == 0,
                                 uniform(random, 0.5, 2)};
    const Outcome<D> at = evaluate<D>(adhesive(law), q, situation);
    const double distance = std::abs(at.gap - equilibrium_distance(law));
    if (distance < 0.02 * law.distance) continue; // T″ jumps there
    (at.gap < equilibrium_distance(law) ? below : at.force.state == ContactState::adhesion ? attracting : open)++;
    EXPECT_EQ(at.force.state, at.gap < strongest_distance(law) ? ContactState::adhesion : ContactState::open);
    EXPECT_EQ(at.force.measure, situation.reference_measure);
    EXPECT_EQ(at.force.pressure, traction(law, at.gap));
    EXPECT_EQ(at.force.friction.norm(), 0);
    EXPECT_NEAR(at.force.force.norm(), at.force.measure * std::abs(at.force.pressure), 1e-14 * at.force.force.norm());
    compare_with_differences<D>(adhesive(law), q, situation, 2e-4 * law.distance);
  }
  EXPECT_GT(below, 20);
  EXPECT_GT(attracting, 5);
  EXPECT_GT(open, 20);
}

TEST(Adhesion, TangentIsTheForcesDerivative) {
  tangent_and_shift<2>(Foot::regular);
  tangent_and_shift<3>(Foot::regular);
}
TEST(Adhesion, TangentIsTheForcesDerivativeAtACorner) {
  tangent_and_shift<2>(Foot::corner);
  tangent_and_shift<3>(Foot::corner);
}

/// On a flat rigid master the tangent is T′ n̄ ⊗ n̄ per reference area, independent of the slave's stretch.
TEST(Adhesion, OnAFlatRigidMasterTheTangentIsThePublishedOne) {
  Random random(3);
  const Adhesion law{0.1, 0.4};
  for (double gap : {0.2, 0.3, 0.45, 2.0}) {
    const Variables<3> q = random_variables<3>(random, Foot::regular, gap, 0);
    const Situation<3> flat{{Vec<3>::Zero(), Vec<3>::Zero(), Vec<3>::Zero()}, Foot::regular, false, false, 0.7};
    const LocalForce<3> at = evaluate<3>(adhesive(law), q, flat).force;
    const Vec<3> n =
        upward<3>({q.segment<3>(LocalForce<3>::tangent_column), q.segment<3>(LocalForce<3>::tangent_column + 3)});
    const Mat<3> expected = 0.7 * stiffness(law, gap) * n * n.transpose();
    EXPECT_NEAR((at.tangent.leftCols<3>() - expected).norm(), 0, 1e-12 * std::abs(stiffness(law, 0)));
    EXPECT_EQ(at.tangent.middleCols<6>(LocalForce<3>::slave_tangent_column).norm(), 0);
  }
}

TEST(Adhesion, ErrorsNameTheArgument) {
  EXPECT_ERROR(check(Adhesion{-0.1, 0.4}), "contact.adhesion.hamaker: value = -0.1");
  EXPECT_ERROR(check(Adhesion{0, 0.4}), "contact.adhesion.hamaker: value = 0");
  EXPECT_ERROR(check(Adhesion{0.1, 0}), "contact.adhesion.distance: value = 0");
  EXPECT_ERROR(check(Adhesion{0.1, std::nan("")}), "contact.adhesion.distance");
}

} // namespace adhesion_test
} // namespace signorini::contact
