// The local law's tangent and the foot's shift against finite differences, in the plane and in space, on a master that
// is quadratic about its foot: x(η) = x̄ + τ_α η^α + ½ x_,αβ η^α η^β.
#include "contact/penalty.hpp"

#include "differences.hpp"
#include "nurbs/random_patch.hpp"

#include <gtest/gtest.h>

namespace signorini::contact {
namespace {

using nurbs::test::Random;
using nurbs::test::uniform;

template <int D> using Variables = Eigen::Matrix<double, LocalForce<D>::columns, 1>;
template <int D> using Second = std::array<Vec<D>, FacePoint<D>::seconds>;

template <int D> Vec<D> random_vector(Random& random, double size) {
  Vec<D> v;
  for (int i = 0; i < D; ++i) v(i) = uniform(random, -size, size);
  return v;
}

template <int D> struct Outcome {
  LocalForce<D> force;
  FaceCoordinates<D> eta;
};

/// The law for local variables q; the foot is found by Newton's method on (xˢ − x(η))·x_,α = 0.
template <int D>
Outcome<D> evaluate(const PenaltyLaw& law, const Variables<D>& q, const Second<D>& second, Foot foot, bool friction) {
  using Force = LocalForce<D>;
  constexpr int tangents = D - 1;
  const Vec<D> slave = q.template head<D>();
  FacePoint<D> master{};
  Outcome<D> outcome;
  outcome.eta.setZero();
  master.second = second;
  const auto place = [&] {
    master.position = q.template segment<D>(Force::master_column);
    for (int a = 0; a < tangents; ++a) {
      const std::size_t i = static_cast<std::size_t>(a);
      const Vec<D> tau = q.template segment<D>(Force::tangent_column + D * a);
      master.tangent[i] = tau;
      master.position += outcome.eta(a) * tau;
      for (int b = 0; b < tangents; ++b) {
        const Vec<D>& curve = second[static_cast<std::size_t>(a + b)];
        master.tangent[i] += outcome.eta(b) * curve;
        master.position += 0.5 * outcome.eta(a) * outcome.eta(b) * curve;
      }
    }
  };
  place();
  for (int step = 0; step < 12 && foot == Foot::regular; ++step) {
    FaceCoordinates<D> slope;
    Mat<tangents> hessian;
    for (int a = 0; a < tangents; ++a) {
      slope(a) = (master.position - slave).dot(master.tangent[static_cast<std::size_t>(a)]);
      for (int b = 0; b < tangents; ++b)
        hessian(a, b) = master.tangent[static_cast<std::size_t>(a)].dot(master.tangent[static_cast<std::size_t>(b)]) +
                        (master.position - slave).dot(second[static_cast<std::size_t>(a + b)]);
    }
    outcome.eta -= hessian.inverse() * slope;
    place();
  }

  LocalGeometry<D> geometry;
  geometry.slave = slave;
  for (int a = 0; a < tangents; ++a)
    geometry.slave_tangent[static_cast<std::size_t>(a)] = q.template segment<D>(Force::slave_tangent_column + D * a);
  geometry.master = &master;
  geometry.foot = foot;
  if constexpr (D == 2)
    geometry.normal = Vec<2>(-master.tangent[0](1), master.tangent[0](0)).normalized();
  else
    geometry.normal = master.tangent[0].cross(master.tangent[1]).normalized();
  geometry.gap = (slave - master.position).dot(geometry.normal);
  if (foot == Foot::corner) {
    geometry.gap = -(slave - master.position).norm();
    geometry.normal = (slave - master.position) / geometry.gap;
  }
  const Vec<D> slip = q.template segment<D>(Force::slip_column);
  geometry.slip_point = friction ? &slip : nullptr;
  penalty_force(law, geometry, outcome.force);
  return outcome;
}

/// Variables near a foot at η = 0 with penetration about 0.05 and the slip point at `reach` from the foot.
template <int D> Variables<D> random_variables(Random& random, Foot foot, double reach) {
  using Force = LocalForce<D>;
  Variables<D> q;
  std::array<Vec<D>, D - 1> tau;
  for (int a = 0; a < D - 1; ++a) {
    tau[static_cast<std::size_t>(a)] = Vec<D>::Unit(a) * uniform(random, 0.7, 1.5) + random_vector<D>(random, 0.3);
    q.template segment<D>(Force::slave_tangent_column + D * a) = Vec<D>::Unit(a) + random_vector<D>(random, 0.3);
    q.template segment<D>(Force::tangent_column + D * a) = tau[static_cast<std::size_t>(a)];
  }
  Vec<D> normal;
  if constexpr (D == 2)
    normal = Vec<2>(-tau[0](1), tau[0](0)).normalized();
  else
    normal = tau[0].cross(tau[1]).normalized();
  const Vec<D> foot_point = random_vector<D>(random, 1);
  q.template segment<D>(Force::master_column) = foot_point;
  q.template head<D>() = foot_point - 0.05 * normal;
  if (foot == Foot::corner) q.template head<D>() += 0.03 * tau[0];
  Vec<D> direction = Vec<D>::Zero();
  for (const Vec<D>& t : tau) direction += uniform(random, -1, 1) * t;
  q.template segment<D>(Force::slip_column) = foot_point + reach * direction.normalized();
  return q;
}

template <int D> void tangent_and_shift(Foot foot, double reach, ContactState expected) {
  Random random(static_cast<unsigned>(D));
  const PenaltyLaw law{100, 80, 0.3};
  for (int trial = 0; trial < 40; ++trial) {
    const Variables<D> q = random_variables<D>(random, foot, reach);
    Second<D> second;
    for (Vec<D>& curve : second) curve = random_vector<D>(random, 2);
    const bool friction = reach > 0;
    const Outcome<D> at = evaluate<D>(law, q, second, foot, friction);
    ASSERT_EQ(at.force.state, expected);
    EXPECT_NEAR(at.eta.norm(), 0, 1e-14);
    EXPECT_GT(at.force.pressure, 0);
    EXPECT_LE(at.force.friction.norm(), law.friction * at.force.pressure * (1 + 1e-14));
    for (int i = 0; i < LocalForce<D>::columns; ++i) {
      const auto moved = [&](double h) {
        Variables<D> r = q;
        r(i) += h;
        return evaluate<D>(law, r, second, foot, friction);
      };
      const Vec<D> force = signorini::test::derivative<Vec<D>>([&](double h) { return moved(h).force.force; }, 1e-4);
      const FaceCoordinates<D> shift =
          signorini::test::derivative<FaceCoordinates<D>>([&](double h) { return moved(h).eta; }, 1e-4);
      EXPECT_NEAR((force - at.force.tangent.col(i)).norm(), 0, 1e-8 * at.force.tangent.norm()) << "variable " << i;
      EXPECT_NEAR((shift - at.force.shift.col(i)).norm(), 0, 1e-8 * (1 + at.force.shift.norm())) << "variable " << i;
    }
  }
}

TEST(Penalty, FirstTouchHasNoFriction) {
  tangent_and_shift<2>(Foot::regular, 0, ContactState::stick);
  tangent_and_shift<3>(Foot::regular, 0, ContactState::stick);
}
TEST(Penalty, Stick) {
  tangent_and_shift<2>(Foot::regular, 0.01, ContactState::stick);
  tangent_and_shift<3>(Foot::regular, 0.01, ContactState::stick);
}
TEST(Penalty, Slip) {
  tangent_and_shift<2>(Foot::regular, 0.3, ContactState::slip);
  tangent_and_shift<3>(Foot::regular, 0.3, ContactState::slip);
}
TEST(Penalty, CornerStickAndSlip) {
  tangent_and_shift<2>(Foot::corner, 0.01, ContactState::stick);
  tangent_and_shift<2>(Foot::corner, 0.3, ContactState::slip);
  tangent_and_shift<3>(Foot::corner, 0.01, ContactState::stick);
  tangent_and_shift<3>(Foot::corner, 0.3, ContactState::slip);
}

/// t_T follows the slip, so that the traction on the slave, t_N n̄ − t_T, resists it.
TEST(Penalty, FrictionOpposesTheMotion) {
  Random random(7);
  const PenaltyLaw law{100, 80, 0.3};
  const Second<3> flat{Vec<3>::Zero(), Vec<3>::Zero(), Vec<3>::Zero()};
  for (double reach : {0.01, 0.3}) {
    const Variables<3> q = random_variables<3>(random, Foot::regular, reach);
    const auto at = evaluate<3>(law, q, flat, Foot::regular, true);
    const Vec<3> travelled = q.segment<3>(LocalForce<3>::master_column) - q.segment<3>(LocalForce<3>::slip_column);
    EXPECT_NEAR(at.force.friction.normalized().dot(travelled.normalized()), 1, 1e-14);
    EXPECT_LT(at.force.force.dot(travelled), 0);
    EXPECT_NEAR(at.force.pressure, 100 * 0.05, 1e-13);
    EXPECT_NEAR(at.force.friction.norm(), std::min(80 * reach, 0.3 * at.force.pressure), 1e-13);
  }
}

} // namespace
} // namespace signorini::contact
