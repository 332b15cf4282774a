#pragma once
// Grid of points of an element, its triangles, and its borders as lines.

#include "tessellation/tessellate.hpp"

namespace signorini::tessellation {

/// Grid of points of a plane element, of a side of a solid element, or of a patch.
struct Grid {
  const std::vector<double>&along, &across; ///< fractions in its two directions
  Eigen::Index first;                       ///< index of its first point in the skin

  int columns() const { return std::ssize(along); }
  int rows() const { return std::ssize(across); }
  Eigen::Index size() const { return Eigen::Index(columns()) * rows(); }
  Eigen::Index triangles() const { return 2 * Eigen::Index(columns() - 1) * (rows() - 1); }
  Eigen::Index operator()(int i, int j) const { return first + i + Eigen::Index(columns()) * j; }
};

/// A point of a surface.
struct SkinPoint {
  Vec<3> position = Vec<3>::Zero(), normal = Vec<3>::Zero();
  double value = 0;
};

void add_triangles(Triangles& triangles, Eigen::Index& next, const Grid& grid);

/// A skin, with normals and values if `lit` and `valued`. each(visit) calls visit(element, along, across) for each
/// element with the fractions of its grid, in the order of the points; point(element, s, t) is the SkinPoint at two
/// fractions, and add_lines(skin, grid, element) adds the element's borders.
template <class Each, class PointAt, class AddLines>
Skin make_skin(bool lit, bool valued, const Each& each, const PointAt& point, const AddLines& add_lines) {
  using Fractions = std::vector<double>;
  Skin skin;
  Eigen::Index points = 0, triangles = 0, first = 0, triangle = 0;
  each([&](const auto&, const Fractions& along, const Fractions& across) {
    points += Grid{along, across, 0}.size(), triangles += Grid{along, across, 0}.triangles();
  });
  skin.points.resize(3, points);
  if (lit) skin.normals.resize(3, points);
  skin.triangles.resize(3, triangles);
  if (valued) skin.values.resize(points);
  each([&](const auto& element, const Fractions& along, const Fractions& across) {
    const Grid grid{along, across, first};
    for (const double t : across)
      for (const double s : along) {
        const SkinPoint at = point(element, s, t);
        skin.points.col(first) = at.position;
        if (lit) skin.normals.col(first) = at.normal;
        if (valued) skin.values(first) = at.value;
        ++first;
      }
    add_triangles(skin.triangles, triangle, grid);
    add_lines(skin, grid, element);
  });
  return skin;
}

/// The element's border in one of its directions, at the start or end of the other one.
SkinLine border(const Skin& skin, const Grid& grid, int along, bool at_end);

/// Adds the borders of element (i, j) to the lines between elements, each once, and to the rim, one line for each of
/// the four sides. Elements must be added in order; `counts`: numbers of elements.
void add_borders(Skin& skin, const Grid& grid, std::array<int, 2> element, std::array<int, 2> counts);

} // namespace signorini::tessellation
