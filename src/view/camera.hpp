#pragma once
// Parallel projection of solids along one direction; three axis arrows and a ruler take the place of numbered axes.

#include "base/eigen.hpp"
#include "view/frame.hpp"

#include <string>
#include <vector>

namespace signorini::view {

struct Camera {
  Vec<3> from; ///< direction from the scene to the eye, nonzero, of any length
  Vec<3> up;   ///< points upwards in the picture; not parallel to `from`

  bool operator==(const Camera&) const = default;
};

/// front, back, left, right, top, bottom: along an axis, z upwards (front: from −y, with x to the right; top: y
/// upwards); iso: from the front, the right and above. Throws Error on an unknown name.
Camera camera(const std::string& name);
const std::vector<std::string>& camera_names();

/// The camera mirrored so that faces with this normal face the eye: each component of `from` that points away from the
/// normal changes sign.
Camera turned_to(Camera camera, const Vec<3>& normal);

/// The picture's axes as rows: to the right, upwards, towards the eye. Throws Error when a direction of the camera is
/// zero or both are parallel.
Mat<3> picture_axes(const Camera& camera);

/// Pixels that the arrows and their names need left, right, below and above of their origin. `axes`: the picture's axes
/// as rows.
std::array<double, 4> triad_room(const Mat<3>& axes, const std::array<std::string, 3>& names, const Style& style);

void draw_triad(Drawing& drawing, const Vec2& at, const Mat<3>& axes, const std::array<std::string, 3>& names,
                const Style& style);

/// Height of a ruler, pixels.
double ruler_room(const Style& style);

/// Draws a line of a round length, about a fifth of the frame's width, with its length and unit at its end. `at`:
/// bottom left start of the line, pixels.
void draw_ruler(Drawing& drawing, const Vec2& at, const Scale& scale, const std::string& unit, const Style& style);

/// The largest 1, 2 or 5 × 10ᵏ that does not exceed a positive value.
double round_below(double value);

} // namespace signorini::view
