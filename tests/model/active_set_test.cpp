// Active set over iterations: freezing, fixing of points and detection of cycling, on a strip with a given contact
// area.
#include "model/steps/active_set.hpp"

#include "contact/faces.hpp"

#include <gtest/gtest.h>

namespace signorini::model {
namespace active_set_test {

using contact::ContactState;
using contact::test::discretize;

constexpr int points_per_element = 3;

/// The lower side of a strip from x = 0 to 3 in 6 elements, above a plane or another strip's upper side.
struct Strip {
  nurbs::Discretization strip = discretize(nurbs::rectangle(3, 0.5, Eigen::Vector2d(0, 0)), {6, 1}, "N2", "south");
  std::optional<nurbs::Discretization> base;
  contact::Formulations<2> contacts;
  std::vector<contact::History<2>> accepted, present;
  std::vector<contact::Controls> controls{1};
  VectorX u, base_u;

  explicit Strip(const contact::Method& law) : base_u(VectorX::Zero(2)) {
    u = VectorX::Zero(2 * strip.functions());
    add(contact::Master<2>(contact::make_plane<2>({0, 0}, {0, 1})), law);
    touch(0);
  }
  /// Above a strip from 0 to `length`.
  Strip(const contact::Method& law, double length)
      : base(discretize(nurbs::rectangle(length, 1, Eigen::Vector2d(0, -1)), {2, 1}, "N2", "north")) {
    u = VectorX::Zero(2 * strip.functions());
    base_u = VectorX::Zero(2 * base->functions());
    add(contact::Master<2>(contact::Surface<2>(*base, nurbs::side_of("north", 2))), law);
  }
  void add(contact::Master<2> master, const contact::Method& law) {
    contacts.push_back(contact::make_formulation<2>(
        law, {contact::Surface<2>(strip, nurbs::side_of("south", 2)), std::move(master), points_per_element}));
    accepted.emplace_back(contacts[0]->points());
    present = accepted;
  }
  /// Tilts the strip so that it penetrates from x = 0 to `end` and is open beyond.
  void touch(double end) {
    const MatrixX points = strip.points();
    for (int a = 0; a < points.cols(); ++a) u(2 * a + 1) = 0.01 * (points(0, a) - end);
    evaluate();
  }
  void shift(double x) {
    for (int a = 0; a < strip.functions(); ++a) u.segment<2>(2 * a) << x, -0.01;
    evaluate();
  }
  void evaluate() {
    contacts[0]->move(u.data(), base_u.data());
    for (int part = 0; part < contacts[0]->parts(); ++part)
      contacts[0]->evaluate_part(part, {present[0], accepted[0], controls[0]}, true);
    contacts[0]->gather({present[0], accepted[0], controls[0]}, true);
  }
  void accept() {
    contacts[0]->commit(present[0], accepted[0], 1);
    accepted = present;
  }
  void fix(const ActiveSet<2>& set) { controls[0].fixed_states = set.fixed(0); }
  void begin(ActiveSet<2>& set, const ActiveSetOptions& options) {
    set.begin(contacts, present, options);
    fix(set);
  }
  void update(ActiveSet<2>& set, const std::vector<double>& energies) {
    set.update(energies);
    fix(set);
  }
  void record(ActiveSet<2>& set, double residual) {
    set.record(present, residual, true);
    fix(set);
  }
  bool release_all(ActiveSet<2>& set) {
    const bool fixed = set.release_all();
    fix(set);
    return fixed;
  }
  int touching() const { return resultant(present[0]).active; }
  bool holds() const { return !controls[0].fixed_states.empty(); }
};

const contact::InterfaceLaw law{100};

TEST(ActiveSet, IsFrozenUntilTheEnergyHasDecreased) {
  Strip strip(law);
  strip.touch(1.5);
  ASSERT_EQ(strip.touching(), 9);
  ActiveSet<2> set;
  strip.begin(set, {0.01, 0});
  for (double end : {2.0, 0.5, 3.0}) {
    strip.touch(end);
    EXPECT_EQ(strip.touching(), 9);
  }
  strip.update(set, {1, 0.01});
  strip.evaluate();
  EXPECT_EQ(strip.touching(), 9);
  strip.update(set, {1, 0.0099});
  strip.evaluate();
  EXPECT_EQ(strip.touching(), 18);
  EXPECT_FALSE(strip.release_all(set));

  strip.begin(set, {});
  strip.touch(0.5);
  EXPECT_EQ(strip.touching(), 3);
}

TEST(ActiveSet, ReleaseEndsTheFreezeWithoutCountingARound) {
  Strip strip(law);
  strip.touch(1.5);
  ActiveSet<2> set;
  for (int round = 0; round < 20; ++round) {
    strip.begin(set, {0.01, 0});
    strip.touch(2);
    EXPECT_TRUE(strip.release_all(set));
    EXPECT_FALSE(set.exhausted());
    EXPECT_FALSE(strip.release_all(set));
    strip.evaluate();
    EXPECT_EQ(strip.touching(), 12);
    strip.touch(1.5);
  }
}

TEST(ActiveSet, FixesPointsThatChangeTooOftenAndFreesThemForSomeRounds) {
  Strip strip(law);
  strip.touch(1.5);
  ActiveSet<2> set;
  strip.begin(set, {0, 2});
  double residual = 1;
  const auto go = [&](double end) {
    strip.touch(end);
    strip.record(set, residual *= 0.9);
    return strip.touching();
  };
  EXPECT_EQ(go(1.5), 9);
  EXPECT_EQ(go(2), 12);
  EXPECT_EQ(go(1.5), 9);
  EXPECT_FALSE(strip.holds()); // two changes are allowed
  EXPECT_EQ(go(2), 12);
  EXPECT_TRUE(strip.holds()); // in the state after the last change
  EXPECT_EQ(go(1.5), 12);
  EXPECT_EQ(go(0.5), 6); // the others are free
  EXPECT_TRUE(strip.release_all(set));
  EXPECT_FALSE(set.exhausted());
  EXPECT_EQ(go(0.5), 3);
  // Six such rounds in one step
  strip.begin(set, {0, 1});
  for (int round = 1; round <= 6; ++round) {
    for (double end : {1.5, 2.0, 1.5}) go(end);
    ASSERT_TRUE(strip.holds());
    EXPECT_FALSE(set.exhausted());
    EXPECT_TRUE(strip.release_all(set));
    EXPECT_EQ(set.exhausted(), round == 6) << round;
  }
  strip.begin(set, {0, 1});
  EXPECT_FALSE(set.exhausted());
}

/// Expected period() after an evaluation with a given end of contact and residual.
std::vector<int> periods(const std::vector<std::pair<double, double>>& path) {
  Strip strip(law);
  ActiveSet<2> set;
  strip.begin(set, {});
  std::vector<int> result;
  for (const auto& [end, residual] : path) {
    strip.touch(end);
    strip.record(set, residual);
    result.push_back(set.period());
  }
  return result;
}

TEST(ActiveSet, DetectsCyclesAfterTwoRepetitions) {
  EXPECT_EQ(periods({{1, 5}, {2, 1}, {1, 2}, {2, 1}, {1, 2}, {2, 1}, {1, 2}}), (std::vector<int>{0, 0, 0, 0, 0, 0, 2}));
  EXPECT_EQ(periods({{1, 1}, {2, 2}, {0.5, 3}, {1, 1}, {2, 2}, {0.5, 3}, {1, 1}, {2, 2}, {0.5, 3}}),
            (std::vector<int>{0, 0, 0, 0, 0, 0, 0, 0, 3}));
  std::vector<std::pair<double, double>> long_way;
  for (int round = 0; round < 3; ++round)
    for (int k = 0; k < 8; ++k) long_way.push_back({k < 4 ? 1 : 2, 1 + k});
  EXPECT_EQ(periods(long_way).back(), 8);
}

TEST(ActiveSet, DetectsNoOtherSequencesAsCycles) {
  const auto none = [](const std::vector<std::pair<double, double>>& path) {
    for (int period : periods(path)) EXPECT_EQ(period, 0);
  };
  std::vector<std::pair<double, double>> converging, similar, still, states_only;
  for (int k = 0; k < 30; ++k) {
    const bool odd = k % 2 == 1;
    converging.push_back({odd ? 2 : 1, (odd ? 2 : 1) * std::pow(0.5, k)});
    similar.push_back({odd ? 2 : 1, (odd ? 2 : 1) * (1 + 1e-8 * k)});
    still.push_back({1, odd ? 2 : 1});
    states_only.push_back({1 + 0.1 * (k * k % 13), odd ? 2 : 1});
  }
  none(converging);
  none(similar);
  none(still); // residuals repeat, but no point changes
  none(states_only);
}

TEST(ActiveSet, ListsCyclingPointsByNumberOfChanges) {
  Strip strip(law);
  ActiveSet<2> set;
  strip.begin(set, {});
  const auto go = [&](double end) {
    strip.touch(end);
    strip.record(set, 1);
  };
  go(1), go(1.5);
  EXPECT_TRUE(set.cycling_points().empty()); // one change is not cycling
  go(1), go(1.5), go(2), go(1.5), go(1);
  // Element 3 (x from 1 to 1.5) changed four times, element 4 twice.
  const std::vector<PointIndex> cycling = set.cycling_points();
  ASSERT_EQ(cycling.size(), 6u);
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(cycling[i].contact, 0);
    EXPECT_EQ(cycling[i].point, 6 + i);
    EXPECT_EQ(strip.contacts[0]->points().list[6 + i].element, i < 3 ? 2 : 3);
  }
  EXPECT_TRUE(set.cycling_points(true).empty());
  // Old evaluations are ignored.
  for (int k = 0; k < 8; ++k) go(1);
  EXPECT_TRUE(set.cycling_points().empty());
}

TEST(ActiveSet, NamesAllStatesThatAlternateInACycle) {
  Strip strip(contact::InterfaceLaw{100, 100, 0.1});
  strip.accept(); // sets slip points to the present foot points
  ActiveSet<2> set;
  strip.begin(set, {});
  const PointIndex first{0, 0};
  const auto go = [&](double x, double y) {
    for (int a = 0; a < strip.strip.functions(); ++a) strip.u.segment<2>(2 * a) << x, y;
    strip.evaluate();
    strip.record(set, 1);
    return strip.present[0].results[0].state;
  };
  // Period 3: the last two states of a round are equal.
  for (int round = 0; round < 3; ++round) {
    EXPECT_EQ(go(0, -0.01), ContactState::stick);
    EXPECT_EQ(go(0.1, -0.01), ContactState::slip);
    EXPECT_EQ(go(0.2, -0.01), ContactState::slip);
  }
  EXPECT_EQ(set.alternating(first), "stick / slip");
  // Three states in one round
  for (int round = 0; round < 3; ++round) go(0, 0.01), go(0, -0.01), go(0.1, -0.01);
  EXPECT_EQ(set.alternating(first), "open / stick / slip");
  // Period 2, in the order of the last two states
  for (int round = 0; round < 4; ++round) go(0.1, -0.01), go(0, -0.01);
  EXPECT_EQ(set.alternating(first), "slip / stick");
}

TEST(ActiveSet, ListsPointsThatCyclePastTheMastersEnd) {
  Strip strip(law, 2);
  ActiveSet<2> set;
  strip.shift(0);
  strip.begin(set, {});
  // The master, 0 … 2, is extended beyond its ends by 0.3 of an element, 0.3.
  for (double x : {0.0, -0.5, 0.0, -0.5}) {
    strip.shift(x);
    EXPECT_EQ(strip.touching(), x == 0 ? 14 : 16);
    strip.record(set, 1);
  }
  // At the right end the part 2.3 … 2.8 alternates, at the left end 0 … 0.2.
  std::vector<int> points;
  for (const PointIndex& index : set.cycling_points(true)) points.push_back(index.point);
  std::sort(points.begin(), points.end());
  EXPECT_EQ(points, (std::vector<int>{0, 14, 15, 16}));
  EXPECT_EQ(set.cycling_points().size(), 4u);
}

/// Lifts the whole strip to a height in an iteration with hysteresis. Returns whether points were retained.
bool lift(Strip& strip, ActiveSet<2>& set, double height) {
  strip.update(set, {});
  for (int a = 0; a < strip.strip.functions(); ++a) strip.u.segment<2>(2 * a) << 0, height;
  strip.evaluate();
  const bool retained = set.record(strip.present, 1, false);
  strip.fix(set);
  if (retained) strip.evaluate();
  return retained;
}

TEST(ActiveSet, RetainsPointsThatOpenByAnErrorOfLinearization) {
  Strip strip(law);
  ActiveSet<2> set;
  strip.begin(set, {});
  EXPECT_FALSE(lift(strip, set, -0.01));
  EXPECT_TRUE(lift(strip, set, 0.002));
  EXPECT_EQ(strip.touching(), 18);
  // The next evaluation decides again: at convergence the gap does not change.
  EXPECT_FALSE(lift(strip, set, 0.002));
  EXPECT_EQ(strip.touching(), 0);
  EXPECT_FALSE(lift(strip, set, -0.01));
  EXPECT_FALSE(lift(strip, set, 0.005)); // by more than 0.3 of its change
  EXPECT_EQ(strip.touching(), 0);
}

TEST(ActiveSet, FreesRetainedPointsAtConvergence) {
  Strip strip(law);
  ActiveSet<2> set;
  strip.begin(set, {});
  lift(strip, set, -0.01);
  EXPECT_TRUE(lift(strip, set, 0.002));
  EXPECT_TRUE(strip.release_all(set));
  EXPECT_FALSE(lift(strip, set, 0.002));
  EXPECT_EQ(strip.touching(), 0);
  EXPECT_FALSE(strip.release_all(set));
}

TEST(ActiveSet, RetainsNothingWhereFewPointsOpen) {
  Strip strip(law);
  ActiveSet<2> set;
  strip.begin(set, {});
  for (double end : {3.0, 2.7}) {
    strip.touch(end);
    EXPECT_FALSE(set.record(strip.present, 1, false));
  }
  EXPECT_EQ(strip.touching(), 16);
}

TEST(ActiveSet, SeesTheClosedSetShrink) {
  Strip strip(law);
  ActiveSet<2> set;
  strip.begin(set, {});
  for (int k = 0; k < 24; ++k) {
    EXPECT_FALSE(set.shrinks()) << k;
    strip.touch(3 - 0.1 * k);
    strip.record(set, 1);
  }
  EXPECT_TRUE(set.shrinks());
  // A cycle of period 3 does not shrink, in whatever phase it is.
  for (int k = 0; k < 30; ++k) {
    strip.touch(k % 3 == 0 ? 1 : 2);
    strip.record(set, 1);
    if (k < 23) continue;
    EXPECT_FALSE(set.shrinks()) << k;
  }
}

TEST(ActiveSet, IgnoresAdhesion) {
  Strip strip(contact::adhesive({0.02, 0.05}));
  ActiveSet<2> set;
  strip.begin(set, {0, 1});
  int adhesive = 0;
  for (int k = 0; k < 12; ++k) {
    strip.touch(k % 2 == 0 ? -1 : -4); // near the plane, and beyond the distance of the strongest attraction
    adhesive += strip.touching();
    strip.record(set, 1 + k % 2);
    EXPECT_EQ(set.period(), 0);
    EXPECT_FALSE(strip.holds());
  }
  EXPECT_GT(adhesive, 0);
  EXPECT_LT(adhesive, 12 * 18);
  EXPECT_TRUE(set.cycling_points().empty());
}

} // namespace active_set_test
} // namespace signorini::model
