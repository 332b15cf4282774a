#include "tessellation/grid.hpp"

namespace signorini::tessellation {

namespace {

/// Appends a piece to a line; adjacent pieces share a point.
void append(SkinLine& line, const SkinLine& piece) {
  const auto add = [](Points& points, const Points& more) {
    if (more.cols() == 0) return;
    const Eigen::Index kept = std::max<Eigen::Index>(points.cols() - 1, 0);
    points.conservativeResize(3, kept + more.cols());
    points.rightCols(more.cols()) = more;
  };
  add(line.points, piece.points);
  add(line.normals, piece.normals);
}

} // namespace

void add_triangles(Triangles& triangles, Eigen::Index& next, const Grid& grid) {
  for (int j = 0; j + 1 < grid.rows(); ++j)
    for (int i = 0; i + 1 < grid.columns(); ++i) {
      const int corner = static_cast<int>(grid(i, j)), side = grid.columns();
      triangles.col(next++) << corner, corner + 1, corner + side + 1;
      triangles.col(next++) << corner, corner + side + 1, corner + side;
    }
}

SkinLine border(const Skin& skin, const Grid& grid, int along, bool at_end) {
  const int right = grid.columns() - 1, top = grid.rows() - 1, count = along == 0 ? right : top,
            fixed = !at_end      ? 0
                    : along == 0 ? top
                                 : right;
  const bool has_normals = skin.normals.cols() > 0;
  SkinLine line{Points(3, count + 1), Points(3, has_normals ? count + 1 : 0), 0};
  for (int k = 0; k <= count; ++k) {
    const Eigen::Index point = along == 0 ? grid(k, fixed) : grid(fixed, k);
    line.points.col(k) = skin.points.col(point);
    if (has_normals) line.normals.col(k) = skin.normals.col(point);
  }
  line.spacing = along == 0 ? (skin.points.col(grid(right / 2, top)) - skin.points.col(grid(right / 2, 0))).norm()
                            : (skin.points.col(grid(right, top / 2)) - skin.points.col(grid(0, top / 2))).norm();
  return line;
}

void add_borders(Skin& skin, const Grid& grid, std::array<int, 2> element, std::array<int, 2> counts) {
  skin.rim.resize(4, SkinLine{Points(3, 0), Points(3, 0), 0});
  for (int along : {0, 1})
    for (bool at_end : {false, true}) {
      const int place = element[1 - along];
      if (place == (at_end ? counts[1 - along] - 1 : 0))
        append(skin.rim[2 * along + at_end], border(skin, grid, along, at_end));
      else if (!at_end)
        skin.mesh_lines.push_back(border(skin, grid, along, false));
    }
}

} // namespace signorini::tessellation
