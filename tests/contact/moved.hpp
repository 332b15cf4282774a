#pragma once
// A contact with all displacements in one vector, a comparison of its tangent with finite differences, and a census of
// the states in which that was done.

#include "contact/faces3d.hpp"
#include "contact/tangents.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

namespace signorini::contact::test {

/// The slave body's displacements come first, then the master body's or the obstacle's, then additional unknowns. `Own`
/// is the derived class, which functions return so that calls can be chained.
template <int D, class Own> struct Moved {
  nurbs::Discretization die;
  std::optional<nurbs::Discretization> base; ///< none: an obstacle
  Pair<D> pair;
  VectorX u;

  Moved(nurbs::Discretization slave, const std::string& side, nurbs::Discretization master,
        const std::string& master_side, const Law& law, int points, bool revolved = false)
      : die(std::move(slave)), base(std::move(master)),
        pair(Surface<D>(die, nurbs::side_of(side, D)), Surface<D>(*base, nurbs::side_of(master_side, D)), law, points,
             revolved),
        u(VectorX::Zero(first_extra() + pair.extra_unknowns())) {}
  /// `shared`: see Surface.
  Moved(nurbs::Discretization slave, const std::string& side, const Obstacle<D>& master, const Law& law, int points,
        bool revolved = false, std::vector<int> shared = {})
      : die(std::move(slave)),
        pair(Surface<D>(die, nurbs::side_of(side, D), 0, std::move(shared)), master, law, points, revolved),
        u(VectorX::Zero(first_extra() + pair.extra_unknowns())) {}

  int die_dofs() const { return D * die.functions(); }
  int base_dofs() const { return D * (base ? base->functions() : 1); }
  int first_extra() const { return die_dofs() + base_dofs(); }
  Dense dense() const { return test::dense(pair, die_dofs(), base_dofs()); }
  Own& own() { return static_cast<Own&>(*this); }
  Own& evaluate(const VectorX& at) {
    pair.evaluate(at.data(), at.data() + die_dofs(), true, at.data() + first_extra());
    return own();
  }
  Own& evaluate() { return evaluate(u); }
  Own& accept() {
    pair.accept();
    return own();
  }
  Own& move_die(const Vec<D>& by) {
    for (int i = 0; i < die_dofs(); i += D) u.template segment<D>(i) += by;
    return own();
  }
  Own& shake(Random& random, double size) {
    for (int i = 0; i < u.size(); ++i) u(i) += uniform(random, -size, size);
    return own();
  }
  /// Lowers (or lifts) the die until its deepest point just touches.
  Own& touch() {
    for (int round = 0; round < (D == 2 ? 20 : 10); ++round) {
      evaluate();
      const std::vector<double> gaps = pair.gaps();
      move_die(-*std::min_element(gaps.begin(), gaps.end()) * Vec<D>::Unit(D - 1));
    }
    return evaluate().accept();
  }
};

/// Number of points tested per state, or what a test expects: more than each number, and at least so many states.
struct Census {
  int states = 0, stepped_over = 0, open = 0, stick = 0, slip = 0, adhesion = 0, bonded = 0, opening = 0, elsewhere = 0;

  template <int D> void count(const Pair<D>& pair) {
    for (const auto& point : pair.results())
      ++(point.state == ContactState::open     ? open
         : point.state == ContactState::stick  ? stick
         : point.state == ContactState::slip   ? slip
         : point.state == ContactState::bonded ? bonded
                                               : adhesion);
    for (std::size_t i = 0; i < pair.present().bonds.size(); ++i)
      opening += pair.present().bonds[i].largest > pair.history().bonds[i].largest;
    for (const Block& block : pair.blocks()) elsewhere += block.slip_element >= 0;
    states += !pair.blocks().empty();
  }
  void add(const Census& more) {
    for (const auto of : {&Census::states, &Census::stepped_over, &Census::open, &Census::stick, &Census::slip,
                          &Census::adhesion, &Census::bonded, &Census::opening, &Census::elsewhere})
      this->*of += more.*of;
  }
  void expect(const Census& least) const {
    EXPECT_GE(states, least.states) << stepped_over << " states lay on a change of state";
    for (const auto of : {&Census::open, &Census::stick, &Census::slip, &Census::adhesion, &Census::bonded,
                          &Census::opening, &Census::elsewhere})
      if (least.*of > 0) {
        EXPECT_GT(this->*of, least.*of);
      }
  }
};

/// Both faces, or face and obstacle, move.
template <class AnyCouple> void compare_with_differences(AnyCouple& couple, Random& random, Census& census) {
  couple.evaluate();
  const Dense at = couple.dense();
  Census here;
  here.count(couple.pair);
  const bool compared = holds_in_random_directions(couple, at, random);
  couple.evaluate();
  if (compared)
    census.add(here);
  else
    ++census.stepped_over;
}

/// Forces on both bodies are those of the resultant and sum to zero; without friction their moments do, too.
template <int D, class Own> void expect_balanced(Moved<D, Own>& couple, double mu, double tolerance = 1e-13) {
  const VectorX force = couple.evaluate().dense().force;
  const Resultant<D> resultant = couple.pair.resultant();
  ASSERT_GT(resultant.active, 0);
  const MatrixX die = couple.die.points(), base = couple.base->points();
  Vec<D> on_die = Vec<D>::Zero(), on_base = Vec<D>::Zero();
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  double size = 0;
  for (int i = 0; i < couple.first_extra(); i += D) {
    const bool first = i < couple.die_dofs();
    const Vec<D> f = force.segment<D>(i);
    Eigen::Vector3d x = Eigen::Vector3d::Zero(), wide = Eigen::Vector3d::Zero();
    x.head<D>() = (first ? die.col(i / D) : base.col((i - couple.die_dofs()) / D)) + couple.u.template segment<D>(i);
    wide.head<D>() = f;
    (first ? on_die : on_base) += f;
    moment += x.cross(wide);
    size += f.norm();
  }
  EXPECT_LT((on_die + on_base).norm(), 0.1 * tolerance * size);
  // The residual holds minus the force on the slave.
  EXPECT_LT((on_die + resultant.force).norm(), tolerance * size);
  if (mu == 0) {
    EXPECT_LT(moment.norm(), tolerance * size);
  }
}

} // namespace signorini::contact::test
