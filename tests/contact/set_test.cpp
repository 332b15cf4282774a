// Sets of faces: ways across their borders, admissible feet, tangents, and what two separate faces have in common with
// two contacts.
#include "contact/tangents.hpp"

#include "contact/faces3d.hpp"
#include "contact/gauss/set_points.hpp"
#include "contact/moved.hpp"

#include <cmath>
#include <numbers>

namespace signorini::contact {
namespace set_test {

using namespace test;

template <int D> Surface<D> set_of(const nurbs::Discretization& body, const std::vector<const char*>& sides) {
  std::vector<Surface<D>> sheets;
  for (const char* side : sides) sheets.emplace_back(body, nurbs::side_of(side, D), 0);
  return Surface<D>(sheets);
}

/// Faces of one body in contact with each other.
template <int D> struct Folded {
  nurbs::Discretization body;
  Pair<D> pair;
  VectorX u;

  Folded(nurbs::Discretization any, const std::vector<const char*>& sides, const Law& law, int points, double thickness,
         bool revolved = false)
      : body(std::move(any)),
        pair(set_of<D>(body, sides),
             Master<D>(set_of<D>(body, sides), 1.0,
                       {std::vector<int>(sides.size(), 0), std::vector<double>(sides.size(), thickness)}),
             law, points, revolved),
        u(VectorX::Zero(D * body.functions())) {}

  int die_dofs() const { return 0; }
  int base_dofs() const { return static_cast<int>(u.size()); }
  int first_extra() const { return base_dofs(); }
  Dense dense() const { return test::dense(pair, 0, base_dofs()); }
  Folded& evaluate() {
    pair.evaluate(u.data(), u.data());
    return *this;
  }
  Folded& shake(Random& random, double size) {
    for (int i = 0; i < u.size(); ++i) u(i) += uniform(random, -size, size);
    return *this;
  }
  /// Moves the control points to map(X).
  template <class Map> Folded& bend(const Map& map) {
    const MatrixX points = body.points();
    for (int i = 0; i < points.cols(); ++i) u.template segment<D>(D * i) = map(Vec<D>(points.col(i))) - points.col(i);
    return *this;
  }
};

// ── Ways across borders ──────────────────────────────────────────────────────────────────────────────────────────────

template <int D> void compare_borders(const Surface<D>& set, int least) {
  FaceGeometry<D> here, there;
  int links = 0;
  for (int e = 0; e < set.elements(); ++e)
    for (int alpha = 0; alpha < D - 1; ++alpha)
      for (const bool at_end : {false, true})
        for (const double part : {0.0, 0.3, 1.0}) {
          if (set.neighbor(e, alpha, at_end) >= 0) continue;
          FaceCoordinates<D> xi;
          for (int d = 0; d < D - 1; ++d) {
            const auto [from, to] = set.interval(e, d);
            xi(d) = d == alpha ? (at_end ? to : from) : (1 - part) * from + part * to;
          }
          const Entry<D> entry = across(set, e, alpha, at_end, xi);
          if (entry.element < 0) continue;
          ++links;
          set.locate(e, xi, 0, here);
          set.locate(entry.element, entry.xi, 0, there);
          EXPECT_LE((here.position - there.position).norm(), 1e-13);
          EXPECT_EQ(set.find_element(entry.xi) == entry.element || part == 0 || part == 1, true);
          const Entry<D> back = across(set, entry.element, entry.alpha, entry.at_end, entry.xi);
          EXPECT_EQ(back.element, e);
          EXPECT_EQ(back.alpha, alpha);
          EXPECT_EQ(back.at_end, at_end);
          EXPECT_LE((back.xi - xi).norm(), 1e-13);
        }
  EXPECT_GE(links, least);
}

TEST(Set, BordersWithCommonControlPointsAreLinked) {
  const nurbs::Discretization block = discretize(nurbs::rectangle(2, 1, Eigen::Vector2d(0, 0)), {3, 2}, "N2", "north");
  compare_borders(set_of<2>(block, {"south", "east", "north", "west"}), 8 * 3);
  compare_borders(set_of<2>(block, {"west", "south", "east"}), 4 * 3);
  const nurbs::Discretization solid =
      discretize(nurbs::block({2, 1, 1.5}, Eigen::Vector3d(0, 0, 0)), {3, 2, 2}, "N2", "back");
  compare_borders(set_of<3>(solid, {"south", "east", "north", "west", "front", "back"}), 24 * 2 * 3);
}

// ── Tangents ─────────────────────────────────────────────────────────────────────────────────────────────────────────

/// A strip bent to an ellipse so flat that its inner faces overlap by 0.01 or more.
Folded<2> closed_loop(const Law& law, unsigned seed) {
  Folded<2> strip(discretize(nurbs::rectangle(10, 0.2, Eigen::Vector2d(0, 0)), {16, 1}, "N2", "north"), {"north"}, law,
                  6, 0.2);
  Random random(seed);
  strip.bend([](const Vec<2>& X) -> Vec<2> {
    const double t = 2 * std::numbers::pi * (0.03 + 0.94 * X(0) / 10), a = 1.6, b = 0.09;
    const Vec<2> out = Vec<2>(b * std::cos(t), a * std::sin(t)).normalized();
    return Vec<2>(a * std::cos(t), b * std::sin(t)) - (X(1) - 0.1) * out;
  });
  strip.shake(random, 0.002);
  return strip;
}

TEST(Set, TangentIsTheForcesDerivativeInAFold) {
  Census census;
  for (unsigned seed = 1; seed <= 3; ++seed)
    for (const double mu : {0.0, 0.3})
      for (const Pass pass : {Pass::full, Pass::half}) {
        Folded<2> loop = closed_loop(Law({100, 80, mu}, {}, pass), seed);
        Random random(seed);
        loop.evaluate().pair.accept();
        for (const double size : {3e-4, 0.003}) {
          loop.shake(random, size);
          compare_with_differences(loop, random, census);
        }
      }
  census.expect({.states = 15, .open = 200, .stick = 100, .slip = 50});
}

/// 3D: a plate bent to a flat tube whose inner faces overlap.
TEST(Set, TangentIsTheForcesDerivativeOfSolids) {
  Census census;
  for (const double mu : {0.0, 0.3})
    for (const Pass pass : {Pass::full, Pass::half}) {
      const nurbs::Discretization plate =
          discretize(nurbs::block({10, 1, 0.2}, Eigen::Vector3d(0, 0, 0)), {10, 2, 1}, "N2", "back");
      Folded<3> tube(plate, {"back"}, Law({100, 800, mu}, {}, pass), 3, 0.2);
      Random random(5);
      tube.bend([](const Vec<3>& X) -> Vec<3> {
        const double t = 2 * std::numbers::pi * (0.03 + 0.94 * X(0) / 10), a = 1.6, b = 0.09;
        const Vec<2> out = Vec<2>(b * std::cos(t), a * std::sin(t)).normalized();
        const Vec<2> at = Vec<2>(a * std::cos(t), b * std::sin(t)) - (X(2) - 0.1) * out;
        return {at(0), X(1), at(1)};
      });
      tube.shake(random, 0.002).evaluate().pair.accept();
      for (const double size : {3e-4, 0.002}) {
        tube.shake(random, size);
        compare_with_differences(tube, random, census);
      }
    }
  census.expect({.states = 6, .stick = 50, .slip = 20});
}

TEST(Set, TangentIsTheForcesDerivativeWhereAnEndPokesIntoAFlank) {
  Census census;
  for (unsigned seed = 1; seed <= 4; ++seed)
    for (const Pass pass : {Pass::full, Pass::half}) {
      // A strip bent by 270 degrees pokes with its end into its flank.
      Folded<2> strip(discretize(nurbs::rectangle(4, 0.5, Eigen::Vector2d(0, 0)), {12, 2}, "N2", "north"),
                      {"south", "east", "north", "west"}, Law({100, 80, 0.3}, {}, pass), 6, 0.5);
      Random random(seed);
      const double tip = uniform(random, 0.01, 0.05);
      strip.bend([&](const Vec<2>& X) -> Vec<2> {
        const double t = 1.5 * std::numbers::pi * std::clamp(X(0) / 3 - 0.2, 0.0, 1.0), r = 0.5;
        const Vec<2> along(std::cos(t), std::sin(t)), across(-std::sin(t), std::cos(t));
        const Vec<2> middle = Vec<2>(r * std::sin(t), r * (1 - std::cos(t)));
        const double straight = X(0) < 0.6 ? X(0) - 0.6 : std::max(X(0) - 3.6, 0.0);
        return middle + straight * along + (X(1) - 0.25) * across + (X(0) > 3.6 ? tip : 0) * along;
      });
      strip.shake(random, 0.002).evaluate().pair.accept();
      strip.shake(random, 0.001);
      compare_with_differences(strip, random, census);
    }
  census.expect({.states = 4, .stick = 20});
}

// ── Admissible feet ──────────────────────────────────────────────────────────────────────────────────────────────────

/// The center line of a strip of length 1 that rolls up at random: its points, and the angles of its tangents.
struct Roll {
  static constexpr int count = 400;
  std::vector<Vec<2>> points{Vec<2>::Zero()};
  std::vector<double> angles{0};

