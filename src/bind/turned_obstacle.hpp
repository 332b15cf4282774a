#pragma once
// Obstacles in the position to which a support has turned them, for pictures.

#include "contact/obstacle.hpp"

namespace signorini::bind {

/// The obstacle turned about a center by a rotation R.
template <int D>
contact::Obstacle<D> turned(contact::Obstacle<D> obstacle, const Vec<D>& center, const Mat<D>& rotation) {
  const auto turn = [&](Vec<D>& point) { point = (center + rotation * (point - center)).eval(); };
  if (auto* plane = std::get_if<contact::Plane<D>>(&obstacle)) {
    turn(plane->point);
    plane->normal = (rotation * plane->normal).eval();
  } else if (auto* ball = std::get_if<contact::Ball<D>>(&obstacle)) {
    turn(ball->center);
  } else if (auto* patch = std::get_if<nurbs::Patch>(&obstacle)) {
    MatrixX points = patch->homogeneous(); // w x
    const Eigen::RowVectorXd weights = points.row(D);
    points.topRows(D) = rotation * (points.topRows(D) - center * weights) + center * weights;
    *patch = {patch->directions(), points};
  }
  if constexpr (D == 3)
    if (auto* cylinder = std::get_if<contact::Cylinder>(&obstacle)) {
      turn(cylinder->point);
      cylinder->axis = (rotation * cylinder->axis).eval();
    }
  return obstacle;
}

} // namespace signorini::bind
