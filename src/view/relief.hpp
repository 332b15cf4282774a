#pragma once
// Surfaces in space as the renderer takes them: x and y in pixels of the picture, z in pixels towards the eye. What is
// nearer to the eye hides what is behind it.

#include "view/drawing.hpp"

namespace signorini::view {

using Vec3 = std::array<double, 3>;

/// A lit surface coloured by interpolated values.
struct Shaded {
  std::vector<Vec3> points, normals;
  std::vector<std::array<int, 3>> triangles;
  std::vector<double> values; ///< one per point
  std::array<double, 2> range;
  std::vector<Rgb> colours; ///< evenly spread over the range
};

/// Triangles of plain colour without light.
struct Ink {
  std::vector<Vec3> corners; ///< three per triangle
  std::vector<Rgb> colours;  ///< one per triangle
};

/// Lit translucent triangles behind all else, so that they tint no colour that has a meaning; each is laid over those
/// before it.
struct Veil {
  std::vector<Vec3> corners, normals;               ///< three per triangle
  std::vector<std::array<std::uint8_t, 4>> colours; ///< with opacity, one per triangle
};

struct Relief {
  std::vector<Shaded> surfaces;
  Ink ink;
  Veil veil;
};

} // namespace signorini::view
