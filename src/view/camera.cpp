#include "view/camera.hpp"

#include "base/error.hpp"

namespace signorini::view {

Camera camera(const std::string& name) {
  const Vec<3> x = Vec<3>::UnitX(), y = Vec<3>::UnitY(), z = Vec<3>::UnitZ();
  if (name == "iso") return {{0.75, -1.5, 1}, z};
  if (name == "front") return {-y, z};
  if (name == "back") return {y, z};
  if (name == "left") return {-x, z};
  if (name == "right") return {x, z};
  if (name == "top") return {z, y};
  if (name == "bottom") return {-z, -y};
  fail("view.camera.unknown", {{"camera", name}, {"known", camera_names()}});
}

const std::vector<std::string>& camera_names() {
  static const std::vector<std::string> names = {"iso", "front", "back", "left", "right", "top", "bottom"};
  return names;
}

Camera turned_to(Camera camera, const Vec<3>& normal) {
  if (camera.from.dot(normal) > 0.1 * camera.from.norm() * normal.norm()) return camera;
  // from·n = Σ fᵢnᵢ: the addends that are against it change their sign
  for (int axis = 0; axis < 3; ++axis)
    if (camera.from[axis] * normal[axis] < 0) camera.from[axis] *= -1;
  return camera;
}

Mat<3> picture_axes(const Camera& camera) {
  require(camera.from.allFinite() && camera.up.allFinite(), "view.camera.finite");
  require(camera.from.norm() > 0 && camera.up.norm() > 0, "view.camera.zero");
  const Vec<3> eye = camera.from.normalized(), right = camera.up.normalized().cross(eye);
  require(right.norm() > 1e-6, "view.camera.parallel");
  Mat<3> axes;
  axes.row(0) = right.normalized();
  axes.row(2) = eye;
  axes.row(1) = eye.cross(right.normalized());
  return axes;
}

} // namespace signorini::view
