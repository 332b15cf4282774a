// The contact area: the part of the slave face inside g = 0, on curves and surfaces with gaps that are linear.
#include "contact/couple.hpp"
#include "contact/faces3d.hpp"
#include "contact/gauss/contact_area.hpp"
#include "contact/mortar_discs.hpp"

#include <gtest/gtest.h>

namespace signorini::contact {
namespace contact_area_test {

using namespace test;

constexpr bool current = false;
constexpr double modulus = 1;

/// A flat face of length 3 above an inclined plane that it meets at x: g < 0 on the left.
TEST(ContactArea, EndsWhereALinearGapOfACurveIsZero) {
  for (const double x : {0.11, 0.8, 1.234, 1.5, 2.9}) {
    const Vec<2> normal = Vec<2>(0.01, 1).normalized();
    Couple couple(discretize(nurbs::rectangle(3, 1, Eigen::Vector2d(0, 0)), {7, 1}, "N2", "south"), "south",
                  make_plane<2>({x, 0}, normal), InterfaceLaw{100, 80, 0}, 4);
    couple.evaluate();
    const ContactArea found = contact_area(couple.pair.formulation(), couple.pair.present(), current, modulus);
    EXPECT_NEAR(found.area, x, 1e-13);
    for (std::size_t i = 0; i < found.inside.size(); ++i)
      EXPECT_EQ(found.inside[i] != 0, couple.pair.reference_positions()[i](0) < x);
  }
}

/// Also where tractions act per reference area, pressures are those on the current area, of closed and open points.
TEST(ContactArea, OfAStretchedFaceIsTheCurrentOne) {
  for (const TractionArea per : {TractionArea::current, TractionArea::reference}) {
    InterfaceLaw law{100, 80, 0};
    law.per = per;
    Couple couple(discretize(nurbs::rectangle(3, 1, Eigen::Vector2d(0, 0)), {7, 1}, "N2", "south"), "south",
                  make_plane<2>({2.468, 0}, {0.01, 1}), law, 4);
    const MatrixX points = couple.die.points();
    for (int i = 0; i < couple.die.functions(); ++i) couple.u(2 * i) = points(0, i);
    couple.evaluate();
    EXPECT_NEAR(contact_area(couple.pair.formulation(), couple.pair.present(), current, modulus).area, 2.468, 1e-13);
  }
}

/// Without a border the area is that of all points, or zero.
TEST(ContactArea, IsThatOfTheFaceOrZeroWithoutABorder) {
  for (const double y : {0.1, -0.1}) {
    Couple couple(discretize(nurbs::rectangle(3, 1, Eigen::Vector2d(0, 0)), {7, 1}, "N2", "south"), "south",
                  make_plane<2>({0, y}, {0, 1}), InterfaceLaw{100, 80, 0}, 4);
    couple.evaluate();
    EXPECT_NEAR(contact_area(couple.pair.formulation(), couple.pair.present(), current, modulus).area, y > 0 ? 3 : 0,
                1e-13);
  }
}

/// A square above an inclined plane: what is inside is bounded by the line a x + b y = c. The strips between the
/// outermost points and the ends of the face, 1/25 of an element wide, have the gaps of these points.
TEST(ContactArea, EndsWhereALinearGapOfASurfaceIsZero) {
  const auto block = discretize(nurbs::block({2, 2, 1}, Eigen::Vector3d(0, 0, 0)), {5, 4, 1}, "N2", "front");
  const Surface<3> face(block, nurbs::side_of("front", 3));
  const VectorX zero = VectorX::Zero(3 * block.functions());
  struct Case {
    Vec<2> slope;
    double c, area;
  };
  // Triangle c²/(2ab), trapezoid, and a strip
  for (const auto& [slope, c, area] :
       {Case{{1, 1}, 0.7, 0.245}, Case{{1, 2}, 0.9, 0.2025}, Case{{1, 0.5}, 1.5, 2}, Case{{1, 0}, 0.37, 0.74}}) {
    const Vec<3> normal = Vec<3>(0.01 * slope(0), 0.01 * slope(1), 1).normalized();
    const Vec<3> place = (c / slope.squaredNorm()) * Vec<3>(slope(0), slope(1), 0);
    Pair<3> pair(face, Obstacle<3>(make_plane<3>(place, normal)), InterfaceLaw{100, 80, 0}, 3);
    pair.evaluate(zero.data(), zero.data());
    EXPECT_NEAR(contact_area(pair.formulation(), pair.present(), current, modulus).area, area, 0.006);
  }
}

} // namespace contact_area_test
} // namespace signorini::contact
