#pragma once
// Curved, rational and layered bodies of all kinds for any material, and the finite-difference test of force and
// tangent on them.

#include "differences.hpp"
#include "solid/bodies.hpp"

#include <gtest/gtest.h>

namespace signorini::solid::test {

/// A plane patch with displaced points and random weights.
inline nurbs::Patch distorted(Random& random, bool rational) {
  const nurbs::Patch flat = nurbs::elevate(nurbs::rectangle(2, 1, Eigen::Vector2d(0, 0)), 0, 1);
  MatrixX points = flat.points();
  VectorX weights = flat.weights();
  for (int a = 0; a < points.cols(); ++a) {
    points.col(a) += Eigen::Vector2d(uniform(random, -0.1, 0.1), uniform(random, -0.1, 0.1));
    if (rational) weights(a) = uniform(random, 0.7, 1.4);
  }
  return nurbs::make_patch(flat.directions(), points, weights);
}

/// Meridians away from the axis and touching it.
inline std::vector<Body<2>> bodies_of_revolution(const Material& material) {
  Random random(7);
  const nurbs::Patch away = nurbs::translate(distorted(random, true), Eigen::Vector2d(0.4, 0));
  const nurbs::Patch ball = nurbs::quarter_annulus(0.3, 0.6, Eigen::Vector2d(0, 0), 270);
  std::vector<Body<2>> bodies;
  for (const auto& body :
       {make_body<2>(away, {3, 2}, "N2-N2.1", "north", material, 2),
        make_body<2>(ball, {3, 2}, "N2", "south", material),
        make_body<2>(nurbs::rectangle(1, 2, Eigen::Vector2d(0, -1)), {2, 3}, "N2-N4", "south", material)})
    bodies.push_back(*revolved(body));
  return bodies;
}

inline std::vector<Body<2>> plane_bodies(const Material& material) {
  Random random(3);
  std::vector<Body<2>> bodies;
  const nurbs::Patch ring = nurbs::half_annulus(0.3, 0.6, Eigen::Vector2d(0, 0));
  for (const char* label : {"N2", "N2-N4", "N2-N2.2x2", "L2"})
    bodies.push_back(make_body<2>(ring, {4, 2}, label, "south", material));
  bodies.push_back(make_body<2>(distorted(random, true), {3, 2}, "N3.1", "north", material, 2));
  bodies.push_back(make_body<2>(nurbs::rectangle(1, 2, Eigen::Vector2d(0, 0)), {2, 3}, "N2-N2.1", "west", material));
  return bodies;
}

inline std::vector<Body<3>> space_bodies(const Material& material) {
  std::vector<Body<3>> bodies;
  const nurbs::Patch block = nurbs::block({1, 1, 0.5}, Eigen::Vector3d(0, 0, 0));
  bodies.push_back(make_body<3>(block, {2, 1, 2}, "N2-N2.1", "back", material));
  const nurbs::Patch shell = nurbs::half_cylinder_shell(0.4, 0.7, 0.5, Eigen::Vector3d(0, 0, 0));
  bodies.push_back(make_body<3>(shell, {2, 1, 1}, "N2", "front", material));
  bodies.push_back(make_body<3>(block, {1, 1, 2}, "N2-N2.2", "front", material));
  bodies.push_back(
      make_body<3>(nurbs::sphere_octant(0.4, 0.7, Eigen::Vector3d(0, 0, 0)), {1, 2, 1}, "N2", "front", material, 2));
  return bodies;
}

template <int D> void force_and_tangent_are_derivatives(const std::vector<Body<D>>& bodies) {
  Random random(4);
  for (const Body<D>& body : bodies) {
    const VectorX u = random_displacement(random, body, 0.015);
    const Assembled at = assemble(body, u);
    ASSERT_FALSE(at.inversion);
    VectorX gradient(u.size());
    MatrixX slopes(u.size(), u.size());
    for (int i = 0; i < u.size(); ++i) {
      const auto moved = [&](double h) {
        VectorX v = u;
        v(i) += h;
        return v;
      };
      gradient(i) =
          signorini::test::derivative<double>([&](double h) { return stored_energy(body, moved(h).data()); }, 2e-4);
      slopes.col(i) =
          signorini::test::derivative<VectorX>([&](double h) { return assemble(body, moved(h)).force; }, 1e-4);
    }
    EXPECT_LT((gradient - at.force).norm(), 1e-8 * at.force.norm());
    EXPECT_LT((slopes - at.tangent).norm(), 1e-8 * at.tangent.norm());
    EXPECT_LT((at.tangent - at.tangent.transpose()).norm(), 1e-13 * at.tangent.norm());
  }
}

} // namespace signorini::solid::test
