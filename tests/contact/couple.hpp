#pragma once
// A face above a master, with all displacements in one vector, and a comparison of its tangent with finite differences.

#include "contact/faces.hpp"
#include "contact/tangents.hpp"

#include <gtest/gtest.h>

namespace signorini::contact::test {

/// The slave body's displacements come first, then the master body's or the obstacle's, then additional unknowns.
struct Couple {
  nurbs::Discretization die;
  std::optional<nurbs::Discretization> base; ///< none: an obstacle
  Pair<2> pair;
  VectorX u;

  Couple(nurbs::Discretization slave, const std::string& side, nurbs::Discretization master, const Law& law, int points,
         bool revolved = false)
      : die(std::move(slave)), base(std::move(master)),
        pair(Surface<2>(die, nurbs::side_of(side, 2)), Surface<2>(*base, nurbs::side_of("north", 2)), law, points,
             revolved),
        u(VectorX::Zero(die_dofs() + base_dofs() + pair.extra_unknowns())) {}
  /// `shared`: see Surface.
  Couple(nurbs::Discretization slave, const std::string& side, const Obstacle<2>& master, const Law& law, int points,
         bool revolved = false, std::vector<int> shared = {})
      : die(std::move(slave)),
        pair(Surface<2>(die, nurbs::side_of(side, 2), 0, std::move(shared)), master, law, points, revolved),
        u(VectorX::Zero(die_dofs() + base_dofs() + pair.extra_unknowns())) {}
  /// A half annulus of radius 0.5 whose lowest point is (x, y).
  template <class AnyMaster, class AnyLaw = PenaltyLaw>
  Couple(const std::string& label, AnyMaster master, const AnyLaw& law, double x, double y, bool revolved = false)
      : Couple(discretize(nurbs::half_annulus(0.3, 0.5, Eigen::Vector2d(x, y + 0.5)), {6, 2}, label, "south"), "south",
               std::move(master), law, 9, revolved) {}

  int die_dofs() const { return 2 * die.functions(); }
  int base_dofs() const { return base ? 2 * base->functions() : 2; }
  int first_extra() const { return die_dofs() + base_dofs(); }
  void evaluate(const VectorX& at) {
    pair.evaluate(at.data(), at.data() + die_dofs(), true, at.data() + first_extra());
  }
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

inline nurbs::Discretization slab(const std::string& label) {
  return discretize(nurbs::rectangle(3, 1, Eigen::Vector2d(0, 0)), {8, 3}, label, "north");
}

/// Number of points tested per state.
struct Census {
  int states = 0, stepped_over = 0, open = 0, stick = 0, slip = 0, adhesion = 0, elsewhere = 0;

  void count(const Pair<2>& pair) {
    for (const auto& point : pair.results())
      ++(point.state == ContactState::open    ? open
         : point.state == ContactState::stick ? stick
         : point.state == ContactState::slip  ? slip
                                              : adhesion);
    for (const Block& block : pair.blocks()) elsewhere += block.slip_element >= 0;
    states += !pair.blocks().empty();
  }
  void add(const Census& more) {
    states += more.states;
    stepped_over += more.stepped_over;
    open += more.open;
    stick += more.stick;
    slip += more.slip;
    adhesion += more.adhesion;
    elsewhere += more.elsewhere;
  }
};

inline void compare_with_differences(Couple& couple, Census& census) {
  couple.evaluate();
  const Dense at = couple.dense();
  Census here;
  here.count(couple.pair);
  Random random(1);
  const bool compared = holds_in_random_directions(couple, at, random);
  couple.evaluate();
  if (compared)
    census.add(here);
  else
    ++census.stepped_over;
}

/// Sums of the residual over both bodies, which hold minus the forces on them, its moment, and the sum of its norms.
struct Balance {
  Eigen::Vector2d on_die = Eigen::Vector2d::Zero(), on_base = Eigen::Vector2d::Zero();
  double moment = 0, size = 0;
};
inline Balance balance(const Couple& couple) {
  Balance sum;
  const VectorX force = couple.dense().force;
  const MatrixX die = couple.die.points(), base = couple.base->points();
  for (int i = 0; i < couple.u.size(); i += 2) {
    const bool first = i < couple.die_dofs();
    const Eigen::Vector2d f = force.segment<2>(i);
    const Eigen::Vector2d x =
        Eigen::Vector2d(first ? die.col(i / 2) : base.col((i - couple.die_dofs()) / 2)) + couple.u.segment<2>(i);
    (first ? sum.on_die : sum.on_base) += f;
    sum.moment += x(0) * f(1) - x(1) * f(0);
    sum.size += f.norm();
  }
  return sum;
}

/// Forces on both bodies are those of the resultant and sum to zero; without friction their moments do, too.
inline void expect_balanced(Couple& couple, double mu) {
  couple.evaluate();
  const Resultant<2> resultant = couple.pair.resultant();
  ASSERT_GT(resultant.active, 0);
  const auto [on_die, on_base, moment, size] = balance(couple);
  EXPECT_LT((on_die + on_base).norm(), 1e-14 * size);
  // The residual holds minus the force on the slave.
  EXPECT_LT((on_die + resultant.force).norm(), 1e-13 * size);
  if (mu == 0) {
    EXPECT_LT(std::abs(moment), 1e-13 * size);
  }
}

/// Presses, then drags by `drags` with a comparison after each, starting from random displacements.
inline Census press_and_drag(Couple couple, unsigned seed, double depth, const std::vector<double>& drags) {
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

} // namespace signorini::contact::test
