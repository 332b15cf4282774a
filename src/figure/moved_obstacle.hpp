#pragma once
// Obstacles in the position to which a support has moved and turned them, for pictures.

#include "contact/rigid/obstacle.hpp"

#include <Eigen/Geometry>

namespace signorini::figure {

/// x ↦ c + t + R (x − c).
template <int D> using Motion = Eigen::Transform<double, D, Eigen::Isometry>;

template <int D> Motion<D> motion_about(const Vec<D>& center, const Mat<D>& rotation, const Vec<D>& shift) {
  Motion<D> motion = Motion<D>::Identity();
  motion.linear() = rotation;
  motion.translation() = center + shift - rotation * center;
  return motion;
}

/// The moved obstacle; a level set, which its formula describes in its own frame, remains there.
template <int D> contact::Obstacle<D> moved(contact::Obstacle<D> obstacle, const Motion<D>& motion) {
  const auto move = [&](Vec<D>& point) { point = (motion * point).eval(); };
  const auto turn = [&](Vec<D>& direction) { direction = (motion.linear() * direction).eval(); };
  if (auto* plane = std::get_if<contact::Plane<D>>(&obstacle)) {
    move(plane->point);
    turn(plane->normal);
  } else if (auto* ball = std::get_if<contact::Ball<D>>(&obstacle)) {
    move(ball->center);
  } else if (auto* patch = std::get_if<nurbs::Patch>(&obstacle)) {
    MatrixX points = patch->homogeneous(); // w x
    points.topRows(D) = (motion.linear() * points.topRows(D) + motion.translation() * points.row(D)).eval();
    *patch = {patch->directions(), points};
  }
  if constexpr (D == 3) {
    if (auto* cylinder = std::get_if<contact::Cylinder>(&obstacle)) {
      move(cylinder->point);
      turn(cylinder->axis);
    } else if (auto* torus = std::get_if<contact::Torus>(&obstacle)) {
      move(torus->center);
      turn(torus->axis);
    }
  }
  return obstacle;
}

} // namespace signorini::figure
