#pragma once
// A face above a master in the plane.

#include "contact/moved.hpp"

namespace signorini::contact::test {

struct Couple : Moved<2, Couple> {
  using Moved::Moved, Moved::move_die;
  Couple(nurbs::Discretization slave, const std::string& side, nurbs::Discretization master, const Law& law, int points,
         bool revolved = false)
      : Moved(std::move(slave), side, std::move(master), "north", law, points, revolved) {}
  /// A half annulus of radius 0.5 whose lowest point is (x, y).
  template <class AnyMaster, class AnyLaw = InterfaceLaw>
  Couple(const std::string& label, AnyMaster master, const AnyLaw& law, double x, double y, bool revolved = false)
      : Couple(discretize(nurbs::half_annulus(0.3, 0.5, Eigen::Vector2d(x, y + 0.5)), {6, 2}, label, "south"), "south",
               std::move(master), law, 9, revolved) {}

  Couple& move_die(double x, double y) { return move_die({x, y}); }
};

inline nurbs::Discretization slab(const std::string& label) {
  return discretize(nurbs::rectangle(3, 1, Eigen::Vector2d(0, 0)), {8, 3}, label, "north");
}

inline void compare_with_differences(Couple& couple, Census& census) {
  Random random(1);
  compare_with_differences(couple, random, census);
}

/// Presses, then drags by `drags` with a comparison after each, starting from random displacements.
inline Census press_and_drag(Couple couple, unsigned seed, double depth, const std::vector<double>& drags) {
  Random random(seed);
  Census census;
  couple.shake(random, 0.005).touch().move_die(0, -depth).shake(random, 0.002);
  compare_with_differences(couple, census);
  couple.pair.accept();
  for (double drag : drags) {
    couple.move_die(drag, 0).shake(random, 0.0005);
    compare_with_differences(couple, census);
  }
  return census;
}

} // namespace signorini::contact::test
