// A model with a row of several degrees: steps and checkpoints.
#include "model/files/checkpoint.hpp"
#include "model/scenes.hpp"
#include "nurbs/joins.hpp"
#include "scratch.hpp"

#include <gtest/gtest.h>

namespace signorini::model {
namespace degrees_test {

using namespace test;

TEST(Degrees, RunWithAPatchFaceSeveralDegrees) {
  Model<2> model(ironing_on(nurbs::test::strip(3, mixed_degrees)));
  for (int step = 1; step <= 52; ++step) {
    ASSERT_EQ(ironing_step(model, step).outcome, solve::Outcome::converged) << step;
    accept(model);
  }
  const auto sum = resultant(model.present.contacts[0]);
  ASSERT_GT(sum.active, 10);
  EXPECT_NEAR((sum.force + reaction(model, grip)).norm(), 0, 1e-8);

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

/// The same functions as a table and by knots give the same run up to rounding error.
TEST(Degrees, ATableOfASplineGivesTheSameRunAsItsKnots) {
  Model<2> by_knots(ironing("N2"));
  const nurbs::Discretization& space = by_knots.system.scene.bodies[1].body->space();
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
