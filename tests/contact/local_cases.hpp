#pragma once
// A law at one contact point as a function of its local variables, on a master that is quadratic about the foot point:
// x(η) = x̄ + τ_α η^α + ½ x_,αβ η^α η^β.

#include "contact/point/interface_force.hpp"

#include "differences.hpp"
#include "nurbs/random_patch.hpp"

#include <gtest/gtest.h>

namespace signorini::contact::test {

using nurbs::test::Random;
using nurbs::test::uniform;

template <int D> using Variables = Eigen::Matrix<double, LocalForce<D>::columns, 1>;
template <int D> using Second = std::array<Vec<D>, FacePoint<D>::seconds>;

template <int D> Vec<D> random_vector(Random& random, double size) {
  Vec<D> v;
  for (int i = 0; i < D; ++i) v(i) = uniform(random, -size, size);
  return v;
}

template <int D> Second<D> random_curvature(Random& random) {
  Second<D> second;
  for (Vec<D>& curve : second) curve = random_vector<D>(random, 2);
  return second;
}

/// Parameters that are constant while the local variables change.
template <int D> struct Situation {
  Second<D> second;
  Foot foot = Foot::regular;
  bool slips = false, revolved = false;
  double reference_measure = 1;
  FixedContactState fixed_state = FixedContactState::free;
  FaceCoordinates<D> axis = FaceCoordinates<D>::Unit(0);
};

template <int D> struct Outcome {
  LocalForce<D> force;
  FaceCoordinates<D> eta;
  double gap;
};

template <int D> Vec<D> upward(const std::array<Vec<D>, D - 1>& tangent) {
  if constexpr (D == 2)
    return Vec<2>(-tangent[0](1), tangent[0](0)).normalized();
  else
    return tangent[0].cross(tangent[1]).normalized();
}

/// The law for local variables q, with the foot point by Newton's method on (xˢ − x(η))·x_,α = 0.
template <int D> Outcome<D> evaluate(const InterfaceLaw& law, const Variables<D>& q, const Situation<D>& situation) {
  using Force = LocalForce<D>;
  constexpr int tangents = D - 1;
  const Vec<D> slave = q.template head<D>();
  FacePoint<D> master{};
  Outcome<D> outcome;
  outcome.eta.setZero();
  master.second = situation.second;
  const auto place = [&] {
    master.position = q.template segment<D>(Force::master_column);
    for (int a = 0; a < tangents; ++a) {
      const std::size_t i = static_cast<std::size_t>(a);
      const Vec<D> tau = q.template segment<D>(Force::tangent_column + D * a);
      master.tangent[i] = tau;
      master.position += outcome.eta(a) * tau;
      for (int b = 0; b < tangents; ++b) {
        const Vec<D>& curve = situation.second[static_cast<std::size_t>(a + b)];
        master.tangent[i] += outcome.eta(b) * curve;
        master.position += 0.5 * outcome.eta(a) * outcome.eta(b) * curve;
      }
    }
  };
  place();
  for (int step = 0; step < 12 && situation.foot == Foot::regular; ++step) {
    FaceCoordinates<D> slope;
    Mat<tangents> hessian;
    for (int a = 0; a < tangents; ++a) {
      slope(a) = (master.position - slave).dot(master.tangent[static_cast<std::size_t>(a)]);
      for (int b = 0; b < tangents; ++b)
        hessian(a, b) = master.tangent[static_cast<std::size_t>(a)].dot(master.tangent[static_cast<std::size_t>(b)]) +
                        (master.position - slave).dot(situation.second[static_cast<std::size_t>(a + b)]);
    }
    outcome.eta -= hessian.inverse() * slope;
    place();
  }

  LocalGeometry<D> geometry;
  geometry.slave = slave;
  for (int a = 0; a < tangents; ++a)
    geometry.slave_tangent[static_cast<std::size_t>(a)] = q.template segment<D>(Force::slave_tangent_column + D * a);
  geometry.master = &master;
  geometry.foot = situation.foot;
  geometry.normal = upward<D>(master.tangent);
  const Vec<D> apart = slave - master.position;
  geometry.gap = apart.dot(geometry.normal);
  if (situation.foot == Foot::corner) {
    geometry.gap = std::copysign(apart.norm(), geometry.gap);
    geometry.normal = apart / geometry.gap;
  }
  const Vec<D> slip = q.template segment<D>(Force::slip_column);
  geometry.slip_point = situation.slips ? &slip : nullptr;
  geometry.revolved = situation.revolved;
  geometry.reference_measure = situation.reference_measure;
  geometry.fixed_state = situation.fixed_state;
  geometry.axis = situation.axis;
  outcome.gap = geometry.gap;
  interface_force(law, geometry, outcome.force);
  return outcome;
}

/// Variables near a foot point at η = 0 with a given gap and the slip point at distance `reach` from it; at a corner
/// the slave point is off the normal by 0.6 of the gap. All first coordinates are positive.
template <int D> Variables<D> random_variables(Random& random, Foot foot, double gap, double reach) {
  using Force = LocalForce<D>;
  Variables<D> q;
  std::array<Vec<D>, D - 1> tau;
  for (int a = 0; a < D - 1; ++a) {
    tau[static_cast<std::size_t>(a)] = Vec<D>::Unit(a) * uniform(random, 0.7, 1.5) + random_vector<D>(random, 0.3);
    q.template segment<D>(Force::slave_tangent_column + D * a) = Vec<D>::Unit(a) + random_vector<D>(random, 0.3);
    q.template segment<D>(Force::tangent_column + D * a) = tau[static_cast<std::size_t>(a)];
  }
  const Vec<D> foot_point = random_vector<D>(random, 1) + 2 * Vec<D>::Unit(0);
  q.template segment<D>(Force::master_column) = foot_point;
  q.template head<D>() = foot_point + gap * upward<D>(tau);
  if (foot == Foot::corner) q.template head<D>() -= 0.6 * gap * tau[0];
  Vec<D> direction = Vec<D>::Zero();
  for (const Vec<D>& t : tau) direction += uniform(random, -1, 1) * t;
  q.template segment<D>(Force::slip_column) = foot_point + reach * direction.normalized();
  return q;
}

/// Compares the derivatives of force and shift with finite differences in every local variable.
template <int D, class Law>
void compare_with_differences(const Law& law, const Variables<D>& q, const Situation<D>& situation, double step) {
  const Outcome<D> at = evaluate<D>(law, q, situation);
  EXPECT_NEAR(at.eta.norm(), 0, 1e-14);
  for (int i = 0; i < LocalForce<D>::columns; ++i) {
    const auto moved = [&](double h) {
      Variables<D> r = q;
      r(i) += h;
      return evaluate<D>(law, r, situation);
    };
    const Vec<D> force = signorini::test::derivative<Vec<D>>([&](double h) { return moved(h).force.force; }, step);
    const FaceCoordinates<D> shift =
        signorini::test::derivative<FaceCoordinates<D>>([&](double h) { return moved(h).eta; }, step);
    EXPECT_NEAR((force - at.force.tangent.col(i)).norm(), 0, 1e-8 * at.force.tangent.norm()) << "variable " << i;
    EXPECT_NEAR((shift - at.force.shift.col(i)).norm(), 0, 1e-8 * (1 + at.force.shift.norm())) << "variable " << i;
  }
}

} // namespace signorini::contact::test
