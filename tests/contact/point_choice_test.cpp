// Which elements have their full rule, over generated series of contact states.
#include "contact/point/point_choice.hpp"

#include "contact/faces.hpp"

#include <gtest/gtest.h>

namespace signorini::contact {
namespace point_choice_test {

using namespace test;

constexpr int elements = 40;

struct Strip {
  Surface<2> face{discretize(nurbs::rectangle(elements, 1, Eigen::Vector2d(0, 0)), {elements, 1}, "N2", "north"),
                  nurbs::side_of("north", 2)};
  ContactPoints<2> points{face, 9, false, {}, 3};
  History<2> history{points};

  /// The state of a parabolic contact of half width a around x = c, and the rules that follow.
  void step(double c, double a, double moved) {
    std::vector<double> clearance(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double s = (points.reference[i](0) - c) / a;
      history.results[i].state = std::abs(s) < 1 ? ContactState::slip : ContactState::open;
      history.results[i].pressure = std::max(0.0, 1 - s * s);
      clearance[i] = std::max(0.0, 5 * (s * s - 1));
    }
    history.sparse = choose_sparse(points, face, history, moved, [&](auto open, double distance) {
      return std::any_of(open.begin(), open.end(), [&](std::size_t i) { return clearance[i] < distance; });
    });
  }
};

TEST(PointChoice, BothRulesIntegrateTheWholeFace) {
  const Strip strip;
  double full = 0, sparse = 0;
  for (const ContactPoint& point : strip.points.list)
    (point.sparse ? sparse : full) += point.weight * point.reference_area;
  EXPECT_NEAR(full, elements, 1e-12 * elements);
  EXPECT_NEAR(sparse, elements, 1e-12 * elements);
}

TEST(PointChoice, BordersAreFullTheRestIsSparse) {
  Strip strip;
  strip.step(20.3, 8.2, 0.001);
  int full = 0;
  for (int e = 0; e < elements; ++e) {
    const bool border = (e < 12.1 && e + 1 > 12.1) || (e < 28.5 && e + 1 > 28.5);
    if (border) {
      EXPECT_FALSE(strip.history.sparse[e]) << e;
    }
    full += !strip.history.sparse[e];
  }
  EXPECT_LE(full, 8);
  EXPECT_TRUE(strip.history.sparse[20]);
  EXPECT_TRUE(strip.history.sparse[2]);
}

/// A contact that slides over the strip with a border that shakes: each element changes its rule four times at most.
TEST(PointChoice, RulesDoNotAlternate) {
  Random random(1);
  Strip strip;
  std::vector<int> changes(elements);
  for (double c = 4; c < 36; c += 0.05) {
    const std::vector<char> before = strip.history.sparse;
    const double half_width = 3.3 + uniform(random, -0.02, 0.02);
    strip.step(c + uniform(random, -0.02, 0.02), half_width, 0.05);
    for (int e = 0; e < elements; ++e) changes[e] += before[e] != strip.history.sparse[e];
  }
  for (int e = 0; e < elements; ++e) EXPECT_LE(changes[e], 5) << e; // full at first
}

/// Next to an element in which the contact ends, at either end of the face's direction.
TEST(PointChoice, ChoicesDoNotDependOnTheDirectionOfTheFace) {
  for (const double border : {12.5, 27.5}) { // in the middle of an element, which is mixed
    Strip strip;
    const double half_width = 7.5, middle = border < 20 ? border + half_width : border - half_width;
    strip.step(middle, half_width, 0.001);
    const int mixed = static_cast<int>(border), inside = border < 20 ? mixed + 1 : mixed - 1,
              outside = border < 20 ? mixed - 1 : mixed + 1;
    for (const int e : {mixed, inside, outside}) EXPECT_FALSE(strip.history.sparse[e]) << e;
  }
  // Pressures without a border, as of a flat punch, so that the neighbors' states alone decide.
  for (const bool reversed : {false, true}) {
    Strip strip;
    for (std::size_t i = 0; i < strip.points.size(); ++i) {
      const double x = strip.points.reference[i](0), s = reversed ? elements - x : x;
      strip.history.results[i].state = s < 20.5 ? ContactState::stick : ContactState::open;
      strip.history.results[i].pressure = s < 20.5 ? 1 : 0;
    }
    const std::vector<char> sparse =
        choose_sparse(strip.points, strip.face, strip.history, 0.001, [](auto, double) { return false; });
    for (int e = 0; e < elements; ++e) {
      const int s = reversed ? elements - 1 - e : e;
      EXPECT_EQ(sparse[e], s < 19 || s > 21) << e;
    }
  }
}

TEST(PointChoice, ElementsThatTheRegionCutsAreFull) {
  const Strip strip;
  const ContactPoints<2> cut(
      strip.face, 9, false, [](const Vec<2>& x) { return x(0) < 20.5; }, 3);
  const History<2> history(cut);
  const std::vector<char> sparse = choose_sparse(cut, strip.face, history, 0.001, [](auto, double) { return false; });
  EXPECT_FALSE(sparse[20]);
  EXPECT_TRUE(sparse[10]);
}

} // namespace point_choice_test
} // namespace signorini::contact
