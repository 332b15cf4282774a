#pragma once
// Bonded faces in 2D and 3D for tests.

#include "contact/moved.hpp"

namespace signorini::contact::test {

/// Faces that coincide at first.
template <int D> struct Bonded : Moved<D, Bonded<D>> {
  Bonded(nurbs::Discretization slave, const std::string& side, nurbs::Discretization master,
         const std::string& master_side, const Law& law, bool revolved = false)
      : Moved<D, Bonded>(std::move(slave), side, std::move(master), master_side, law, 4, revolved) {
    this->evaluate().accept();
  }
  Bonded(nurbs::Discretization slave, const std::string& side, const Obstacle<D>& master, const Law& law,
         bool revolved = false)
      : Moved<D, Bonded>(std::move(slave), side, master, law, 4, revolved) {
    this->evaluate().accept();
  }
  Bonded& place_die(const Vec<D>& at) {
    this->u.setZero();
    return this->move_die(at).evaluate();
  }
};

template <int D> void compare(Bonded<D>& couple, Random& random, bool symmetric, Census& census) {
  const Dense at = couple.evaluate().dense();
  if (symmetric) {
    EXPECT_LE((at.tangent - at.tangent.transpose()).norm(), 1e-12 * at.tangent.norm());
  }
  compare_with_differences(couple, random, census);
}

/// Lifts, lowers, presses and drags the die, in directions e_last and e_first.
template <int D> void move_and_compare(Bonded<D>& couple, unsigned seed, bool symmetric, Census& census) {
  Random random(seed);
  const Vec<D> up = Vec<D>::Unit(D - 1), along = Vec<D>::Unit(0);
  const std::vector<Vec<D>> path = {
      0.005 * up, 0.02 * up + 0.01 * along,  -0.012 * up,   -0.016 * up + 0.01 * along, 0.02 * along,
      0.05 * up,  -0.06 * up + 0.03 * along, -0.004 * along};
  for (const Vec<D>& move : path) {
    couple.move_die(move).shake(random, 4e-4);
    compare(couple, random, symmetric, census);
    couple.pair.accept();
  }
}

inline Method with(const Cohesion& cohesion, double mu = 0) {
  return {{100, 60, mu, TractionArea::reference}, {}, Pass::full, cohesion};
}

inline nurbs::Discretization strip(const std::string& label) {
  return discretize(nurbs::rectangle(3, 0.5, Eigen::Vector2d(0.2, 0)), {7, 1}, label, "south");
}
inline nurbs::Discretization ground(int elements) {
  return discretize(nurbs::rectangle(3.4, 1, Eigen::Vector2d(0, -1)), {elements, 1}, "N2", "north");
}
/// Half rings below (3, 0): the outer face of the inner one meets the inner face of the outer one at radius 1.
inline nurbs::Discretization ring(double inner, double outer, int elements, const std::string& side) {
  return discretize(nurbs::half_annulus(inner, outer, Eigen::Vector2d(3, 0)), {elements, 1}, "N3", side);
}
inline nurbs::Discretization block(double z, double margin, std::vector<int> elements, const std::string& contact) {
  nurbs::Plan plan;
  plan.elements = std::move(elements);
  plan.contact = {nurbs::side_of(contact, 3)};
  plan.labels.assign(2, nurbs::parse_label("N2"));
  plan.thickness_degree = 1;
  return nurbs::Discretization(
      nurbs::block({1 + 2 * margin, 1 + 2 * margin, 0.5}, Eigen::Vector3d(-margin, -margin, z)), plan);
}

} // namespace signorini::contact::test
