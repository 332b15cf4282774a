#pragma once
// A model's parts, so that states can be set that are no equilibria, and its tangent against finite differences.

#include "model/assembly.hpp"
#include "model/drives.hpp"

#include "differences.hpp"
#include "nurbs/random_patch.hpp"

#include <gtest/gtest.h>

namespace signorini::model::test {

struct Bench {
  Scene<2> scene;
  Unknowns<2> unknowns;
  Assembly<2> assembly;
  std::vector<contact::Pair<2>> pairs;
  Timings timings;

  explicit Bench(Scene<2> wanted) : scene(std::move(wanted)), unknowns(scene), assembly(scene, unknowns) {
    for (const Contact<2>& contact : scene.contacts) {
      const auto surface = [&](const FaceReference& face) {
        return contact::Surface<2>(scene.bodies[static_cast<std::size_t>(face.body)].body->space(), face.side);
      };
      const auto* face = std::get_if<FaceReference>(&contact.master);
      const auto* obstacle = std::get_if<ObstacleReference>(&contact.master);
      contact::Master<2> master =
          face ? contact::Master<2>(surface(*face))
               : contact::Master<2>(scene.obstacles[static_cast<std::size_t>(obstacle->obstacle)]);
      pairs.emplace_back(surface(contact.slave), std::move(master), contact.law, contact.points,
                         scene.kind == solid::Kind::axisymmetric, contact.where);
    }
  }
  VectorX residual(const VectorX& u, const VectorX* direction = nullptr) {
    EXPECT_FALSE(assembly.assemble(pairs, u, direction, true, timings));
    return assembly.residual();
  }
  /// Of the unknowns.
  MatrixX tangent() const {
    const solve::Pattern& pattern = assembly.pattern();
    MatrixX full = MatrixX::Zero(pattern.size, pattern.size);
    for (int j = 0; j < pattern.size; ++j)
      for (int k = pattern.starts[static_cast<std::size_t>(j)]; k < pattern.starts[static_cast<std::size_t>(j) + 1];
           ++k)
        full(pattern.rows[static_cast<std::size_t>(k)], j) = assembly.values()[static_cast<std::size_t>(k)];
    return full;
  }
  /// What finite differences must not step over.
  std::vector<int> signature() const {
    std::vector<int> result;
    for (const auto& pair : pairs) {
      for (const auto& point : pair.results()) result.push_back(static_cast<int>(point.state));
      for (const auto& group : pair.groups())
        result.insert(result.end(), {group.slave_element, group.master_element, group.slip_element});
    }
    return result;
  }
};

/// Compares at u; false when a difference steps over a change of state. Also: product() is the tangent's along a
/// direction of everything that is prescribed.
inline bool compare(Bench& bench, const VectorX& u) {
  bench.residual(u);
  const MatrixX tangent = bench.tangent();
  const std::vector<int> before = bench.signature();
  bool same = true;
  const auto along = [&](const VectorX& direction) {
    return signorini::test::derivative<VectorX>(
        [&](double h) {
          const VectorX residual = bench.residual(u + h * direction);
          same = same && bench.signature() == before;
          return residual;
        },
        2e-6);
  };
  MatrixX slopes(tangent.rows(), tangent.cols());
  for (int i = 0; i < tangent.cols() && same; ++i) {
    const VectorX unit = VectorX::Unit(tangent.cols(), i);
    slopes.col(i) = bench.unknowns.gather(along(bench.unknowns.spread(unit)));
  }
  nurbs::test::Random random(1);
  VectorX increment = VectorX::Zero(u.size());
  for (int dof = 0; dof < u.size(); ++dof)
    if (bench.unknowns.held(dof)) increment(dof) = nurbs::test::uniform(random, -0.1, 0.1);
  const VectorX added = along(increment);
  if (!same) return false;
  EXPECT_LT((slopes - tangent).norm(), 1e-8 * tangent.norm());
  bench.residual(u, &increment);
  EXPECT_LT((bench.assembly.product() - added).norm(), 1e-7 * added.norm());
  return true;
}

} // namespace signorini::model::test
