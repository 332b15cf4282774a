// The tangent with the volume change that the last correction predicted, for all element kernels.
#include "solid/hyperelastic.hpp"
#include "solid/many_bodies.hpp"
#include "solid/predicted_volume.hpp"
#include "solid/projected_volume.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace signorini::solid {
namespace predicted_volume_test {

using namespace test;

const NeoHookean rubber = neo_hookean(5, 0.49);

/// Neo-Hooke from its formula, which has the kernels of moduli; E = 3, ν = 0.45 at small strains.
Hyperelastic rubber_by_formula() {
  symbolic::Graph graph(variable_names(Measure::invariants, 0));
  const double mu = 3 / 2.9, lambda = 9 * mu;
  const int i1 = graph.variable(0), log_j = graph.apply(symbolic::Operation::log, graph.variable(2));
  const int volume = graph.multiply(graph.constant(lambda / 2), graph.multiply(log_j, log_j));
  const int shape = graph.multiply(graph.constant(mu / 2), graph.subtract(i1, graph.constant(3)));
  const int energy = graph.subtract(graph.add(volume, shape), graph.multiply(graph.constant(mu), log_j));
  return hyperelastic({"test", Measure::invariants, {}, std::move(graph), energy});
}

/// F at the Gauss points of macro-element m.
template <int D> std::vector<Mat<3>> deformations(const Body<D>& body, int m, const VectorX& u) {
  std::vector<Mat<3>> all;
  const std::vector<int> elements = body.macros().list.empty() ? std::vector<int>{m} : body.macros().list[m].elements;
  for (const int e : elements) {
    const int n = body.tables().element(e).functions;
    for (int q = 0; q < body.tables().element(e).points; ++q) {
      Mat<3> f = Mat<3>::Identity();
      for (int a = 0; a < n; ++a) {
        const double* gradients = body.tables().gradients_of(e) + q * D * n;
        const Vec<D> value = u.segment<D>(D * body.tables().functions_of(e)[a]);
        for (int k = 0; k < D; ++k) f.block<D, 1>(0, k) += value * gradients[k * n + a];
        if (const double* hoops = body.tables().hoops_of(e)) f(2, 2) += value(0) * hoops[q * n + a];
      }
      all.push_back(f);
    }
  }
  return all;
}

/// τ = b Δ at the points of a macro-element, Δ = ln J₀ + F₀⁻ᵀ:(F − F₀) − ln J; with projected volume change b at F̄
/// and PΔ.
template <int D> VectorX stresses(const Body<D>& body, int m, const VectorX& u, const VectorX& before) {
  const std::vector<Mat<3>> f = deformations(body, m, u), f0 = deformations(body, m, before);
  const auto points = static_cast<Eigen::Index>(f.size());
  VectorX predicted(points), change = VectorX::Zero(points), theta(points), tau(points);
  for (Eigen::Index q = 0; q < points; ++q) {
    theta(q) = std::log(f[q].determinant());
    predicted(q) = std::log(f0[q].determinant()) + (f0[q].inverse() * (f[q] - f0[q])).trace() - theta(q);
  }
  if (!body.macros().list.empty()) {
    MacroArrays<D> arrays;
    project(body.macros().list[m], theta, arrays, change);
    change = (change - theta) / 3;
    project(body.macros().list[m], predicted, arrays, predicted);
  }
  for (Eigen::Index q = 0; q < points; ++q) {
    const Mat<3> bar = std::exp(change(q)) * f[q];
    double b = bar.cwiseProduct(body.material().stress(bar)).sum() / 9;
    const Moduli moduli = body.material().moduli(bar, {});
    for (int e = 0; e < 9; ++e)
      for (int o = 0; o < 9; ++o) b += bar(e / 3, e % 3) * moduli(e, o) * bar(o / 3, o % 3) / 9;
    // The kernels of neo-Hooke take its λ.
    if (body.macros().list.empty() && !body.tables().element(0).kernels.respond) b = rubber.lambda;
    tau(q) = b * predicted(q);
  }
  return tau;
}

/// The difference from the exact tangent is the second derivative of Σ_q w τ ln J at fixed τ.
template <int D> void tangent_has_the_predicted_pressure(const std::vector<Body<D>>& bodies) {
  Random random(5);
  for (const Body<D>& body : bodies) {
    ASSERT_TRUE(predicts_volume(body));
    const VectorX before = random_displacement(random, body, 0.015),
                  u = before + random_displacement(random, body, 0.01);
    const VectorX direction = random_displacement(random, body, 1), other = random_displacement(random, body, 1);
    const Assembled exact = assemble(body, u), same = assemble(body, u, {}, u.data()),
                    predicted = assemble(body, u, {}, before.data());
    EXPECT_LT((same.tangent - exact.tangent).norm(), 1e-12 * exact.tangent.norm());
    EXPECT_EQ(predicted.force, exact.force);
    EXPECT_LT((predicted.tangent - predicted.tangent.transpose()).norm(), 1e-12 * exact.tangent.norm());
    std::vector<VectorX> tau;
    for (int m = 0; m < body.macro_elements(); ++m) tau.push_back(stresses(body, m, u, before));
    const auto work = [&](const VectorX& at) {
      double sum = 0;
      for (int m = 0; m < body.macro_elements(); ++m) {
        const std::vector<Mat<3>> f = deformations(body, m, at);
        const std::vector<int> elements =
            body.macros().list.empty() ? std::vector<int>{m} : body.macros().list[m].elements;
        std::size_t q = 0;
        for (const int e : elements)
          for (int own = 0; own < body.tables().element(e).points; ++own, ++q)
            sum +=
                body.tables().weights_of(e)[own] * tau[m](static_cast<Eigen::Index>(q)) * std::log(f[q].determinant());
      }
      return sum;
    };
    const auto slope = [&](double h) {
      return signorini::test::derivative<double>([&](double g) { return work(u + h * direction + g * other); }, 1e-3);
    };
    const double expected = signorini::test::derivative<double>(slope, 1e-3);
    const double found = other.dot((predicted.tangent - exact.tangent) * direction);
    EXPECT_NEAR(found, expected, 1e-6 * std::abs(expected));
    EXPECT_GT(std::abs(expected), 1e-6 * exact.tangent.norm());
  }
}

template <int D> std::vector<Body<D>> projected(const std::vector<Body<D>>& bodies) {
  std::vector<Body<D>> result;
  for (const Body<D>& body : bodies)
    result.emplace_back(body.shared_space(), body.material(), body.kind(), Volumetric::projected);
  return result;
}

TEST(PredictedVolume, IsThatOfNeoHookeInThePlane) {
  tangent_has_the_predicted_pressure(plane_bodies(rubber));
}
TEST(PredictedVolume, IsThatOfNeoHookeInSpace) {
  tangent_has_the_predicted_pressure(space_bodies(rubber));
}
TEST(PredictedVolume, IsThatOfNeoHookeInBodiesOfRevolution) {
  tangent_has_the_predicted_pressure(bodies_of_revolution(rubber));
}
TEST(PredictedVolume, IsThatOfAFormula) {
  const Hyperelastic law = rubber_by_formula();
  tangent_has_the_predicted_pressure(plane_bodies(law));
  tangent_has_the_predicted_pressure(space_bodies(law));
  tangent_has_the_predicted_pressure(bodies_of_revolution(law));
}
TEST(PredictedVolume, IsProjected) {
  tangent_has_the_predicted_pressure(projected(plane_bodies(rubber)));
  tangent_has_the_predicted_pressure(projected(space_bodies(rubber)));
  tangent_has_the_predicted_pressure(projected(bodies_of_revolution(rubber)));
}

TEST(PredictedVolume, IsOnlyOfNearlyIncompressibleBodiesAtLargeStrains) {
  const nurbs::Patch square = nurbs::rectangle(1, 1, Eigen::Vector2d(0, 0));
  EXPECT_FALSE(predicts_volume(make_body<2>(square, {2, 2}, "N2", "north", neo_hookean(1, 0.4))));
  EXPECT_FALSE(predicts_volume(make_body<2>(square, {2, 2}, "N2", "north", linear_elastic(1, 0.49))));
  EXPECT_FALSE(predicts_volume(*in_plane_stress(make_body<2>(square, {2, 2}, "N2", "north", rubber))));
}

} // namespace predicted_volume_test
} // namespace signorini::solid
