// A whole contact: assembled force and tangent against finite differences in every state, balance of forces and
// moments, Coulomb's law, history, and that skipping far points loses none.
#include "contact/pair.hpp"

#include "contact/faces.hpp"
#include "differences.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace signorini::contact {
namespace {

using namespace test;

/// A die above a master, with all displacements in one vector, the die's first.
struct Couple {
  nurbs::Discretisation die, base;
  Pair<2> pair;
  VectorX u;

  Couple(const std::string& label, nurbs::Discretisation master, const PenaltyLaw& law, double x, double y)
      : die(discretise(nurbs::half_annulus(0.3, 0.5, Eigen::Vector2d(x, y + 0.5)), {6, 2}, label, "south")),
        base(std::move(master)),
        pair(Surface<2>(die, nurbs::side_of("south", 2)), Surface<2>(base, nurbs::side_of("north", 2)), law, 9),
        u(VectorX::Zero(2 * (die.functions() + base.functions()))) {}

  /// Degrees of freedom of the two contact faces.
  std::vector<int> face_dofs() const {
    std::vector<int> dofs;
    const auto append = [&](const Surface<2>& surface, int offset) {
      for (int a = 0; a < surface.functions(); ++a)
        for (int c = 0; c < 2; ++c) dofs.push_back(offset + 2 * surface.body_function(a) + c);
    };
    append(pair.slave(), 0);
    append(*pair.master().surface(), die_dofs());
    return dofs;
  }
  int die_dofs() const { return 2 * die.functions(); }
  int base_dofs() const { return 2 * base.functions(); }
  void evaluate(const VectorX& at) { pair.evaluate(at.data(), at.data() + die_dofs()); }
  void evaluate() { evaluate(u); }
  Dense dense() const { return test::dense(pair, die_dofs(), base_dofs()); }
  void move_die(double x, double y) {
    for (int i = 0; i < die_dofs(); i += 2) u.segment<2>(i) += Eigen::Vector2d(x, y);
  }
  /// Lowers (or lifts) the die until its deepest point just touches.
  void touch() {
    for (int round = 0; round < 20; ++round) {
      evaluate();
      const std::vector<double> gaps = pair.gaps();
      move_die(0, -*std::min_element(gaps.begin(), gaps.end()));
    }
    evaluate();
    pair.accept();
  }
  void shake(Random& random, double size) {
    for (int i = 0; i < u.size(); ++i) u(i) += uniform(random, -size, size);
  }
};

nurbs::Discretisation slab(const std::string& label) {
  return discretise(nurbs::rectangle(3, 1, Eigen::Vector2d(0, 0)), {8, 3}, label, "north");
}

/// What finite differences must not step over.
std::vector<int> signature(const Pair<2>& pair) {
  std::vector<int> result;
  for (const auto& point : pair.results()) result.push_back(static_cast<int>(point.state));
  for (const Group& group : pair.groups())
    result.insert(result.end(), {group.slave_element, group.master_element, group.slip_element});
  return result;
}

/// How much was tested in which state.
struct Census {
  int states = 0, stepped_over = 0, open = 0, stick = 0, slip = 0, elsewhere = 0;
};

void compare_with_differences(Couple& couple, Census& census) {
  couple.evaluate();
  const Dense at = couple.dense();
  const std::vector<int> before = signature(couple.pair);
  Census here;
  for (const auto& point : couple.pair.results())
    ++(point.state == ContactState::open ? here.open : point.state == ContactState::stick ? here.stick : here.slip);
  for (const Group& group : couple.pair.groups()) here.elsewhere += group.slip_element >= 0;
  MatrixX slopes = MatrixX::Zero(couple.u.size(), couple.u.size());
  bool crossed = false;
  for (int i : couple.face_dofs()) {
    if (crossed) break;
    slopes.col(i) = signorini::test::derivative<VectorX>(
        [&](double h) {
          VectorX moved = couple.u;
          moved(i) += h;
          couple.evaluate(moved);
          crossed = crossed || signature(couple.pair) != before;
          return couple.dense().force;
        },
        2e-6);
  }
  couple.evaluate();
  if (crossed) {
    ++census.stepped_over;
    return;
  }
  EXPECT_LE((slopes - at.tangent).norm(), 2e-8 * at.tangent.norm());
  census.states += !couple.pair.groups().empty();
  census.open += here.open;
  census.stick += here.stick;
  census.slip += here.slip;
  census.elsewhere += here.elsewhere;
}

/// Presses, then drags by `drags` with a comparison after each, from random displaced states.
Census press_and_drag(Couple couple, unsigned seed, double depth, const std::vector<double>& drags) {
  Random random(seed);
  Census census;
  couple.shake(random, 0.005);
  couple.touch();
  couple.move_die(0, -depth);
  couple.shake(random, 0.002);
  compare_with_differences(couple, census);
  couple.pair.accept();
  for (double drag : drags) {
    couple.move_die(drag, 0);
    couple.shake(random, 0.0005);
    compare_with_differences(couple, census);
  }
  return census;
}

void add(Census& sum, const Census& more) {
  sum.states += more.states;
  sum.stepped_over += more.stepped_over;
  sum.open += more.open;
  sum.stick += more.stick;
  sum.slip += more.slip;
  sum.elsewhere += more.elsewhere;
}

TEST(Pair, TangentIsTheForcesDerivativeInEveryState) {
  Census sum;
  unsigned seed = 0;
  for (const char* label : {"N2", "N4", "N2-N2.2", "L1"}) {
    // Small drags stick, longer ones slip, one of more than an element leaves the slip point behind in another.
    if (std::string(label) != "L1")
      add(sum, press_and_drag(Couple(label, slab(label), {100, 100, 0.2}, 0.8, 1.0), ++seed, 0.06, {3e-4, 0.02, 0.5}));
    add(sum, press_and_drag(Couple("N2", slab(label), {100, 50, 0.4}, 1.6, 1.0), ++seed, 0.04, {-2e-4, -0.05, -0.45}));
  }
  Random random(9);
  for (int trial = 0; trial < 6; ++trial)
    add(sum, press_and_drag(Couple("N2-N2.1", wavy(random, 3, 0.15, 3, 6), {100, 100, 0.3}, 1.3, 0.1), ++seed, 0.06,
                            {1e-3, 0.1, 0.4}));
  EXPECT_GE(sum.states, 30) << sum.stepped_over << " states lay on a change of state";
  EXPECT_GT(sum.open, 500);
  EXPECT_GT(sum.stick, 100);
  EXPECT_GT(sum.slip, 100);
  EXPECT_GT(sum.elsewhere, 10);
}

TEST(Pair, TangentIsTheForcesDerivativeAtACorner) {
  // A valley whose vertex is the master point of what dips below it
  const auto valley = polyline({{0, 1.6}, {1.5, 1}, {3, 1.6}});
  for (double drag : {2e-4, 0.02}) {
    Couple couple("N2", valley, {100, 100, 0.2}, 1.5, 1.0);
    Random random(3);
    couple.shake(random, 0.001);
    couple.evaluate();
    couple.pair.accept();
    couple.move_die(0, -0.1);
    couple.evaluate();
    int corners = 0;
    for (const auto& point : couple.pair.results()) {
      const Eigen::Vector2d down = point.position - couple.pair.master().surface()->points().col(1);
      corners += point.state != ContactState::open && std::abs(std::abs(point.gap) - down.norm()) < 1e-14;
    }
    EXPECT_GE(corners, 2);
    couple.pair.accept();
    couple.move_die(drag, 0);
    Census census;
    compare_with_differences(couple, census);
    EXPECT_EQ(census.states, 1);
  }
}

TEST(Pair, ForcesBalanceAndWithoutFrictionMomentsToo) {
  Random random(4);
  for (double mu : {0.0, 0.3})
    for (int trial = 0; trial < 10; ++trial) {
      Couple couple("N2-N4", wavy(random, 3, 0.15, 3, 6), {100, 100, mu}, 1.3, 0.1);
      couple.touch();
      couple.move_die(0.02, -0.06);
      couple.shake(random, 0.01);
      couple.evaluate();
      const VectorX force = couple.dense().force;
      const Resultant<2> resultant = couple.pair.resultant();
      ASSERT_GT(resultant.active, 0);
      Eigen::Vector2d on_die = Eigen::Vector2d::Zero(), on_base = Eigen::Vector2d::Zero();
      double moment = 0, size = 0;
      const MatrixX die = couple.die.points(), base = couple.base.points();
      for (int i = 0; i < couple.u.size(); i += 2) {
        const bool first = i < couple.die_dofs();
        const Eigen::Vector2d f = force.segment<2>(i);
        const Eigen::Vector2d x =
            Eigen::Vector2d(first ? die.col(i / 2) : base.col((i - couple.die_dofs()) / 2)) + couple.u.segment<2>(i);
        (first ? on_die : on_base) += f;
        moment += x(0) * f(1) - x(1) * f(0);
        size += f.norm();
      }
      EXPECT_LT((on_die + on_base).norm(), 1e-14 * size);
      // The residual holds minus the force on the slave.
      EXPECT_LT((on_die + resultant.force).norm(), 1e-14 * size);
      if (mu == 0) {
        EXPECT_LT(std::abs(moment), 1e-13 * size);
      }
    }
}

TEST(Pair, FrictionIsCoulombsAndOpposesTheSliding) {
  for (double direction : {1.0, -1.0}) {
    Couple couple("N2", slab("N2"), {100, 100, 0.2}, 1.4, 1.0);
    couple.touch();
    couple.move_die(0, -0.05);
    couple.evaluate();
    couple.pair.accept();
    for (int step = 0; step < 20; ++step) {
      couple.move_die(0.01 * direction, 0);
      couple.evaluate();
      int slipping = 0;
      for (const auto& point : couple.pair.results()) {
        EXPECT_LE(point.friction.norm(), 0.2 * point.pressure * (1 + 1e-14));
        if (point.state != ContactState::slip) continue;
        ++slipping;
        EXPECT_NEAR(point.friction.norm(), 0.2 * point.pressure, 1e-13 * point.pressure);
        EXPECT_GT(point.friction(0) * direction, 0);
      }
      const Resultant<2> resultant = couple.pair.resultant();
      EXPECT_EQ(resultant.slipping, slipping);
      EXPECT_LT(resultant.force(0) * direction, 0);
      EXPECT_GT(resultant.force(1), 0);
      if (step > 5) {
        EXPECT_NEAR(std::abs(resultant.force(0)), 0.2 * resultant.force(1), 1e-12 * resultant.force(1));
      }
      EXPECT_NEAR(resultant.max_penetration, 0.05, 1e-3);
      EXPECT_NEAR(resultant.max_pressure, 100 * resultant.max_penetration, 1e-12);
      couple.pair.accept();
    }
  }
}

bool same(const std::vector<Group>& a, const std::vector<Group>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Group& s, const Group& t) {
    return s.slave_element == t.slave_element && s.master_element == t.master_element &&
           s.slip_element == t.slip_element && s.force == t.force && s.matrix == t.matrix;
  });
}

