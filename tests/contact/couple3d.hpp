#pragma once
// An indenter above a master in 3D, with all displacements in one vector, and a comparison of its tangent with finite
// differences.

#include "contact/faces3d.hpp"
#include "contact/tangents.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>

namespace signorini::contact::test {

/// An indenter with a bulging bottom whose lowest point is (x, y, z), above a master; all displacements in one vector,
/// then the master body's or the obstacle's, then additional unknowns.
struct Couple3 {
  nurbs::Discretization die;
  std::optional<nurbs::Discretization> base;
  Pair<3> pair;
  VectorX u;

  static nurbs::Discretization indenter(const std::string& label, const Vec<3>& at) {
    nurbs::Plan plan;
    plan.elements = {2, 2, 1};
    plan.contact = {nurbs::side_of("front", 3)};
    plan.labels.assign(2, nurbs::parse_label(label));
    plan.thickness_degree = 1;
    return {nurbs::spherical_indenter(1, 1, 0.8, 1.2, 2, at - Vec<3>(0.5, 0.5, 0)), plan};
  }
  Couple3(const std::string& label, const nurbs::Discretization& master, const Law& law, const Vec<3>& at,
          int points = 4)
      : die(indenter(label, at)), base(master),
        pair(Surface<3>(die, nurbs::side_of("front", 3)), top_of(*base), law, points),
        u(VectorX::Zero(3 * (die.functions() + base->functions()) + pair.extra_unknowns())) {}
  Couple3(const std::string& label, const Obstacle<3>& master, const Law& law, const Vec<3>& at)
      : die(indenter(label, at)), pair(Surface<3>(die, nurbs::side_of("front", 3)), master, law, 4),
        u(VectorX::Zero(3 * (die.functions() + 1) + pair.extra_unknowns())) {}

  int die_dofs() const { return 3 * die.functions(); }
  int base_dofs() const { return 3 * (base ? base->functions() : 1); }
  int first_extra() const { return die_dofs() + base_dofs(); }
  void evaluate(const VectorX& at) {
    pair.evaluate(at.data(), at.data() + die_dofs(), true, at.data() + first_extra());
  }
  void evaluate() { evaluate(u); }
  Dense dense() const { return test::dense(pair, die_dofs(), base_dofs()); }
  void move_die(const Vec<3>& by) {
    for (int i = 0; i < die_dofs(); i += 3) u.segment<3>(i) += by;
  }
  void turn_die(double angle, const Vec<3>& about) {
    const MatrixX points = die.points();
    const Eigen::AngleAxisd turn(angle, Vec<3>::UnitZ());
    for (int i = 0; i < die.functions(); ++i) {
      const Vec<3> x = Vec<3>(points.col(i)) + u.segment<3>(3 * i);
      u.segment<3>(3 * i) += turn * (x - about) + about - x;
    }
  }
  void touch() {
    for (int round = 0; round < 10; ++round) {
      evaluate();
      const std::vector<double> gaps = pair.gaps();
      move_die({0, 0, -*std::min_element(gaps.begin(), gaps.end())});
    }
    evaluate();
    pair.accept();
  }
  void shake(Random& random, double size) {
    for (int i = 0; i < u.size(); ++i) u(i) += uniform(random, -size, size);
  }
};

struct Census3 {
  int compared = 0, stepped_over = 0, stick = 0, slip = 0, elsewhere = 0;
};

/// Both faces, or face and obstacle, move.
inline void compare_with_differences(Couple3& couple, Random& random, Census3& census) {
  couple.evaluate();
  const Dense at = couple.dense();
  Census3 here = census;
  for (const auto& point : couple.pair.results()) {
    here.stick += point.state == ContactState::stick;
    here.slip += point.state == ContactState::slip;
  }
  for (const Block& block : couple.pair.blocks()) here.elsewhere += block.slip_element >= 0;
  ++here.compared;
  const bool compared = holds_in_random_directions(couple, at, random);
  couple.evaluate();
  if (compared)
    census = here;
  else
    ++census.stepped_over;
}

/// Compares and accepts after each drag, with small random displacements.
inline void drag_and_compare(Couple3& couple, Random& random, std::initializer_list<Vec<3>> drags, Census3& census) {
  for (const Vec<3>& drag : drags) {
    couple.move_die(drag);
    couple.shake(random, 0.0003);
    compare_with_differences(couple, random, census);
    couple.pair.accept();
  }
}

} // namespace signorini::contact::test