  Roll(Random& random, double most)
      : Roll({uniform(random, -most, most), uniform(random, -most, most), uniform(random, -most, most)}) {}
  explicit Roll(const Vec<3>& turns) {
    const double a = turns(0), b = turns(1), c = turns(2);
    for (int i = 0; i < count; ++i) {
      const double s = (i + 0.5) / count, turn = a + b * std::cos(5 * s) + c * s;
      angles.push_back(angles.back() + turn / count);
      const double middle = 0.5 * (angles[angles.size() - 2] + angles.back());
      points.push_back(points.back() + Vec<2>(std::cos(middle), std::sin(middle)) / count);
    }
  }
  Vec<2> at(double s, double across) const {
    const double place = std::clamp(s, 0.0, 1.0) * count;
    const auto i = std::min(static_cast<std::size_t>(place), points.size() - 2);
    const double part = place - static_cast<double>(i);
    const double angle = (1 - part) * angles[i] + part * angles[i + 1];
    return (1 - part) * points[i] + part * points[i + 1] + across * Vec<2>(-std::sin(angle), std::cos(angle));
  }
  /// Least distance of two points of the center line that are farther apart along it.
  double least_distance(double apart) const {
    double least = 1;
    const auto step = static_cast<std::size_t>(apart * count);
    for (std::size_t i = 0; i < points.size(); i += 2)
      for (std::size_t j = i + step; j < points.size(); j += 2) least = std::min(least, (points[i] - points[j]).norm());
    return least;
  }
};

/// Strips that roll up without overlap have no contact, all around; those whose layers overlap have.
TEST(Set, ContactOfRolledStripsIsThatOfTheirLayers) {
  Random random(4);
  constexpr double thickness = 0.04;
  int apart = 0, overlapping = 0;
  for (int trial = 0; trial < 150; ++trial) {
    const Roll roll(random, 14);
    const double bend = *std::ranges::max_element(roll.angles) - *std::ranges::min_element(roll.angles);
    const double distance = roll.least_distance(3 * thickness);
    // Layers between which no control polygon decides
    const bool free = distance > 1.3 * thickness, overlaps = distance < 0.8 * thickness && distance > 0.6 * thickness;
    if (bend < 3 || (!free && !overlaps)) continue;
    Folded<2> strip(discretize(nurbs::rectangle(1, thickness, Eigen::Vector2d(0, 0)), {60, 1}, "N2", "north"),
                    {"south", "east", "north", "west"}, InterfaceLaw{100, 80}, 4, thickness);
    strip.bend([&](const Vec<2>& X) { return roll.at(X(0), X(1) - thickness / 2); }).evaluate();
    const auto closed = std::ranges::count_if(strip.pair.results(), [](const auto& one) { return touches(one.state); });
    ++(free ? apart : overlapping);
    if (free)
      EXPECT_EQ(closed, 0) << trial;
    else
      EXPECT_GT(closed, 0) << trial;
  }
  EXPECT_GT(apart, 20);
  EXPECT_GT(overlapping, 3);
}

/// A strip that rolls up step by step, and one that does so in a single step, in which no element is alone: the same
/// points touch.
TEST(Set, ElementsThatAreAloneDoNotTouch) {
  Random random(12);
  constexpr double thickness = 0.04;
  const nurbs::Discretization body =
      discretize(nurbs::rectangle(1, thickness, Eigen::Vector2d(0, 0)), {60, 1}, "N2", "north");
  int elements = 0, alone = 0, touching = 0;
  for (int trial = 0; trial < 12; ++trial) {
    const Vec<3> turns(uniform(random, -14, 14), uniform(random, -14, 14), uniform(random, -14, 14));
    Folded<2> strip(body, {"south", "east", "north", "west"}, InterfaceLaw{100, 80}, 4, thickness);
    int closed = 0;
    for (double scale = 0.05; scale < 1 && closed == 0; scale *= 1.03) {
      const Roll roll(scale * turns);
      const auto map = [&](const Vec<2>& X) { return roll.at(X(0), X(1) - thickness / 2); };
      Folded<2> other(body, {"south", "east", "north", "west"}, InterfaceLaw{100, 80}, 4, thickness);
      strip.bend(map).evaluate();
      other.bend(map).evaluate();
      const auto& points = strip.pair.formulation().points();
      for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_EQ(strip.pair.results()[i].state, other.pair.results()[i].state) << trial << ' ' << scale << ' ' << i;
        closed += touches(strip.pair.results()[i].state);
        if (!is_first_of_element(points, i)) continue;
        ++elements;
        alone += is_alone(strip.pair.formulation(), points.list[i].element, strip.pair.present(), strip.pair.history());
      }
      strip.pair.accept();
    }
    touching += closed > 0;
  }
  EXPECT_GT(alone, 9 * elements / 10);
  EXPECT_GT(touching, 5);
}

/// A strip that is bent and carried away: its points are not watched, and yet where the strip is, before and after the
/// state is accepted or dropped.
TEST(Set, PointsThatAreNotWatchedHaveTheirPlaces) {
  Folded<2> strip(discretize(nurbs::rectangle(1, 0.1, Eigen::Vector2d(0, 0)), {12, 1}, "N2", "north"),
                  {"south", "east", "north", "west"}, InterfaceLaw{100, 80, 0.3}, 4, 0.1);
  const Formulation<2>& contact = strip.pair.formulation();
  const auto bend = [&](double step) {
    strip.bend([&](const Vec<2>& X) { return Vec<2>(X(0) + step, X(1) + 0.1 * step * X(0) * X(0)); }).evaluate();
  };
  const auto expect_places = [&](const History<2>& history) {
    for (std::size_t i = 0; i < contact.points().size(); ++i) {
      EXPECT_FALSE(is_watched(history, i)) << i;
      EXPECT_EQ(position(contact, history, i), position(contact.points(), contact.slave(), i)) << i;
    }
  };
  const auto expect_stored = [&] {
    for (std::size_t i = 0; i < contact.points().size(); ++i)
      EXPECT_EQ(strip.pair.history().results[i].position, position(contact.points(), contact.slave(), i)) << i;
  };
  for (const double step : {0.0, 0.3, 0.7}) {
    bend(step);
    expect_places(strip.pair.present());
    strip.pair.accept();
    expect_stored();
  }
  bend(1.5);
  expect_places(strip.pair.present());
  strip.pair.rollback();
  expect_places(strip.pair.present());
  expect_stored();
}

/// An element with a worn point remains watched far from everything, so that its depth is not forgotten.
TEST(Set, PointsWithAPastRemainWatched) {
  for (const double worn : {0.0, 0.01}) {
    Folded<2> strip(discretize(nurbs::rectangle(1, 0.1, Eigen::Vector2d(0, 0)), {12, 1}, "N2", "north"),
                    {"south", "east", "north", "west"}, InterfaceLaw{100, 80}, 4, 0.1);
    History<2> history = strip.pair.history();
    history.points[5].worn = worn;
    strip.pair.restore(history);
    for (int step = 0; step < 2; ++step) {
      strip.evaluate().pair.accept();
      EXPECT_EQ(strip.pair.resultant().max_wear, worn);
      const std::vector<PointRange>& watched = strip.pair.history().watched;
      ASSERT_EQ(watched.size(), worn > 0 ? 1 : 0);
      for (const PointRange& element : watched) EXPECT_EQ(element.last - element.first, 4);
    }
  }
}

/// The least distance of a point of a set from its admissible minima, among those that descents from all elements find.
template <int D> double least_distance(const Surface<D>& set, const Vec<D>& x, const Lookout<D>& from, int starts) {
  double least = std::numeric_limits<double>::infinity();
  FaceGeometry<D> foot;
  for (int e = 0; e < set.elements(); ++e)
    for (int k = 0; k < (D == 2 ? starts : starts * starts); ++k) {
      FaceCoordinates<D> xi;
      for (int d = 0; d < D - 1; ++d) {
        const auto [a, b] = set.interval(e, d);
        xi(d) = a + (b - a) * ((d == 0 ? k % starts : k / starts) + 0.5) / starts;
      }
      walk(set, x, e, xi, foot);
      const Vec<D> line = x - foot.position, normal = outward(set, foot).normalized();
      const double gap = line.dot(normal);
      const bool regular = line.norm() > 1e-9 && std::abs(std::abs(gap) - line.norm()) < 1e-12 * line.norm();
      if (regular && admissible<D>(from, foot, normal, gap, false)) least = std::min(least, std::abs(gap));
    }
  return least;
}

/// Parts that a search leaves out have no foot that counts.
template <int D> void compare_searches(Folded<D>& folded, int every, int& feet) {
  folded.evaluate();
  const auto& faces = folded.pair.formulation().faces();
  const auto& points = folded.pair.formulation().points();
  for (std::size_t i = 0; i < points.size(); i += static_cast<std::size_t>(every)) {
    Lookout<D> from = lookout(faces, points, i);
    from.sight.reach = {};
    const Vec<D> x = position(points, faces.slave, i);
    FaceGeometry<D> foot;
    const Projection<D> found = faces.master.project(x, {}, foot, from);
    const double least = least_distance(*faces.master.surface(), x, from, D == 2 ? 6 : 4);
    if (std::isinf(least)) continue;
    ++feet;
    ASSERT_GE(found.element, 0) << i;
    EXPECT_LE(std::abs(found.gap), least * (1 + 1e-9)) << i;
  }
}

TEST(Set, SearchesFindTheNearestFootThatCounts) {
  Random random(9);
  int feet = 0, feet_of_solids = 0;
  for (int trial = 0; trial < 6; ++trial) {
    constexpr double thickness = 0.04;
    const Roll roll(random, 14);
    Folded<2> strip(discretize(nurbs::rectangle(1, thickness, Eigen::Vector2d(0, 0)), {40, 1}, "N2", "north"),
                    {"south", "east", "north", "west"}, InterfaceLaw{100, 80}, 3, thickness);
    strip.bend([&](const Vec<2>& X) { return roll.at(X(0), X(1) - thickness / 2); });
    compare_searches(strip, 1, feet);
    const double size = uniform(random, 0.2, 0.6);
    Folded<3> plate(discretize(nurbs::block({10, 2, 0.2}, Eigen::Vector3d(0, 0, 0)), {10, 3, 1}, "N2", "back"),
                    {"south", "east", "north", "west", "front", "back"}, InterfaceLaw{100, 80}, 2, 0.2);
    plate.bend([&](const Vec<3>& X) -> Vec<3> {
      const double t = 2 * std::numbers::pi * (0.03 + 0.94 * X(0) / 10), a = 1.6, b = size;
      const Vec<2> out = Vec<2>(b * std::cos(t), a * std::sin(t)).normalized();
      const Vec<2> at = Vec<2>(a * std::cos(t), b * std::sin(t)) - (X(2) - 0.1) * out;
      return {at(0), X(1) + 0.3 * at(0), at(1)};
    });
    plate.shake(random, 0.02);
    compare_searches(plate, 17, feet_of_solids);
  }
  EXPECT_GT(feet, 100);
  EXPECT_GT(feet_of_solids, 30);
}

} // namespace set_test
} // namespace signorini::contact
