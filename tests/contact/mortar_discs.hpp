#pragma once
// Discs with mortar contact, and counts of multipliers by state.

#include "contact/couple.hpp"

#include <algorithm>

namespace signorini::contact::test {

constexpr MultiplierSpace multiplier_spaces[] = {MultiplierSpace::equal, MultiplierSpace::reduced};

inline MortarLaw mortar(MultiplierSpace space, double mu = 0) {
  return {{100, 80, mu}, space};
}

/// A half annulus of radius 0.5 with small elements whose lowest point is (x, y).
template <class AnyMaster>
Couple pressed_disc(const std::string& label, AnyMaster master, const Law& own, double x, double y,
                    bool revolved = false) {
  return {discretize(nurbs::half_annulus(0.3, 0.5, Eigen::Vector2d(x, y + 0.5)), {14, 2}, label, "south"),
          "south",
          std::move(master),
          own,
          6,
          revolved};
}

template <int D> int count(const Pair<D>& pair, ContactState state) {
  return static_cast<int>(std::count_if(pair.multipliers().begin(), pair.multipliers().end(),
                                        [&](const auto& one) { return one.state == state; }));
}

} // namespace signorini::contact::test
