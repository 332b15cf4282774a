// Axisymmetric contact: tangents, and forces and areas of the full circle.
#include "contact/couple.hpp"

#include <cmath>
#include <numbers>

namespace signorini::contact {
namespace revolved_test {

using namespace test;
using std::numbers::pi;

TEST(Revolved, TangentIsTheForcesDerivativeInEveryState) {
  Census sum;
  unsigned seed = 200;
  for (double mu : {0.0, 0.3})
    for (double axis : {0.6, 1.3}) { // the die nearly reaches the axis, or is a ring far from it
      sum.add(press_and_drag(Couple("N2-N2.1", slab("N2"), InterfaceLaw{100, 100, mu}, axis, 1.0, true), ++seed, 0.06,
                             {3e-4, 0.02, 0.3}));
      sum.add(press_and_drag(Couple("N2", make_plane<2>({0, 0}, {0.2, 2}), InterfaceLaw{100, 100, mu}, axis, 0.1, true),
                             ++seed, 0.06, {3e-4, 0.1, 0.3}));
      sum.add(press_and_drag(Couple("N2", make_ball<2>({1, -2}, 2), InterfaceLaw{100, 100, mu}, axis, 0.1, true),
                             ++seed, 0.06, {1e-3, 0.1, 0.3}));
    }
  sum.expect({.states = 35, .open = 500, .stick = 100, .slip = 100});
}

/// A ring r₁ < r < r₂ with a flat bottom, a plane below: F = p π (r₂² − r₁²), 2D integrand of degree 1 in r.
TEST(Revolved, UniformPressureOnAFlatRing) {
  const double inner = 0.4, outer = 1.9, depth = 0.01, penalty = 50;
  const auto ring = discretize(nurbs::rectangle(outer - inner, 0.5, Eigen::Vector2d(inner, 0)), {4, 2}, "N2", "south");
  for (int points : {2, 5}) {
    Couple couple(ring, "south", make_plane<2>({0, 0}, {0, 1}), InterfaceLaw{penalty}, points, true);
    couple.move_die(0, -depth).evaluate();
    const Resultant<2> sum = couple.pair.resultant();
    const double area = pi * (outer * outer - inner * inner);
    EXPECT_NEAR(couple.pair.area(), area, 1e-13 * area);
    EXPECT_NEAR(sum.force(1), penalty * depth * area, 1e-13 * penalty * depth * area);
    EXPECT_NEAR(sum.force(0), 0, 1e-15);
    EXPECT_NEAR(sum.max_pressure, penalty * depth, 1e-13);
    // The pressure acts on the current area: the same ring moved outwards
    couple.move_die(0.3, 0).evaluate();
    const double wider = pi * (std::pow(outer + 0.3, 2) - std::pow(inner + 0.3, 2));
    EXPECT_NEAR(couple.pair.area(), wider, 1e-13 * wider);
  }
}

/// Adhesion acts on the reference area, independent of the ring's current radius.
TEST(Revolved, AdhesionActsOnTheReferenceArea) {
  const Adhesion law{0.1, 0.4};
  const auto ring = discretize(nurbs::rectangle(2, 0.5, Eigen::Vector2d(1, 0)), {4, 2}, "N2", "south");
  Couple couple(ring, "south", make_plane<2>({0, -0.3}, {0, 1}), adhesive(law), 3, true);
  couple.move_die(0.5, 0.05).evaluate();
  const double area = pi * (9 - 1);
  EXPECT_NEAR(couple.pair.resultant().force(1), traction(law, 0.35) * area,
              1e-13 * std::abs(traction(law, 0.35)) * area);
}

/// A sphere's cap pressed into a plane by d has the area 2πR dz per height dz below the plane: F = ∫ ε (d − z) 2πR dz =
/// ε π R d². The edge of the contact area lies inside elements, so the error of the area, whose integrand jumps there,
/// is of the order of the points' distance, and that of the force, whose integrand has a kink, of its square.
TEST(Revolved, SphericalCapConvergesToItsExactForce) {
  const double radius = 0.5, depth = 0.1, penalty = 100;
  const double force = penalty * pi * radius * depth * depth, area = 2 * pi * radius * depth;
  for (int elements : {8, 32, 128, 512}) {
    constexpr int points = 9;
    const auto cap =
        discretize(nurbs::quarter_annulus(0.3, radius, Eigen::Vector2d(0, radius), 270), {elements, 1}, "N2", "south");
    Couple couple(cap, "south", make_plane<2>({0, 0}, {0, 1}), InterfaceLaw{penalty}, points, true);
    couple.move_die(0, -depth).evaluate();
    const Resultant<2> sum = couple.pair.resultant();
    const double spacing = 0.5 * pi * radius / (elements * points), edge = radius * std::acos(1 - depth / radius);
    EXPECT_NEAR(couple.pair.area(), area, 2 * spacing / edge * area);
    EXPECT_NEAR(sum.force(1), force, 2 * std::pow(spacing / edge, 2) * force);
  }
}

} // namespace revolved_test
} // namespace signorini::contact
