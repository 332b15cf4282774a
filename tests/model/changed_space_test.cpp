// Unknowns counted in spaces that are not built, beside those of the spaces that are.
#include "model/changed_space.hpp"

#include "nurbs/coincident.hpp"
#include "nurbs/shapes.hpp"

#include <gtest/gtest.h>

namespace signorini::model {
namespace changed_space_test {

nurbs::Discretisation solid(const nurbs::Patch& patch, std::vector<int> elements, const char* label) {
  nurbs::Plan plan;
  plan.elements = std::move(elements);
  plan.contact = {{2, false}};
  plan.labels.assign(2, nurbs::parse_label(label));
  plan.through = 1;
  return {patch, plan};
}

/// Control points of a space, those that are one point counted once.
int points(const nurbs::Discretisation& space) {
  int count = space.functions();
  for (const auto& group : nurbs::coincident_functions(space)) count -= static_cast<int>(group.size()) - 1;
  return count;
}

const Prescribed nothing = [](int, int, const Place&) { return false; };

TEST(ChangedSpace, PlacesRunAsTheFunctionsDo) {
  for (int through : {0, 1, 2}) {
    nurbs::Plan plan;
    plan.elements = {2, 3, 4};
    plan.contact = {{through, true}};
    plan.labels.assign(2, nurbs::parse_label("N2-N3"));
    plan.through = 1;
    const nurbs::Discretisation space(nurbs::block({1, 2, 3}, Eigen::Vector3d(0, 0, 0)), plan);
    const std::vector<Place> all = places(space);
    const MatrixX x = space.points();
    ASSERT_EQ(static_cast<int>(all.size()), space.functions());
    // In a block the control points of one row rise with their numbers.
    for (std::size_t f = 1; f < all.size(); ++f)
      for (std::size_t d = 0; d < 3; ++d) {
        const auto t = static_cast<std::size_t>(through);
        if (all[f][t] != all[f - 1][t]) continue;
        const auto column = static_cast<Eigen::Index>(f);
        const double step = x(static_cast<Eigen::Index>(d), column) - x(static_cast<Eigen::Index>(d), column - 1);
        EXPECT_EQ(all[f][d] > all[f - 1][d], step > 1e-12) << f;
      }
  }
}

TEST(ChangedSpace, UnchangedCountsPointsOnce) {
  const auto octant = nurbs::sphere_octant(0.5, 1, Eigen::Vector3d(0, 0, 0));
  for (const nurbs::Discretisation& space : {solid(octant, {3, 4, 2}, "N2"), solid(octant, {3, 4, 2}, "N2.1")}) {
    EXPECT_LT(points(space), space.functions());
    EXPECT_EQ(count_free(space, unchanged(space), 3, nothing), 3 * points(space));
  }
}

TEST(ChangedSpace, OneOfSeveralControlPointsThatAreOneHoldsAll) {
  const nurbs::Discretisation space = solid(nurbs::sphere_octant(0.5, 1, Eigen::Vector3d(0, 0, 0)), {3, 4, 2}, "N2");
  const auto groups = nurbs::coincident_functions(space);
  ASSERT_EQ(groups.size(), 3u); // the pole on each of the rows through the shell
  const auto held = [&](int component, int function, const Place&) {
    return component == 1 && function == groups[1].back();
  };
  EXPECT_EQ(count_free(space, unchanged(space), 3, held), 3 * points(space) - 1);
}

TEST(ChangedSpace, FewerFunctionsAlongAPoleKeepItOnePoint) {
  const auto octant = nurbs::sphere_octant(0.5, 1, Eigen::Vector3d(0, 0, 0));
  const nurbs::Discretisation fine = solid(octant, {6, 4, 2}, "N2"), coarse = solid(octant, {3, 4, 2}, "N2");
  ChangedSpace changed = unchanged(fine);
  for (ChangedRow& row : changed) row.along[0] = {0, 1, 2, 3, 7};
  EXPECT_EQ(count_free(fine, changed, 3, nothing), 3 * points(coarse));
}

} // namespace changed_space_test
} // namespace signorini::model