TEST(Pair, RollbackRestoresBitByBit) {
  Random random(5);
  for (int trial = 0; trial < 10; ++trial) {
    Couple couple("N2-N2.1", trial % 2 == 0 ? slab("N2") : wavy(random, 3, 0.15, 3, 6), {100, 100, 0.2}, 1.3,
                  trial % 2 == 0 ? 1.0 : 0.1);
    couple.touch();
    couple.move_die(0, -0.1);
    couple.evaluate();
    couple.pair.accept();
    couple.move_die(0.03, 0);
    couple.shake(random, 0.002);
    couple.evaluate();
    const std::vector<Group> groups = couple.pair.groups();
    ASSERT_FALSE(groups.empty());
    for (int wild = 0; wild < 5; ++wild) {
      VectorX elsewhere = couple.u;
      for (int i = 0; i < elsewhere.size(); ++i) elsewhere(i) += uniform(random, -0.2, 0.2);
      couple.evaluate(elsewhere);
    }
    couple.pair.rollback();
    couple.evaluate();
    EXPECT_TRUE(same(groups, couple.pair.groups()));
  }
}

/// On the cone before, on it afterwards: on a straight master with the same traction, on a curved one of the same size
/// (the chord to the slip point turns as that follows the curve).
TEST(Pair, AcceptedSlipKeepsTheTraction) {
  Random random(6);
  for (bool straight : {true, false}) {
    Couple couple("N2", straight ? slab("N2") : wavy(random, 3, 0.1, 3, 3), {100, 100, 0.2}, 1.3, straight ? 1.0 : 0.0);
    couple.touch();
    couple.move_die(0, -0.05);
    couple.evaluate();
    couple.pair.accept();
    couple.move_die(0.1, 0);
    couple.evaluate();
    const auto before = couple.pair.results();
    couple.pair.accept();
    couple.evaluate();
    const auto after = couple.pair.results();
    int slipped = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
      EXPECT_EQ(before[i].state == ContactState::open, after[i].state == ContactState::open);
      if (before[i].state != ContactState::slip) continue;
      ++slipped;
      EXPECT_NEAR(after[i].friction.norm(), before[i].friction.norm(), 1e-12 * before[i].pressure);
      if (straight) {
        EXPECT_NEAR((after[i].friction - before[i].friction).norm(), 0, 1e-12 * before[i].pressure);
      }
    }
    EXPECT_GT(slipped, 3);
  }
}

