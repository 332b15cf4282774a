#pragma once
// Discs with mortar contact, and counts of multipliers by state.

#include "contact/couple.hpp"

#include <algorithm>

namespace signorini::contact::test {

constexpr MultiplierSpace multiplier_spaces[] = {MultiplierSpace::equal, MultiplierSpace::reduced};

inline Method mortar(MultiplierSpace space, double mu = 0) {
  return {{100, 80, mu}, space};
}

inline Method multipliers(MultiplierSpace space, double mu = 0) {
  Method method = mortar(space, mu);
  method.law.enforcement = Enforcement::multipliers;
  return method;
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

/// A block that was accepted near a narrower master, so that its outer points have no projection or a faded area.
inline Couple block_beyond_ends(Random& random, const Law& law) {
  Couple couple(discretize(nurbs::rectangle(1, 0.5, Eigen::Vector2d(1, 1)), {6, 1}, "N2", "south"), "south",
                discretize(nurbs::rectangle(0.55, 1, Eigen::Vector2d(1.2, 0)), {4, 1}, "N2", "north"), law, 5);
  couple.shake(random, 0.005).evaluate().accept();
  return couple;
}

/// Number of points without a projection.
inline std::ptrdiff_t beyond(const Pair<2>& pair) {
  return std::count_if(pair.results().begin(), pair.results().end(), [](const auto& one) { return one.beyond; });
}

template <int D> int count(const Pair<D>& pair, ContactState state) {
  return static_cast<int>(std::count_if(pair.multipliers().begin(), pair.multipliers().end(),
                                        [&](const auto& one) { return one.state == state; }));
}

/// Random multipliers: pressures of both signs, friction within and beyond Coulomb's cone.
template <class AnyCouple> void set_multipliers(AnyCouple& couple, Random& random, int each, double mu) {
  for (int i = couple.first_extra(); i < couple.u.size(); ++i)
    couple.u(i) =
        (i - couple.first_extra()) % each == each - 1 ? uniform(random, -0.02, 0.06) : uniform(random, -mu, mu) * 0.03;
}

/// Presses, then drags, with a comparison in each state.
inline Census press_and_slide(Couple couple, unsigned seed, double depth, double mu, const std::vector<double>& drags) {
  Random random(seed);
  Census census;
  const int each = mu > 0 ? 2 : 1;
  couple.shake(random, 0.003).touch().move_die(0, -depth);
  set_multipliers(couple, random, each, mu);
  compare_with_differences(couple, census);
  couple.pair.accept();
  for (double drag : drags) {
    couple.move_die(drag, 0);
    set_multipliers(couple, random, each, mu);
    compare_with_differences(couple, census);
  }
  return census;
}

const std::vector<double> drags_of_laws{3e-4, 0.02, 0.1, -0.03};

/// Presses and drags discs with a law, at points and with mortar, whole and in half passes, in the plane and revolved.
inline Census press_by_law(const InterfaceLaw& law, double duration, unsigned& seed) {
  Census census;
  const auto press = [&](Couple couple) {
    couple.pair.take(duration);
    census.add(press_and_drag(std::move(couple), ++seed, 0.06, drags_of_laws));
  };
  for (const bool revolved : {false, true}) {
    for (const Law& any : {Law(law), Law(law, {}, Pass::half)})
      press(Couple("N2-N2.1", slab("N2"), any, 0.8, 1.0, revolved));
    for (const Law& any : {Law(law, MultiplierSpace::equal), Law(law, MultiplierSpace::reduced, Pass::half)})
      press(pressed_disc("N2", slab("N2"), any, 0.8, 1.0, revolved));
  }
  return census;
}

/// The same with multipliers as unknowns.
inline Census slide_by_law(const InterfaceLaw& own, double duration, unsigned& seed) {
  Law law(own, MultiplierSpace::equal);
  law.law.enforcement = Enforcement::multipliers;
  Couple couple = pressed_disc("N2", slab("N2"), law, 0.8, 1.0);
  couple.pair.take(duration);
  return press_and_slide(std::move(couple), ++seed, 0.06, 0.3, drags_of_laws);
}

} // namespace signorini::contact::test
