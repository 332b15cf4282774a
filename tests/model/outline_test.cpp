// Outlines of bodies: winding numbers of two kinds, thickness and distances against closed forms.
#include "model/checks/outline.hpp"

#include "model/scenes.hpp"
#include "nurbs/shapes.hpp"

#include <gtest/gtest.h>

namespace signorini::model {
namespace outline_test {

nurbs::Discretization space_of(const nurbs::Patch& patch, const std::vector<int>& elements) {
  nurbs::Plan plan;
  plan.elements = elements;
  plan.labels.assign(elements.size(), nurbs::parse_label("N2"));
  return nurbs::Discretization(patch, plan);
}

template <int D> Outline<D> outline_of(const nurbs::Patch& patch, const std::vector<int>& elements) {
  const nurbs::Discretization space = space_of(patch, elements);
  return Outline<D>(space, space.points());
}

TEST(Outline, ARayFindsTheWindingNumber) {
  const Outline<2> ring = outline_of<2>(nurbs::ring(1, 2, Eigen::Vector2d(0, 0)), {8, 2});
  const Outline<3> block = outline_of<3>(nurbs::block({1, 2, 3}, Eigen::Vector3d(0, 0, 0)), {2, 2, 2});
  for (int i = 0; i < 400; ++i) {
    const Vec<2> x(-2.5 + 0.2513 * (i % 20), -2.5 + 0.2513 * static_cast<double>(i / 20));
    const double r = x.norm();
    const int inside = r > 1 && r < 2;
    if (std::abs(r - 1) > 0.01 && std::abs(r - 2) > 0.01) {
      EXPECT_EQ(ring.layers(x), inside) << x.transpose();
      EXPECT_NEAR(ring.winding(x), inside, 1e-12) << x.transpose();
    }
    const Vec<3> y(x(0), 0.5 + 0.7 * x(1), 0.31 * x(0) + x(1));
    const int within = (y.array() > 0).all() && y(0) < 1 && y(1) < 2 && y(2) < 3;
    EXPECT_EQ(block.layers(y), within) << y.transpose();
    EXPECT_NEAR(block.winding(y), within, 1e-12) << y.transpose();
  }
}

/// Places on vertices and borders of facets seen along the axes.
TEST(Outline, PlacesOnGridLinesAreUnambiguous) {
  const Outline<3> block = outline_of<3>(nurbs::block({1, 1, 1}, Eigen::Vector3d(0, 0, 0)), {2, 2, 2});
  for (int i = 1; i < 8; ++i)
    for (int j = 1; j < 8; ++j) {
      EXPECT_EQ(block.layers({i / 8.0, j / 8.0, 0.5}), 1);
      EXPECT_EQ(block.layers({i / 8.0, j / 8.0, 1.001}), 0);
    }
}

/// A curve that turns twice has winding number 2 where it overlaps itself.
TEST(Outline, CountsLayers) {
  const nurbs::Patch strip = nurbs::rectangle(1, 1, Eigen::Vector2d(0, 0));
  const nurbs::Discretization space = space_of(strip, {16, 1});
  MatrixX points = space.points();
  for (Eigen::Index i = 0; i < points.cols(); ++i) { // bent to 450°
    const double angle = 2.5 * 3.14159265358979 * points(0, i), r = 2 - points(1, i);
    points.col(i) = Vec<2>(r * std::cos(angle), r * std::sin(angle));
  }
  const Outline<2> outline(space, points);
  EXPECT_EQ(outline.layers({1.02, 1.02}), 2);
  EXPECT_EQ(outline.layers({-1.02, -1.02}), 1);
  EXPECT_EQ(outline.layers({0.1, 0.2}), 0);
  EXPECT_NEAR(outline.winding({1.02, 1.02}), 2, 1e-12);
}

TEST(Outline, ThicknessAndDistance) {
  const Outline<2> slab = outline_of<2>(nurbs::rectangle(10, 1, Eigen::Vector2d(0, 0)), {4, 2});
  EXPECT_NEAR(slab.thickness(), 2 * 10.0 / 22, 1e-12);
  const auto near = slab.nearest({3, 0.75}, [](const Facet<2>&) { return true; });
  EXPECT_NEAR(near.distance, 0.25, 1e-14);
  EXPECT_EQ(nurbs::name_of(near.facet->side), "north");
  const auto far = slab.nearest({3, 0.75}, [](const Facet<2>& facet) { return facet.side.direction == 0; });
  EXPECT_NEAR(far.distance, 3, 1e-14);
  const Outline<3> block = outline_of<3>(nurbs::block({1, 1, 1}, Eigen::Vector3d(0, 0, 0)), {2, 2, 2});
  EXPECT_NEAR(block.thickness(), 1.0 / 3, 1e-12);
  const auto corner = block.nearest({2, 2, 2}, [](const Facet<3>&) { return true; });
  EXPECT_NEAR(corner.distance, std::sqrt(3.0), 1e-14);
}

} // namespace outline_test
} // namespace signorini::model
