// Friction across kinks of a master: the way of slip points around them, and tangents with foot and slip point on two
// sides.
#include "contact/tangents.hpp"

#include <numbers>

namespace signorini::contact {
namespace kink_test {

using namespace test;

enum class Kind { convex, concave, linked };

/// A block with a corner of 90 degrees at the origin: a kink of one face, or the border of two faces of a set.
nurbs::Discretization block_of(Kind kind) {
  if (kind == Kind::linked) return discretize(nurbs::rectangle(1, 1, Eigen::Vector2d(-1, -1)), {3, 3}, "N2", "north");
  return discretize(nurbs::rectangle(2, 1, Eigen::Vector2d(-1, -1)), {6, 1}, "L1", "north");
}

Surface<2> surface_of(const nurbs::Discretization& block, Kind kind) {
  if (kind != Kind::linked) return {block, nurbs::side_of("north", 2)};
  return Surface<2>(std::vector<Surface<2>>{{block, nurbs::side_of("north", 2)}, {block, nurbs::side_of("east", 2)}});
}

/// A strip over the corner of a block.
struct Corner {
  nurbs::Discretization strip, block;
  Pair<2> pair;
  VectorX u;

  Corner(Kind kind, double width, const Law& law, int points)
      : strip(discretize(nurbs::rectangle(width, width, Eigen::Vector2d(-width / 2, 0)), {1, 1}, "L1", "south")),
        block(block_of(kind)),
        pair(Surface<2>(strip, nurbs::side_of("south", 2)), surface_of(block, kind), law, points),
        u(VectorX::Zero(2 * (strip.functions() + block.functions()))) {
    if (kind == Kind::linked) return;
    const MatrixX places = block.points();
    for (int i = 0; i < places.cols(); ++i) {
      const Vec<2> X = places.col(i);
      if (X(0) <= 0) continue;
      const double turn = kind == Kind::convex ? -1 : 1; // of the part beyond the corner
      const Vec<2> x = Vec<2>(-turn * X(1), turn * X(0));
      u.segment<2>(die_dofs() + 2 * i) = x - X;
    }
  }

  int die_dofs() const { return 2 * strip.functions(); }
  int base_dofs() const { return 2 * block.functions(); }
  int first_extra() const { return die_dofs() + base_dofs(); }
  Dense dense() const { return test::dense(pair, die_dofs(), base_dofs()); }
  Corner& evaluate() {
    pair.evaluate(u.data(), u.data() + die_dofs());
    return *this;
  }
  Corner& place(const Vec<2>& at) {
    for (int i = 0; i < strip.functions(); ++i) u.segment<2>(2 * i) = at;
    return *this;
  }
  Corner& shake(Random& random, double size) {
    for (int i = 0; i < u.size(); ++i) u(i) += uniform(random, -size, size);
    return *this;
  }
};

constexpr double depth = 0.01;

/// A place at `depth` below the corner's faces, after a way of its foot along them that passes the corner at 0.
Vec<2> place_on_way(Kind kind, double way) {
  if (kind == Kind::concave) return way < 0 ? Vec<2>(way, -depth) : Vec<2>(depth, way);
  return way < 0 ? Vec<2>(std::min(way, -depth * (1 + 1e-9)), -depth)
                 : Vec<2>(-depth, -std::max(way, depth * (1 + 1e-9)));
}

TEST(Kink, FrictionIsCarriedAroundIt) {
  const Law law({100, 80, 0.3});
  for (const Kind kind : {Kind::convex, Kind::concave, Kind::linked})
    for (const int sign : {1, -1})
      for (const int steps : {10, 57}) {
        Corner corner(kind, 1e-2, law, 1);
        const double start = -0.3 * sign;
        Vec<2> outside = place_on_way(kind, start);
        outside(sign > 0 ? 1 : 0) += (kind == Kind::concave && sign < 0 ? -2 : 2) * depth;
        corner.place(outside).evaluate().pair.accept();
        double area = 0, length = 0, friction = 0;
        for (int step = 0; step <= steps; ++step) {
          if (kind == Kind::concave && 2 * step > steps && length == 0) { // around the corner, where the foot rests
            for (int k = 0; k <= 6; ++k) {
              const double angle = std::numbers::pi / 2 * (sign > 0 ? k : 6 - k) / 6;
              corner.place({depth * std::sin(angle), -depth * std::cos(angle)}).evaluate().pair.accept();
            }
            length = 1;
          }
          corner.place(place_on_way(kind, start * (1 - 2.0 * step / steps))).evaluate().pair.accept();
          const PointResult<2>& result = corner.pair.results()[0];
          const bool second = (2 * step > steps) == (sign > 0);
          if (2 * step == steps) continue;
          const Vec<2> normal = !second ? Vec<2>(0, 1) : kind == Kind::concave ? Vec<2>(-1, 0) : Vec<2>(1, 0);
          area = result.area;
          if (step > 0) {
            EXPECT_NEAR(result.friction.norm(), 0.3 * result.pressure, 1e-10) << step;
          }
          EXPECT_NEAR(result.pressure, 1, 1e-10) << step;
          EXPECT_NEAR(result.friction.dot(normal), 0, 1e-10) << step;
          friction = result.friction.norm();
        }
        const double elastic = friction / 80;
        EXPECT_NEAR(corner.pair.dissipated() / (area * friction), 0.6 - elastic, 1e-10)
            << static_cast<int>(kind) << sign << steps;
      }
}

TEST(Kink, TangentIsTheForcesDerivativeWithTheSlipPointAcrossIt) {
  Census census;
  Random random(3);
  for (const Kind kind : {Kind::convex, Kind::concave, Kind::linked})
    for (int trial = 0; trial < 12; ++trial) {
      Corner corner(kind, 1e-3, Law({100, 80, trial % 3 == 0 ? 5.0 : 0.3}), 3);
      corner.shake(random, 0.003);
      const VectorX shape = corner.u;
      const auto at = [&](const Vec<2>& place) {
        corner.u.head(corner.die_dofs()) = shape.head(corner.die_dofs()) * 0.01;
        for (int i = 0; i < corner.strip.functions(); ++i) corner.u.segment<2>(2 * i) += place;
        corner.evaluate();
      };
      const double before = uniform(random, -0.03, -0.01), after = uniform(random, 0.01, 0.03);
      at(place_on_way(kind, before) + Vec<2>(0, 3 * depth));
      corner.pair.accept();
      at(place_on_way(kind, before));
      corner.pair.accept();
      if (kind == Kind::concave && trial % 2 == 0) {
        const double angle = uniform(random, 0.3, 1.2); // the foot is the corner
        at({depth * std::sin(angle), -depth * std::cos(angle)});
      } else {
        at(place_on_way(kind, after));
      }
      compare_with_differences(corner, random, census);
    }
  census.expect({.states = 25, .stick = 20, .slip = 30});
}

} // namespace kink_test
} // namespace signorini::contact
