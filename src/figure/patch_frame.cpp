#include "figure/frame.hpp"

#include <utility>

namespace signorini::figure {

namespace {

using nurbs::Patch;

/// Parameters at fractions of the parametric intervals.
VectorX parameters(const Patch& patch, const VectorX& fractions) {
  VectorX xi(patch.parametric_dimension());
  for (int d = 0; d < xi.size(); ++d) {
    const nurbs::KnotVector& knots = patch.direction(d);
    xi(d) = knots.first() + fractions(d) * (knots.last() - knots.first());
  }
  return xi;
}

Vec<3> place_at(const Patch& patch, const VectorX& fractions) {
  return tessellation::place(patch, parameters(patch, fractions));
}

/// True if ξ¹, ξ², ξ³ of a volume are a left-handed system.
bool left_handed(const Patch& volume) {
  const auto all = nurbs::derivatives(volume, parameters(volume, Vec<3>::Constant(0.5)), 1);
  const Vec<3> first = all[1].value, second = all[2].value, third = all[3].value;
  return first.cross(second).dot(third) < 0;
}

double outward(const Patch& volume, nurbs::Side side) {
  return (left_handed(volume) ? -1 : 1) * nurbs::outward_sign(side);
}

/// The patch, or the six sides of a volume, the first one with the control points.
std::vector<tessellation::Skin> pieces_of(const Patch& patch, const std::vector<Window>& windows) {
  std::vector<tessellation::Skin> pieces;
  if (patch.parametric_dimension() < 3)
    pieces.push_back(tessellation::tessellate(patch, 1, windows));
  else
    for (const nurbs::Side side : nurbs::sides(patch.parametric_dimension()))
      pieces.push_back(tessellation::tessellate(nurbs::face(patch, side), outward(patch, side), windows));
  pieces[0].control_points.setZero(3, patch.functions());
  pieces[0].control_points.topRows(patch.dimension()) = patch.points();
  for (int d = 0, stride = 1; d < patch.parametric_dimension(); ++d) {
    const int count = patch.direction(d).functions();
    for (int i = 0; i < patch.functions(); ++i)
      if (i / stride % count > 0) pieces[0].net_lines.push_back({i - stride, i});
    stride *= count;
  }
  return pieces;
}

/// The name of a side at its center: next to the border of a surface; on a volume only where the side faces the eye.
view::Label side_label(const Patch& patch, nurbs::Side side) {
  const int n = patch.parametric_dimension();
  VectorX middle = VectorX::Constant(n, 0.5), inwards = middle;
  middle(side.direction) = side.at_end ? 1 : 0;
  inwards(side.direction) = side.at_end ? 0.95 : 0.05;
  view::Label label{place_at(patch, middle), nurbs::name_of(side)};
  if (n < 3)
    label.shift = place_at(patch, inwards) - label.at;
  else {
    const auto all = nurbs::derivatives(patch, parameters(patch, middle), 1);
    const Vec<3> first = all[side.direction == 0 ? 2 : 1].value, second = all[side.direction == 2 ? 2 : 3].value;
    label.normal = outward(patch, side) * first.cross(second);
  }
  return label;
}

/// Along the first quarter of all edges of a direction.
view::Arrow direction_arrow(const Patch& patch, int direction) {
  constexpr double length = 0.25;
  constexpr int points = 65;
  constexpr const char* names[] = {"ξ¹", "ξ²", "ξ³"};
  const int n = patch.parametric_dimension();
  view::Arrow arrow{{}, names[direction]};
  for (int edge = 0; edge < 1 << (n - 1); ++edge) {
    VectorX fractions = VectorX::Zero(n);
    for (int d = 0, bit = 0; d < n; ++d)
      if (d != direction) fractions(d) = edge >> bit++ & 1;
    view::Points line(3, points);
    for (int k = 0; k < points; ++k) {
      fractions(direction) = length * k / (points - 1);
      line.col(k) = place_at(patch, fractions);
    }
    arrow.lines.push_back(std::move(line));
    if (n == 2) break; // all edges of a surface are visible
  }
  return arrow;
}

view::Names patch_names(const std::vector<Patch>& patches) {
  view::Names names;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const Patch& patch = patches[p];
    const int n = patch.parametric_dimension();
    if (n > 1)
      for (const nurbs::Side side : nurbs::sides(patch.parametric_dimension()))
        names.labels.push_back(side_label(patch, side));
    for (int d = 0; d < n; ++d) names.arrows.push_back(direction_arrow(patch, d));
    if (patches.size() > 1) names.labels.push_back({place_at(patch, VectorX::Constant(n, 0.5)), std::to_string(p + 1)});
  }
  return names;
}

} // namespace

view::Panel show(const std::vector<Patch>& patches, const Showing& showing) {
  view::Panel panel;
  for (const Patch& patch : patches)
    for (tessellation::Skin& piece : pieces_of(patch, showing.windows)) {
      if (patch.dimension() == 2) piece.normals.resize(3, 0);
      panel.bodies.push_back(picture_body(std::move(piece), showing));
      panel.bodies.back().open = patch.parametric_dimension() < 3;
    }
  if (showing.names) panel.names = patch_names(patches);
  return panel;
}

} // namespace signorini::figure
