// A body with a row of several degrees through a whole model: steps, pictures, cells and checkpoints.
#include "model/bezier_cells.hpp"
#include "model/checkpoint.hpp"
#include "model/scenes.hpp"
#include "model/tessellate.hpp"
#include "nurbs/joins.hpp"
#include "scratch.hpp"

#include <gtest/gtest.h>

namespace signorini::model {
namespace degrees_test {

using namespace test;

const nurbs::Side south{1, false}, north{1, true};
const std::vector<int> mixed{2, 4, 2, 3, 4, 2, 2, 4};

/// The ironing problem with another slab.
Scene<2> ironing_on(nurbs::Discretisation slab) {
  Scene<2> scene = ironing("N2");
  const solid::Material material = scene.bodies[1].body->material();
  scene.bodies[1].body = std::make_shared<const solid::Body<2>>(std::move(slab), material);
  scene.supports[0].on = {held(scene, 1, "south")};
  return scene;
}

TEST(Degrees, AFaceOfSeveralDegreesInARun) {
  Model<2> model(ironing_on(nurbs::test::strip(3, mixed)));
  for (int step = 1; step <= 52; ++step) {
    ASSERT_EQ(ironing_step(model, step).outcome, solve::Outcome::converged) << step;
    accept(model);
  }
  const auto sum = resultant(model.present.contacts[0]);
  ASSERT_GT(sum.active, 10);
  EXPECT_NEAR((sum.force + reaction(model, grip)).norm(), 0, 1e-8);

  // The picture's points on the face are the contact's master points.
  const nurbs::Discretisation& space = model.system.scene.bodies[1].body->space();
  contact::Surface<2> face(space, north);
  const MatrixX displacement = body_displacement(model, 1);
  face.move(displacement.data());
  const int divisions = 4;
  const Tessellation picture = tessellate(model, 1, nullptr, even_sampling<2>(space, divisions), true);
  const int side = divisions + 1;
  for (int e = 0; e < space.elements(0); ++e)
    for (int k = 0; k < side; ++k) {
      const auto [from, to] = face.interval(e, 0);
      contact::FacePoint<2> point;
      face.locate(e, contact::FaceCoordinates<2>(from + (to - from) * k / divisions), 0, point);
      EXPECT_NEAR((picture.points.col((e * side + divisions) * side + k).head<2>() - point.position).norm(), 0, 1e-13);
    }
  EXPECT_EQ(bezier_cells(model, 1, true).degrees[1], (std::vector{4, 1}));

  const signorini::test::ScratchFolder folder;
  save(model, folder.file("run"));
  const auto loaded = std::get<std::shared_ptr<Model<2>>>(load(folder.file("run")));
  EXPECT_EQ(loaded->present.displacement, model.present.displacement);
  for (int step = 53; step <= 56; ++step) {
    ASSERT_EQ(ironing_step(model, step).outcome, solve::Outcome::converged);
    ASSERT_EQ(ironing_step(*loaded, step).outcome, solve::Outcome::converged);
    accept(model);
    accept(*loaded);
  }
  EXPECT_EQ(loaded->present.displacement, model.present.displacement);
}

/// The same functions as a table and as knots lead to the same run, but for rounding.
TEST(Degrees, ATableOfASplineRunsAsItsKnots) {
  Model<2> by_knots(ironing("N2"));
  const nurbs::Discretisation& space = by_knots.system.scene.bodies[1].body->space();
  std::vector<nurbs::Row> rows;
  for (const nurbs::Row& row : space.rows()) {
    const nurbs::Space1D& own = row.direction(0);
    std::vector<nurbs::Element1D> elements;
    for (int e = 0; e < own.elements(); ++e) elements.push_back(own.element(e));
    rows.push_back({{nurbs::Space1D(own.breaks(), own.smoothness(), elements)}, row.homogeneous()});
  }
  Model<2> by_table(ironing_on({space.through(), space.stack(), rows, space.contact()}));
  for (int step = 1; step <= 60; ++step)
    for (Model<2>* model : {&by_knots, &by_table}) {
      ASSERT_EQ(ironing_step(*model, step).outcome, solve::Outcome::converged) << step;
      accept(*model);
    }
  EXPECT_NEAR((by_knots.present.displacement - by_table.present.displacement).norm(), 0, 1e-9);
}

} // namespace degrees_test
} // namespace signorini::model
