// Lists of faces as one face: grids of parts in any orientation, and lists that are not one surface.
#include "contact/face/face_grid.hpp"

#include "nurbs/directions.hpp"
#include "nurbs/random_patch.hpp"
#include "nurbs/refine.hpp"
#include "nurbs/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace signorini::contact {
namespace face_grid_test {

/// The unit square at {x, y} as a face, turned; its nodes are numbered by their places, which are multiples of 1/2.
FacePart square(double x, double y, const nurbs::Orientation& way, double orientation = 1) {
  nurbs::Patch patch = nurbs::rectangle(1, 1, Vec<2>(x, y));
  for (int d = 0; d < 2; ++d) patch = nurbs::insert_knots(patch, d, {0.5});
  if (way.to[0] == 1) patch = nurbs::swap_directions(patch, 0, 1);
  for (std::size_t k = 0; k < 2; ++k)
    if (way.flip[k]) patch = nurbs::reverse(patch, static_cast<int>(k));
  std::vector<int> nodes;
  const MatrixX points = patch.points();
  for (const auto& point : points.colwise())
    nodes.push_back(static_cast<int>(std::lround(2 * point(0)) + 100 * std::lround(2 * point(1))));
  const bool mirrored = (way.to[0] == 1) != (way.flip[0] != way.flip[1]);
  return {nurbs::make_row(patch), nodes, mirrored ? -orientation : orientation, Message("test.face")};
}

TEST(FaceGrid, PutsPartsInAnyOrientationInTheirPlaces) {
  const auto ways = nurbs::orientations(2);
  for (std::size_t w = 0; w < ways.size(); ++w) {
    std::vector<FacePart> parts;
    for (const auto& [x, y] : {std::array{0, 0}, {1, 0}, {2, 0}, {0, 1}, {1, 1}, {2, 1}})
      parts.push_back(square(x, y, ways[(w + parts.size() * parts.size()) % ways.size()]));
    const FaceGrid whole = arrange(parts, Message("test.list"));
    ASSERT_EQ(whole.nodes.size(), 7U * 5U);
    EXPECT_EQ(whole.orientation, parts.front().orientation);
    const MatrixX points = whole.row.points();
    for (std::size_t a = 0; a < whole.nodes.size(); ++a) {
      const auto point = points.col(static_cast<Eigen::Index>(a));
      EXPECT_EQ(whole.nodes[a], std::lround(2 * point(0)) + 100 * std::lround(2 * point(1)));
    }
    // Points of a grid of 2 × 2 on the elements of a part and of the whole
    const auto point_on = [](const nurbs::Row& row, int element, int point) {
      const int along = row.direction(0).elements();
      const auto [a, b] = row.direction(0).interval(element % along);
      const auto [c, d] = row.direction(1).interval(element / along);
      const auto within = [](double from, double to, int i) { return from + (to - from) * (i == 0 ? 0.25 : 0.75); };
      return nurbs::evaluate(row, Vec<2>(within(a, b, point % 2), within(c, d, point / 2)));
    };
    for (std::size_t k = 0; k < parts.size(); ++k)
      for (int e = 0; e < 4; ++e)
        for (int point = 0; point < 4; ++point) {
          const FacePlace& place = whole.places[k];
          const VectorX expected = point_on(parts[k].row, e, point);
          EXPECT_LT((expected - point_on(whole.row, place.element(e), place.point(point, 2))).norm(), 1e-14);
        }
  }
}

TEST(FaceGrid, ListsThatAreNotOneSurfaceAreErrors) {
  const nurbs::Orientation plain = nurbs::orientations(2).front();
  const auto of = [&](std::vector<FacePart> parts) { arrange(parts, Message("test.list")); };
  const FacePart first = square(0, 0, plain);
  EXPECT_ERROR(of({first, square(2, 0, plain)}), "contact.faces.apart");
  EXPECT_ERROR(of({first, square(1, 1, plain)}), "contact.faces.apart"); // a common corner
  EXPECT_ERROR(of({first, square(1, 0, plain, -1)}), "contact.faces.sides");
  EXPECT_ERROR(of({first, square(1, 0, plain), square(0, 1, plain)}), "contact.faces.grid");
  // The weights of one corner on the border differ by a factor that those of the others do not have.
  FacePart heavier = square(1, 0, plain);
  MatrixX homogeneous = heavier.row.homogeneous();
  homogeneous.col(0) *= 2;
  heavier.row = nurbs::Row(heavier.row.directions(), homogeneous);
  EXPECT_ERROR(of({first, heavier}), "contact.faces.mesh");
}

} // namespace face_grid_test
} // namespace signorini::contact
