#pragma once
// Comparison of a contact's tangent with finite differences of its force.

#include "contact/faces.hpp"
#include "differences.hpp"

#include <gtest/gtest.h>

namespace signorini::contact::test {

/// Discrete state, which finite differences must not change.
template <int D> std::vector<int> signature(const Pair<D>& pair) {
  std::vector<int> result;
  for (const auto& point : pair.results()) result.insert(result.end(), {static_cast<int>(point.state), point.beyond});
  for (const auto& point : pair.present().points)
    result.insert(result.end(), {static_cast<int>(point.projection.foot), point.projection.element});
  for (std::size_t i = 0; i < pair.present().bonds.size(); ++i) {
    const auto &bond = pair.present().bonds[i], &before = pair.history().bonds[i];
    result.insert(result.end(), {bond.largest > before.largest, bond.left < before.left, bond.left == 0});
  }
  for (const auto& multiplier : pair.multipliers()) result.push_back(static_cast<int>(multiplier.state));
  for (const Block& block : pair.blocks())
    result.insert(result.end(), {block.slave_element, block.master_element, block.slip_element});
  return result;
}

/// True where wear without friction has a kink, |Δγ| at points that hardly move.
template <int D> bool rests(const Pair<D>& pair) {
  constexpr double little = 1e-6;
  const auto rests = [&](const auto& one) { return one.mu == 0 && one.worn > 0 && one.worn < little; };
  return std::ranges::any_of(pair.results(), rests) || std::ranges::any_of(pair.multipliers(), rests);
}

/// The force of a state, evaluated without its tangent.
template <class AnyCouple> VectorX force_at(AnyCouple& couple, const VectorX& at) {
  couple.pair.evaluate(at.data(), at.data() + couple.die_dofs(), false, at.data() + couple.first_extra());
  return dense(couple.pair, couple.die_dofs(), couple.base_dofs(), false).force;
}

/// Compares the force without a tangent with that of `at`, and products of the tangent with random directions with
/// differences of the force in the couple's present state; false as soon as a difference changes the discrete state.
template <class AnyCouple> bool holds_in_random_directions(AnyCouple& couple, const Dense& at, Random& random) {
  EXPECT_LE((force_at(couple, couple.u) - at.force).norm(), 1e-13 * at.force.norm());
  const std::vector<int> before = signature(couple.pair);
  for (int k = 0; k < 8; ++k) {
    VectorX direction(couple.u.size());
    for (int i = 0; i < direction.size(); ++i) direction(i) = uniform(random, -1, 1);
    bool crossed = false;
    const VectorX slope = signorini::test::derivative<VectorX>(
        [&](double h) {
          VectorX force = force_at(couple, couple.u + h * direction);
          crossed = crossed || signature(couple.pair) != before || rests(couple.pair);
          return force;
        },
        2e-6);
    if (crossed) return false;
    EXPECT_LE((slope - at.tangent * direction).norm(), 2e-8 * at.tangent.norm());
  }
  return true;
}

} // namespace signorini::contact::test
