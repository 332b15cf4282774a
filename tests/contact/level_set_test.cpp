// Level sets: the same closest points and forces as closed-form shapes; forces of others against differences; errors.
#include "contact/couple.hpp"
#include "contact/level_sets.hpp"
#include "contact/method/archive.hpp"

#include <cmath>
#include <functional>
#include <numbers>

namespace signorini::contact {
namespace level_set_test {

using namespace test;

/// Half axes a, b about a center; exponent 2: an ellipse.
LevelSet<2> superellipse(const Vec<2>& center, double a, double b, double exponent) {
  const auto f = [&](const std::vector<Term>& x) {
    return power((1 / a) * (x[0] - center(0)), exponent) + power((1 / b) * (x[1] - center(1)), exponent) - 1;
  };
  return level_set<2>(f, center, 1.2 * std::max(a, b));
}

/// y = depth cos(k (x − 1.3)) − depth, solid below.
LevelSet<2> waves(double depth, double k) {
  const auto f = [&](const std::vector<Term>& x) { return x[1] - depth * cosine(k * (x[0] - 1.3)) + depth; };
  return level_set<2>(f, Vec<2>(1.3, 0), 2);
}

TEST(LevelSet, HasTheClosestPointsOfClosedForms) {
  Random random(1);
  for (int trial = 0; trial < 20; ++trial) {
    const Ball<2> ball = make_ball<2>({uniform(random, -1, 1), uniform(random, -1, 1)}, uniform(random, 0.3, 2));
    const Plane<2> plane = make_plane<2>({uniform(random, -1, 1), uniform(random, -1, 1)},
                                         {uniform(random, -3, 3), uniform(random, 1, 3)});
    for (const auto& [form, formula] : {std::pair<Obstacle<2>, Obstacle<2>>(ball, level_set_of(ball, 3)),
                                        std::pair<Obstacle<2>, Obstacle<2>>(plane, level_set_of(plane, 3))}) {
      Master<2> closed(form), level(formula);
      const Vec<2> shift(uniform(random, -1, 1), uniform(random, -1, 1));
      closed.move(shift.data());
      level.move(shift.data());
      for (int k = 0; k < 20; ++k) {
        const Vec<2> x(uniform(random, -3, 3), uniform(random, -3, 3));
        FacePoint<2> expected, found, again;
        const double gap = closed.project(x, {}, expected).gap;
        const Projection<2> projection = level.project(x, {}, found);
        EXPECT_NEAR(projection.gap, gap, 1e-13);
        EXPECT_TRUE(found.settled);
        EXPECT_NEAR((found.position - expected.position).norm(), 0, 1e-12);
        EXPECT_NEAR((level.normal(found) - closed.normal(expected)).norm(), 0, 1e-12);
        level.locate(projection.point(), again);
        EXPECT_EQ(again.position, found.position);
      }
    }
  }
}

/// The normal from the closest point leads to x, and no sampled point of the curve is nearer.
TEST(LevelSet, ClosestPointIsTheGlobalMinimum) {
  Random random(2);
  const Vec<2> center(0.2, -0.1);
  for (const LevelSet<2>& shape : {superellipse(center, 1.5, 0.6, 2), superellipse(center, 1.5, 0.6, 4), waves(0.3, 4)})
    for (int trial = 0; trial < 200; ++trial) {
      const Master<2> master{Obstacle<2>(shape)};
      const Vec<2> x(uniform(random, -3, 3), uniform(random, -3, 3));
      FacePoint<2> point;
      const double gap = master.project(x, {}, point).gap;
      EXPECT_TRUE(point.settled);
      EXPECT_NEAR((x - point.position - gap * master.normal(point)).norm(), 0, 1e-9);
      const double least = std::sqrt((shape.compiled->mesh.points.colwise() - x).colwise().squaredNorm().minCoeff());
      EXPECT_LE(std::abs(gap), least + 1e-12);
    }
}

TEST(LevelSet, SecondDerivativesAreThoseOfTheClosestPoint) {
  Random random(3);
  for (const LevelSet<2>& shape : {superellipse({0.2, -0.1}, 1.5, 0.6, 4), waves(0.2, 3)})
    for (int trial = 0; trial < 40; ++trial) {
      const Master<2> master{Obstacle<2>(shape)};
      const Vec<2> x(uniform(random, -2, 2), uniform(random, -1, 1)), direction(uniform(random, -1, 1), 0.7);
      FacePoint<2> point, other;
      const Projection<2> found = master.project(x, {}, point);
      const Vec<2> t = point.tangent[0];
      // (τ·τ − g n·x,11) δξ = τ·δx
      const double hessian = t.squaredNorm() - found.gap * master.normal(point).dot(point.second[0]);
      if (hessian < 0.2 || std::abs(found.gap) > 1) continue;
      constexpr double h = 1e-4;
      master.project(x + h * direction, {}, other);
      const Vec<2> after = other.position;
      master.project(x - h * direction, {}, other);
      const Vec<2> slope = (after - other.position) / (2 * h);
      if (slope.norm() > 10) continue; // another branch
      EXPECT_NEAR((slope - t.dot(direction) / hessian * t).norm(), 0, 2e-5) << trial;
    }
}

TEST(LevelSet, TangentIsTheForcesDerivativeInEveryState) {
  Census sum;
  unsigned seed = 100;
  const std::vector<Obstacle<2>> obstacles = {superellipse({1.3, -0.6}, 1.2, 0.6, 2),
                                              superellipse({1.3, -0.6}, 1, 0.6, 4), waves(0.05, 5)};
  for (double mu : {0.0, 0.3})
    for (const Obstacle<2>& obstacle : obstacles)
      sum.add(press_and_drag(Couple("N2-N2.1", obstacle, InterfaceLaw{100, 100, mu}, 1.3, 0.1), ++seed, 0.06,
                             {1e-3, 0.1, 0.25}));
  sum.expect({.states = 15, .stick = 20, .slip = 20});
}

/// Forces along a path with stick and slip, of all kinds of enforcement.
TEST(LevelSet, HasTheForcesOfClosedForms) {
  const Ball<2> ball = make_ball<2>({1.3, -2}, 2);
  const Plane<2> plane = make_plane<2>({1.3, 0}, {0.1, 2});
  const auto path = [](const Obstacle<2>& obstacle, const Law& law, Census& census) {
    std::vector<VectorX> forces;
    Couple couple("N2", obstacle, law, 1.33, 0.1);
    couple.touch().move_die(0, -0.05);
    for (double drag : {0.0, 0.001, 0.03, 0.05, -0.02, -0.1, 0.08}) {
      couple.move_die(drag, 0).evaluate();
      forces.push_back(couple.dense().force);
      census.count(couple.pair);
      couple.pair.accept();
    }
    return forces;
  };
  for (const Law& law : {Law(InterfaceLaw{100, 100, 0.3}), Law({100, 100, 0.3}, MultiplierSpace::equal)})
    for (const auto& [form, formula] : {std::pair<Obstacle<2>, Obstacle<2>>(ball, level_set_of(ball, 2.5)),
                                        std::pair<Obstacle<2>, Obstacle<2>>(plane, level_set_of(plane, 2.5))}) {
      Census census, other;
      const auto expected = path(form, law, census), found = path(formula, law, other);
      EXPECT_GT(census.stick, 20);
      EXPECT_GT(census.slip, 20);
      for (std::size_t k = 0; k < expected.size(); ++k)
        EXPECT_NEAR((found[k] - expected[k]).norm(), 0, 1e-9 * expected[k].norm()) << k;
    }
}

TEST(LevelSet, IsTheSameAfterWritingAndReading) {
  const LevelSet<2> shape = superellipse({0.2, -0.1}, 1.5, 0.6, 4);
  ArchiveWriter to;
  write(to, Obstacle<2>(shape));
  ArchiveReader from(to.bytes());
  const auto again = std::get<LevelSet<2>>(read(from, std::type_identity<Obstacle<2>>()));
  EXPECT_EQ(again.compiled->mesh.points, shape.compiled->mesh.points);
  FacePoint<2> first, second;
  find_closest(shape, Vec<2>(1, 1), first);
  find_closest(again, Vec<2>(1, 1), second);
  EXPECT_EQ(first.xi, second.xi);
  EXPECT_EQ(first.last, second.last);
}

TEST(LevelSet, ErrorsSayWhatIsWrong) {
  const Vec<2> origin(0.01, 0.02);
  const auto of = [&](const std::function<Term(const std::vector<Term>&)>& f) { return level_set<2>(f, origin, 2); };
  EXPECT_ERROR(of([](const auto& x) { return power(x[0], 2) + 1; }), "contact.level_set.no_zero");
  EXPECT_ERROR(of([](const auto& x) { return power(power(x[0], 2) + power(x[1], 2) - 1, 2); }),
               "contact.level_set.no_zero");
  EXPECT_ERROR(of([](const auto& x) { return power(x[0], 0.5) - 1; }), "contact.level_set.not_finite");
  EXPECT_ERROR(of([](const auto& x) { return power(x[0], -1); }), "contact.level_set.jump");
  EXPECT_ERROR(of([](const auto& x) { return power(x[0], 3); }), "contact.level_set.no_gradient");
  EXPECT_ERROR(level_set<2>([](const auto& x) { return x[0]; }, origin, -1), "contact.level_set.box");
  EXPECT_ERROR(make_torus({0, 0, 0}, {0, 0, 1}, 1, 1), "contact.torus.ring");
}

} // namespace level_set_test
} // namespace signorini::contact
