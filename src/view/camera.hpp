#pragma once
// Solids on paper: parallel projection along one direction, and what tells directions and lengths there, where no
// numbers stand along axes: three arrows and a ruler.

#include "base/eigen.hpp"
#include "view/frame.hpp"

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
/// are zero, or one along the other.
Mat<3> picture_axes(const Camera& camera);

/// Pixels that the arrows and their names take left, right, below and above of where the axes meet. `axes`: the
/// picture's own, as rows.
std::array<double, 4> triad_room(const Mat<3>& axes, const std::array<std::string, 3>& names, const Style& style);

void draw_triad(Drawing& drawing, const Vec2& at, const Mat<3>& axes, const std::array<std::string, 3>& names,
                const Style& style);

/// Pixels that a ruler takes of the height.
double ruler_room(const Style& style);

/// Draws a line of a round length, about a fifth of the frame's width, with its length and unit at its end. `at`: its
/// start at the bottom left.
void draw_ruler(Drawing& drawing, const Vec2& at, const Scale& scale, const std::string& unit, const Style& style);

/// The greatest 1, 2 or 5 × 10ᵏ that is no more than a positive value.
double round_below(double value);

} // namespace signorini::view
