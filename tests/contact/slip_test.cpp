#include "contact/point/slip.hpp"
#include "contact/point/unfold.hpp"

#include "contact/faces.hpp"

#include <gtest/gtest.h>

namespace signorini::contact {
namespace slip_test {

using namespace test;

TEST(Slip, PointFollowsUntilItIsAtTheGivenDistance) {
  Random random(1);
  for (int trial = 0; trial < 500; ++trial) {
    const Surface<2> surface(wavy(random, 3, 0.3, integer(random, 1, 4), integer(random, 0, 5)),
                             nurbs::side_of("north", 2));
    const nurbs::Space1D& knots = surface.direction(0);
    const auto at = [&](double xi) {
      FacePoint<2> point;
      surface.locate(knots.find_element(xi), FaceCoordinates<2>(xi), 1, point);
      return point;
    };
    const double slip = uniform(random, knots.first(), knots.last());
    const FacePoint<2> foot = at(uniform(random, knots.first(), knots.last()));
    if (!kinks_between(surface, foot, FaceCoordinates<2>(slip)).empty()) continue; // see kink_test.cpp
    const double before = (at(slip).position - foot.position).norm();
    const double length = uniform(random, 0, 1) * before;
    const double after = advance_slip(surface, FaceCoordinates<2>(slip), foot, length)(0);
    EXPECT_GE(after, std::min(slip, foot.xi(0)));
    EXPECT_LE(after, std::max(slip, foot.xi(0)));
    EXPECT_NEAR((at(after).position - foot.position).norm(), length, 1e-13) << "trial " << trial;
  }
}

TEST(Slip, PointStaysAtTheFullDistance) {
  const Surface<2> flat(discretize(nurbs::rectangle(3, 1, Eigen::Vector2d(0, 0)), {8, 3}, "N2", "north"),
                        nurbs::side_of("north", 2));
  FacePoint<2> foot;
  flat.locate(4, FaceCoordinates<2>(0.55), 1, foot);
  EXPECT_NEAR(advance_slip(flat, FaceCoordinates<2>(0.2), foot, 3 * 0.35)(0), 0.2, 1e-15);
  EXPECT_NEAR(advance_slip(flat, FaceCoordinates<2>(0.9), foot, 0.3)(0), 0.65, 1e-14);
}

} // namespace slip_test
} // namespace signorini::contact