TEST(Pair, FirstTouchCountsFromThereWhenAccepted) {
  Couple couple("N2", slab("N2"), {100, 100, 0.2}, 1.3, 0.95);
  couple.evaluate();
  // Rounding of the positions times the penalty
  for (const auto& point : couple.pair.results()) EXPECT_NEAR(point.friction.norm(), 0, 1e-13);
  couple.pair.accept();
  couple.move_die(1e-3, 0);
  couple.evaluate();
  int sticking = 0;
  for (const auto& point : couple.pair.results())
    if (point.state == ContactState::stick) {
      ++sticking;
      EXPECT_NEAR(point.friction(0), 100 * 1e-3, 1e-12);
    }
  EXPECT_GT(sticking, 3);
}

TEST(Pair, SkippingFarPointsLosesNoContact) {
  Random random(8);
  for (double mu : {0.0, 0.2})
    for (int trial = 0; trial < 4; ++trial) {
      const auto master = trial % 2 == 0 ? slab("N2") : wavy(random, 3, 0.15, 3, 6);
      Couple couple("N2", master, {100, 100, mu}, 1.3, trial % 2 == 0 ? 1.02 : 0.2);
      couple.touch();
      couple.move_die(0, 0.02);
      int touched = 0;
      for (int jump = 0; jump < 60; ++jump) {
        VectorX u = couple.u;
        couple.move_die(uniform(random, -0.6, 0.6), uniform(random, -0.25, 0.3));
        couple.shake(random, 0.03);
        couple.evaluate();
        Couple fresh("N2", master, {100, 100, mu}, 1.3, trial % 2 == 0 ? 1.02 : 0.2);
        fresh.evaluate(couple.u);
        for (std::size_t i = 0; i < fresh.pair.results().size(); ++i)
          EXPECT_NEAR(couple.pair.results()[i].pressure, fresh.pair.results()[i].pressure, 1e-9)
              << "jump " << jump << " point " << i;
        touched += fresh.pair.resultant().active > 0;
        if (jump % 3 == 0) couple.pair.accept();
        if (jump % 3 == 1) couple.pair.rollback();
        couple.u = u;
      }
      EXPECT_GT(touched, 10);
      EXPECT_LT(touched, 60);
    }
}

TEST(Pair, GapsAreKnownForOpenPointsToo) {
  Couple couple("N2", slab("N2"), {100, 100, 0.2}, 1.3, 1.1);
  couple.evaluate();
  const std::vector<double> gaps = couple.pair.gaps();
  ASSERT_EQ(gaps.size(), couple.pair.results().size());
  for (std::size_t i = 0; i < gaps.size(); ++i) EXPECT_NEAR(gaps[i], couple.pair.results()[i].position(1) - 1, 1e-14);
}

TEST(Pair, ErrorsNameTheArgument) {
  const auto build = [](PenaltyLaw law) { Couple("N2", slab("N2"), law, 1, 1); };
  EXPECT_ERROR(build({0, 100, 0.2}), "penalty must be positive");
  EXPECT_ERROR(build({-1, 100, 0.2}), "penalty must be positive");
  EXPECT_ERROR(build({100, 100, -0.1}), "mu must not be negative");
  EXPECT_ERROR(build({100, 0, 0.2}), "friction: penalty must be positive");
}

} // namespace
} // namespace signorini::contact
