// Pictures and cells of a body with a row of several degrees.
#include "model/scenes.hpp"
#include "nurbs/joins.hpp"
#include "tessellation/bezier_cells.hpp"
#include "tessellation/tessellate.hpp"

#include <gtest/gtest.h>

namespace signorini::tessellation {
namespace degrees_test {

using namespace model;
using namespace model::test;

/// The picture's points on the face lie on the contact's master surface.
TEST(Degrees, APictureShowsTheContactFace) {
  const nurbs::Side north{1, true};
  Model<2> model(ironing_on(nurbs::test::strip(3, mixed_degrees)));
  for (int step = 1; step <= 4; ++step) {
    ASSERT_EQ(ironing_step(model, step).outcome, solve::Outcome::converged) << step;
    accept(model);
  }
  const nurbs::Discretization& space = model.system.scene.bodies[1].body->space();
  contact::Surface<2> face(space, north);
  const MatrixX displacement = body_displacement(model, 1);
  ASSERT_GT(displacement.lpNorm<Eigen::Infinity>(), 1e-3);
  face.move(displacement.data());
  const int divisions = 4;
  const Skin picture = tessellate(model, 1, nullptr, even_sampling<2>(space, divisions), true);
  const int side = divisions + 1;
  for (int e = 0; e < space.elements(0); ++e)
    for (int k = 0; k < side; ++k) {
      const auto [from, to] = face.interval(e, 0);
      contact::FacePoint<2> point;
      face.locate(e, contact::FaceCoordinates<2>(from + (to - from) * k / divisions), 0, point);
      EXPECT_NEAR((picture.points.col((e * side + divisions) * side + k).head<2>() - point.position).norm(), 0, 1e-13);
    }
  EXPECT_EQ(bezier_cells(model, 1, true).degrees[1], (std::vector{4, 1}));
}

} // namespace degrees_test
} // namespace signorini::tessellation
