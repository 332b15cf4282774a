#pragma once
// An indenter above a master in 3D.

#include "contact/moved.hpp"

namespace signorini::contact::test {

/// An indenter with a bulging bottom whose lowest point is (x, y, z).
struct Couple3 : Moved<3, Couple3> {
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
      : Moved(indenter(label, at), "front", master, "back", law, points) {}
  Couple3(const std::string& label, const Obstacle<3>& master, const Law& law, const Vec<3>& at)
      : Moved(indenter(label, at), "front", master, law, 4) {}

  Couple3& turn_die(double angle, const Vec<3>& about) {
    const MatrixX points = die.points();
    const Eigen::AngleAxisd turn(angle, Vec<3>::UnitZ());
    for (int i = 0; i < die.functions(); ++i) {
      const Vec<3> x = Vec<3>(points.col(i)) + u.segment<3>(3 * i);
      u.segment<3>(3 * i) += turn * (x - about) + about - x;
    }
    return *this;
  }
};

/// Compares and accepts after each drag, with small random displacements.
inline void drag_and_compare(Couple3& couple, Random& random, std::initializer_list<Vec<3>> drags, Census& census) {
  for (const Vec<3>& drag : drags) {
    couple.move_die(drag).shake(random, 0.0003);
    compare_with_differences(couple, random, census);
    couple.pair.accept();
  }
}

} // namespace signorini::contact::test
