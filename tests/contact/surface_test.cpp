// Contact faces against their patches, undeformed and displaced, and the direction of outward normals.
#include "contact/face/surface.hpp"

#include "contact/faces.hpp"

#include <gtest/gtest.h>

namespace signorini::contact {
namespace surface_test {

using namespace test;

template <int D> void agrees_with_its_patch(Random& random, const nurbs::Discretization& body, nurbs::Side side) {
  Surface<D> surface(body, side);
  VectorX u(D * body.functions());
  for (int i = 0; i < u.size(); ++i) u(i) = uniform(random, -0.05, 0.05);
  surface.move(u.data());
  const nurbs::Patch rest = nurbs::test::patch_of(body.face(side));
  const nurbs::Patch patch = nurbs::make_patch(rest.directions(), surface.points(), rest.weights());
  ASSERT_EQ(surface.functions(), patch.functions());
  const std::vector<int> functions = body.face_functions(side);
  for (int i = 0; i < surface.functions(); ++i) {
    EXPECT_EQ(surface.body_function(i), functions[static_cast<std::size_t>(i)]);
    EXPECT_NEAR((surface.points().col(i) - rest.points().col(i) - u.segment<D>(D * surface.body_function(i))).norm(), 0,
                1e-15);
  }

  FacePoint<D> point;
  for (int trial = 0; trial < 10; ++trial) {
    const int e = integer(random, 0, surface.elements() - 1);
    FaceCoordinates<D> xi;
    for (int alpha = 0; alpha < D - 1; ++alpha) {
      const auto [a, b] = surface.interval(e, alpha);
      xi(alpha) = uniform(random, a, b);
    }
    surface.locate(e, xi, 2, point);
    surface.functions(point, 1);
    EXPECT_EQ(point.element, e);
    const auto expected = nurbs::derivatives(patch, xi, 2);
    EXPECT_NEAR((point.position - expected[0].value).norm(), 0, 1e-13);
    for (std::size_t k = 0; k < D - 1; ++k)
      EXPECT_NEAR((point.tangent[k] - expected[1 + k].value).norm(), 0, 1e-12 * (1 + expected[1 + k].value.norm()));
    for (std::size_t k = 0; k < FacePoint<D>::seconds; ++k)
      EXPECT_NEAR((point.second[k] - expected[D + k].value).norm(), 0, 1e-11 * (1 + expected[D + k].value.norm()));

    // The functions reproduce position and tangents, and agree with those of the patch.
    Vec<D> position = Vec<D>::Zero(), tangent = Vec<D>::Zero();
    const auto basis = nurbs::rational_basis(patch, xi);
    ASSERT_EQ(basis.size(), static_cast<std::size_t>(surface.functions_on(e)));
    for (std::size_t a = 0; a < basis.size(); ++a) {
      EXPECT_EQ(surface.nodes(e)[a], basis[a].function);
      EXPECT_NEAR(point.value[a], basis[a].value, 1e-14);
      position += point.value[a] * surface.points().col(surface.nodes(e)[a]);
      tangent += point.derivative[D - 2][a] * surface.points().col(surface.nodes(e)[a]);
    }
    EXPECT_NEAR((position - point.position).norm(), 0, 1e-14);
    EXPECT_NEAR((tangent - point.tangent[D - 2]).norm(), 0, 1e-12 * (1 + tangent.norm()));

    // The element's box contains it.
    Vec<D> lower, upper;
    bounds(surface.bezier(e), lower, upper);
    EXPECT_GE((point.position - lower).minCoeff(), -1e-14);
    EXPECT_GE((upper - point.position).minCoeff(), -1e-14);
  }
}

TEST(Surface, AgreesWithItsPatchIn2D) {
  Random random(1);
  for (int trial = 0; trial < 10; ++trial)
    agrees_with_its_patch<2>(random, wavy(random, 3, 0.5, integer(random, 1, 4), integer(random, 0, 4)),
                             nurbs::side_of("north", 2));
  const nurbs::Patch die = nurbs::half_annulus(0.3, 0.5, Eigen::Vector2d(0, 0));
  for (const char* label : {"N2", "N6", "N2-N2.3", "N2-N4", "L2"})
    agrees_with_its_patch<2>(random, discretize(die, {6, 2}, label, "south"), nurbs::side_of("south", 2));
  // Equal weights that are not 1
  const nurbs::KnotVector line = nurbs::KnotVector::single(2);
  agrees_with_its_patch<2>(random, below(line, MatrixX::Random(2, 3), VectorX::Constant(3, 0.7)),
                           nurbs::side_of("north", 2));
}

TEST(Surface, AgreesWithItsPatchIn3D) {
  Random random(2);
  const nurbs::Patch shell = nurbs::half_cylinder_shell(0.4, 0.6, 1, Eigen::Vector3d(0, 0, 0));
  for (const char* label : {"N2", "N2-N2.1", "N3"}) {
    const nurbs::Discretization body = discretize(shell, {4, 2, 1}, label, "front");
    agrees_with_its_patch<3>(random, body, nurbs::side_of("front", 3));
    agrees_with_its_patch<3>(random, body, nurbs::side_of("back", 3));
  }
}

template <int D> void normals_point_out(const nurbs::Patch& patch) {
  const int through = D - 1;
  const nurbs::Discretization body = discretize(patch, std::vector<int>(D, 2), "N2", nurbs::name_of({through, false}));
  for (int d = 0; d < D; ++d)
    for (bool at_end : {false, true}) {
      const nurbs::Side side{d, at_end};
      const Surface<D> surface(body, side);
      FacePoint<D> point;
      for (int e = 0; e < surface.elements(); ++e) {
        VectorX xi(D);
        FaceCoordinates<D> on_face;
        xi(d) = at_end ? patch.direction(d).last() : patch.direction(d).first();
        for (int k = 0, alpha = 0; k < D; ++k) {
          if (k == d) continue;
          const auto [a, b] = surface.interval(e, alpha);
          xi(k) = on_face(alpha++) = 0.3 * a + 0.7 * b;
        }
        surface.locate(e, on_face, 1, point);
        const Vec<D> out = outward(surface, point);
        const Vec<D> leaving =
            (at_end ? 1 : -1) * nurbs::derivatives(patch, xi, 1)[1 + static_cast<std::size_t>(d)].value;
        EXPECT_GT(out.dot(leaving), 0.1 * out.norm() * leaving.norm()) << nurbs::name_of(side);
        double measure = point.tangent[0].norm();
        for (const auto& tangent : point.tangent) EXPECT_NEAR(out.dot(tangent), 0, 1e-13 * out.norm() * tangent.norm());
        if constexpr (D == 3) measure = point.tangent[0].cross(point.tangent[1]).norm();
        EXPECT_NEAR(out.norm(), measure, 1e-13 * measure);
      }
    }
}

TEST(Surface, NormalsPointOutOfAllFaces) {
  normals_point_out<2>(nurbs::rectangle(2, 1, Eigen::Vector2d(0, 0)));
  normals_point_out<2>(nurbs::half_annulus(0.3, 0.5, Eigen::Vector2d(0, 0)));
  normals_point_out<3>(nurbs::block({1, 2, 3}, Eigen::Vector3d(0, 0, 0)));
  normals_point_out<3>(nurbs::half_cylinder_shell(0.4, 0.6, 1, Eigen::Vector3d(0, 0, 0)));
}

TEST(Surface, NeighborsShareTheirBorder) {
  const nurbs::Discretization body =
      discretize(nurbs::block({3, 2, 1}, Eigen::Vector3d(0, 0, 0)), {3, 2, 1}, "N2", "back");
  const Surface<3> surface(body, nurbs::side_of("back", 3));
  ASSERT_EQ(surface.elements(), 6);
  for (int e = 0; e < 6; ++e)
    for (int alpha = 0; alpha < 2; ++alpha)
      for (bool at_end : {false, true}) {
        const int next = surface.neighbor(e, alpha, at_end);
        const int index = alpha == 0 ? e % 3 : e / 3, count = alpha == 0 ? 3 : 2;
        EXPECT_EQ(next < 0, index == (at_end ? count - 1 : 0));
        if (next < 0) continue;
        EXPECT_EQ(surface.neighbor(next, alpha, !at_end), e);
        EXPECT_EQ(surface.interval(e, alpha)[at_end ? 1 : 0], surface.interval(next, alpha)[at_end ? 0 : 1]);
        EXPECT_EQ(surface.interval(e, 1 - alpha), surface.interval(next, 1 - alpha));
      }
}

template <int D> void samples_its_grid(Random& random, const nurbs::Discretization& body, nurbs::Side side) {
  Surface<D> surface(body, side);
  VectorX u(D * body.functions());
  for (int i = 0; i < u.size(); ++i) u(i) = uniform(random, -0.05, 0.05);
  surface.move(u.data());
  FaceGeometry<D> point;
  for (int e = 0; e < surface.elements(); ++e) {
    const int n = 3 * surface.degree(e, 0) + 3, m = D == 2 ? 1 : 3 * surface.degree(e, D - 2) + 3;
    std::vector<double> positions(D * n * m);
    sample(surface.bezier(e), positions.data());
    Vec<D> lower, upper, direction;
    bounds(surface.bezier(e), lower, upper);
    for (int d = 0; d < D; ++d) direction(d) = uniform(random, -1, 1);
    const double least = least_along(surface.bezier(e), direction);
    for (int k = 0; k < n * m; ++k) {
      FaceCoordinates<D> xi;
      for (int d = 0; d < D - 1; ++d) {
        const auto [from, to] = surface.interval(e, d);
        xi(d) = from + (to - from) * (d == 0 ? k % n : k / n) / ((d == 0 ? n : m) - 1);
      }
      surface.locate(e, xi, 0, point);
      for (int d = 0; d < D; ++d) EXPECT_NEAR(positions[d * n * m + k], point.position(d), 1e-13);
      EXPECT_TRUE((point.position.array() >= lower.array() - 1e-13).all());
      EXPECT_TRUE((point.position.array() <= upper.array() + 1e-13).all());
      EXPECT_GE(direction.dot(point.position), least - 1e-13);
    }
  }
}

TEST(Surface, SamplesItsGridWithinItsBounds) {
  Random random(7);
  for (const char* label : {"N2", "N3", "N2-N4", "N7"}) {
    samples_its_grid<2>(random, wavy(random, 3, 0.3, integer(random, 1, 4), 3), nurbs::side_of("north", 2));
    samples_its_grid<2>(random, discretize(nurbs::rectangle(3, 1, Eigen::Vector2d(0, 0)), {4, 2}, label, "north"),
                        nurbs::side_of("north", 2));
    for (const nurbs::Patch& patch : {nurbs::block({3, 2, 1}, Eigen::Vector3d(0, 0, 0)),
                                      nurbs::spherical_indenter(10, 10, 11, 7.5, 1, Eigen::Vector3d(0, 0, 0))})
      samples_its_grid<3>(random, discretize(patch, {3, 2, 1}, label, "front"), nurbs::side_of("front", 3));
  }
}

} // namespace surface_test
} // namespace signorini::contact
