#pragma once
// Coordinates on obstacles in files of version 7: angles from fixed directions, on planes lengths from a given point.

#include "contact/point/history.hpp"
#include "contact/rigid/obstacle.hpp"

namespace signorini::contact {

/// The place that such coordinates describe, in the obstacle's own frame.
template <int D> Vec<D> former_place(const Plane<D>& plane, const FaceCoordinates<D>& xi);
Vec<2> former_place(const Ball<2>& ball, const FaceCoordinates<2>& xi);
Vec<3> former_place(const Ball<3>& ball, const FaceCoordinates<3>& xi);
Vec<3> former_place(const Cylinder& cylinder, const FaceCoordinates<3>& xi);
Vec<3> former_place(const Torus& torus, const FaceCoordinates<3>& xi);

/// Replaces the coordinates of a history by those that describe the same places now.
template <int D> void update_coordinates(const Obstacle<D>& obstacle, History<D>& history);

} // namespace signorini::contact
