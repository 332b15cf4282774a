#pragma once
// Where a picture of solids is seen from: parallel projection along one direction.

#include "base/eigen.hpp"

#include <string>
#include <vector>

namespace signorini::view {

struct Camera {
  Vec<3> from; ///< direction from the scene to the eye, of any length but zero
  Vec<3> up;   ///< points upwards in the picture; not along `from`

  bool operator==(const Camera&) const = default;
};

/// front, back, left, right, top, bottom: along an axis, z upwards (front: from −y, with x to the right; top: y
/// upwards); iso: from the front, the right and above. Throws Error on an unknown name.
Camera camera(const std::string& name);
const std::vector<std::string>& camera_names();

/// The camera turned so that it sees what faces along the normal: to the other side of the axes along which it would
/// look at its back.
Camera turned_to(Camera camera, const Vec<3>& normal);

/// The picture's own axes as rows: to the right, upwards, towards the eye. Throws Error when the camera's directions
/// are not finite, zero, or one along the other.
Mat<3> picture_axes(const Camera& camera);

} // namespace signorini::view
