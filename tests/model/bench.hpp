#pragma once
// The parts of a model, for states that are not in equilibrium, and a comparison of its tangent with finite
// differences.

#include "model/system/system.hpp"

#include "differences.hpp"
#include "nurbs/random_patch.hpp"

#include <gtest/gtest.h>

namespace signorini::model::test {

template <int D> struct Bench {
  System<D> system;
  State<D> accepted, present;
  std::vector<contact::Controls> controls;
  VectorX loads; ///< targets at which the loads act
  Timings timings;
  const Unknowns<D>& unknowns;
  const Assembly<D>& assembly;

  explicit Bench(Scene<D> scene)
      : system(std::move(scene)), accepted(system.start()), present(accepted), controls(system.contacts.size()),
        loads(system.drives.start()), unknowns(system.unknowns), assembly(system.assembly) {}
  std::optional<BodyInversion> assemble(const VectorX& u, const VectorX* direction = nullptr, bool tangent = true) {
    present.displacement = u;
    return system.assembly.assemble({present, accepted, controls, loads}, direction, tangent, timings);
  }
  VectorX residual(const VectorX& u, const VectorX* direction = nullptr) {
    EXPECT_FALSE(assemble(u, direction));
    return present.force;
  }
  void accept() {
    system.commit(present, accepted);
    accepted = present;
  }
  /// Of the unknowns.
  MatrixX tangent() const {
    const solve::Pattern& pattern = assembly.tangent().pattern;
    MatrixX full = MatrixX::Zero(pattern.size, pattern.size);
    for (int j = 0; j < pattern.size; ++j)
      for (int k = pattern.starts[j]; k < pattern.starts[j + 1]; ++k)
        full(pattern.rows[k], j) = assembly.tangent().values[k];
    return full;
  }
  /// Discrete state, which finite differences must not change.
  std::vector<int> signature() const {
    std::vector<int> result;
    for (std::size_t k = 0; k < system.contacts.size(); ++k) {
      for (const auto& point : present.contacts[k].results) result.push_back(static_cast<int>(point.state));
      for (const auto& block : system.contacts[k]->blocks())
        result.insert(result.end(), {block.slave_element, block.master_element, block.slip_element});
    }
    return result;
  }
};

/// Compares tangent and finite differences at u; returns false if a difference changes the discrete state. Also
/// compares product() in a direction of all prescribed degrees of freedom.
template <int D> bool compare(Bench<D>& bench, const VectorX& u) {
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
    if (bench.unknowns.constrained(dof)) increment(dof) = nurbs::test::uniform(random, -0.1, 0.1);
  const VectorX added = along(increment);
  if (!same) return false;
  EXPECT_LT((slopes - tangent).norm(), 1e-8 * tangent.norm());
  bench.residual(u, &increment);
  EXPECT_LT((bench.assembly.product() - added).norm(), 1e-7 * added.norm());
  return true;
}

} // namespace signorini::model::test
