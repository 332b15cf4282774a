// Faces with elements of different degree and number of functions, as slave and as master: geometry, functions,
// projection and contact tangent.
#include "contact/couple.hpp"

#include "nurbs/joins.hpp"

namespace signorini::contact {
namespace degrees_test {

using namespace test;

const std::vector<int> mixed{2, 4, 1, 3, 4, 2, 2, 4};

TEST(Degrees, APatchFaceSeveralDegrees) {
  Random random(1);
  const nurbs::Discretization body = nurbs::test::strip(3, mixed);
  Surface<2> surface(body, {1, true});
  surface.extend(0.3);
  VectorX u(2 * body.functions());
  for (int i = 0; i < u.size(); ++i) u(i) = uniform(random, -0.05, 0.05);
  surface.move(u.data());
  ASSERT_EQ(surface.elements(), 10);
  EXPECT_EQ(surface.most_functions(), 5);
  for (int e = 0; e < surface.elements(); ++e) {
    EXPECT_EQ(surface.functions_on(e), surface.degree(e, 0) + 1);
    EXPECT_EQ(surface.degree(e, 0), mixed[std::clamp(e - 1, 0, 7)]);
    const auto [from, to] = surface.interval(e, 0);
    const double xi = uniform(random, from, to);
    EXPECT_EQ(surface.find_element(FaceCoordinates<2>(xi)), e);
    FacePoint<2> point;
    surface.locate(e, FaceCoordinates<2>(xi), 2, point);
    surface.functions(point, 1);
    Vec<2> sum = Vec<2>::Zero(), slope = Vec<2>::Zero();
    for (int a = 0; a < surface.functions_on(e); ++a) {
      sum += point.value[a] * surface.points().col(surface.nodes(e)[a]);
      slope += point.derivative[0][a] * surface.points().col(surface.nodes(e)[a]);
    }
    EXPECT_NEAR((sum - point.position).norm(), 0, 1e-14);
    EXPECT_NEAR((slope - point.tangent[0]).norm(), 0, 1e-12);
    const auto tangent_at = [&](double h) {
      FacePoint<2> moved;
      surface.locate(e, FaceCoordinates<2>(xi + h), 1, moved);
      return VectorX(moved.tangent[0]);
    };
    EXPECT_NEAR((signorini::test::derivative<VectorX>(tangent_at, 1e-5) - point.second[0]).norm(), 0, 1e-6);
  }
}

TEST(Degrees, ProjectionFindsTheNearestPoint) {
  Random random(2);
  const nurbs::Discretization body = nurbs::test::strip(3, mixed);
  for (int trial = 0; trial < 20; ++trial) {
    Master<2> master(Surface<2>(body, {1, true}));
    VectorX u(2 * body.functions());
    for (int i = 0; i < u.size(); ++i) u(i) = uniform(random, -0.05, 0.05);
    master.move(u.data());
    const Vec<2> x(uniform(random, 0.2, 2.8), uniform(random, 0.8, 1.4));
    FacePoint<2> point;
    const Projection<2> found = master.project(x, {}, point);
    double least = std::numeric_limits<double>::infinity();
    for (int e = 0; e < master.surface()->elements(); ++e)
      for (int k = 0; k <= 1000; ++k) {
        const auto [from, to] = master.surface()->interval(e, 0);
        FacePoint<2> sample;
        master.surface()->locate(e, FaceCoordinates<2>(from + (to - from) * k / 1000), 0, sample);
        least = std::min(least, (x - sample.position).norm());
      }
    EXPECT_LE(std::abs(found.gap), least + 1e-12);
    EXPECT_NEAR(std::abs(found.gap), least, 1e-4);
    EXPECT_TRUE(point.settled);
  }
}

TEST(Degrees, TangentIsTheForcesDerivative) {
  const nurbs::Discretization base = nurbs::test::strip(3, mixed);
  Census sum;
  Random random(3);
  unsigned seed = 0;
  // Small drags stick, longer ones slip; after the last, slip points lie in elements with other functions.
  for (const char* label : {"N2", "N2-N2.2"})
    for (double x : {0.8, 1.6})
      sum.add(press_and_drag(Couple(label, base, {100, 50, 0.3}, x, 1.0), ++seed, 0.05, {3e-4, 0.02, -0.06, 0.45}));
  // As slave, above a smooth face
  for (int trial = 0; trial < 4; ++trial)
    sum.add(press_and_drag(Couple(nurbs::test::strip(1, {2, 4, 3}, "south"), "south", wavy(random, 3, 0.1, 2, 5),
                                  InterfaceLaw{100, 50, 0.3}, 6),
                           ++seed, 0.04, {3e-4, 0.05}));
  sum.expect({.states = 12, .stick = 40, .slip = 40, .elsewhere = 3});
}

} // namespace degrees_test
} // namespace signorini::contact
