// Checks of the arguments of pictures.

#include "view/picture.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <array>

namespace signorini::view {
namespace {

/// "state 2," if there are several.
Message where(const std::vector<Panel>& panels, std::size_t number) {
  return panels.size() > 1 ? Message("view.sheet.state", {{"number", number}}) : Message();
}

void check(const Surface& surface, const Message& name) {
  require(surface.points.allFinite() && surface.normals.allFinite(), "view.body.points", {{"body", name}});
  require(surface.triangles.size() == 0 ||
              (surface.triangles.minCoeff() >= 0 && surface.triangles.maxCoeff() < surface.points.cols()),
          "view.body.triangles", {{"body", name}, {"most", surface.points.cols() - 1}});
  require(surface.values.size() == 0 || surface.values.size() == surface.points.cols(), "view.body.values",
          {{"body", name}, {"values", surface.values.size()}, {"points", surface.points.cols()}});
  require(!surface.values.array().isInf().any(), "view.body.field", {{"body", name}});
  require(surface.normals.cols() == 0 || surface.normals.cols() == surface.points.cols(), "view.body.normals",
          {{"body", name}, {"normals", surface.normals.cols()}, {"points", surface.points.cols()}});
}

void check(const Body& body, const Message& name) {
  check(body.skin, name);
  check(body.undeformed, name);
  require(body.control_points.allFinite(), "view.body.points", {{"body", name}});
  for (const auto& [from, to] : body.net_lines)
    require(std::min(from, to) >= 0 && std::max(from, to) < body.control_points.cols(), "view.body.net",
            {{"body", name}, {"most", body.control_points.cols() - 1}});
  bool finite = true;
  for (const auto* lines : {&body.mesh_lines, &body.rim, &body.undeformed_rim})
    for (const SurfaceLine& line : *lines)
      finite &= line.points.allFinite() && line.normals.allFinite() && line.spacing >= 0;
  for (const Lattice& lattice : body.inside)
    finite &= lattice.points.allFinite() && !lattice.values.array().isInf().any();
  require(finite, "view.body.inside", {{"body", name}});
}

/// {xmin, xmax, ymin, ymax, zmin, zmax} or, for two axes, the first four of them.
std::vector<double> sides(const Bounds& box, int axes) {
  std::vector<double> all;
  for (int axis = 0; axis < axes; ++axis) all.insert(all.end(), {box.low[axis], box.high[axis]});
  return all;
}

std::array<double, 2> range_of(const Bounds& box, int axis) {
  return {box.low[axis], box.high[axis]};
}

/// Bounds of all bodies in all states.
Bounds bounds_of(const std::vector<Panel>& panels) {
  Bounds all;
  for (const Panel& panel : panels) all.take(bounds(panel.bodies));
  return all;
}

/// Bounds of everything that plane states show.
Bounds plane_bounds(const std::vector<Panel>& panels, PictureOptions options) {
  options.crop.reset();
  options.range = {0, 1};
  align(options, panels);
  const auto& [left, right, bottom, top] = *options.extent;
  return {{left, bottom, 0}, {right, top, 0}};
}

} // namespace

void check(const std::vector<Panel>& panels) {
  require(!panels.empty(), "view.sheet.empty");
  for (std::size_t p = 0; p < panels.size(); ++p) {
    const Message state = where(panels, p);
    for (std::size_t b = 0; b < panels[p].bodies.size(); ++b)
      check(panels[p].bodies[b], Message("view.sheet.body", {{"state", state}, {"number", b}}));
    for (const PointMark& mark : panels[p].marks)
      require(mark.at.allFinite(), "view.sheet.mark", {{"state", state}, {"mark", mark.text}});
    for (const Outline& outline : panels[p].outlines)
      require(outline.line.allFinite(), "view.sheet.obstacle", {{"state", state}});
    if (const auto& cut = panels[p].cut)
      require(cut->point.allFinite() && cut->normal.allFinite() && cut->normal.norm() > 0, "view.sheet.cut",
              {{"state", state}});
  }
}

void check_part(const std::vector<Panel>& panels, const PictureOptions& options, const std::string& argument) {
  if (!options.crop) return;
  const bool plane = !options.camera;
  const Bounds &part = *options.crop, all = plane ? plane_bounds(panels, options) : bounds_of(panels);
  const Eigen::Index axes = plane ? 2 : 3;
  if ((part.low.array() < all.high.array()).head(axes).all() && (all.low.array() < part.high.array()).head(axes).all())
    return;
  require(!plane, "view.picture.outside",
          {{"argument", argument}, {"box", sides(part, 2)}, {"x", range_of(all, 0)}, {"y", range_of(all, 1)}});
  fail("view.solids.outside", {{"argument", argument},
                               {"box", sides(part, 3)},
                               {"x", range_of(all, 0)},
                               {"y", range_of(all, 1)},
                               {"z", range_of(all, 2)}});
}

void check_cuts(const std::vector<Panel>& panels) {
  const Bounds all = bounds_of(panels);
  for (const Panel& panel : panels) {
    if (!panel.cut) return;
    const Vec<3> normal = panel.cut->normal.normalized();
    for (const Body& body : panel.bodies)
      if (body.skin.points.cols() > 0 &&
          (normal.transpose() * (body.skin.points.colwise() - panel.cut->point)).maxCoeff() > 1e-9 * all.size())
        return;
  }
  fail("view.solids.idle_cut", {{"x", range_of(all, 0)}, {"y", range_of(all, 1)}, {"z", range_of(all, 2)}});
}

} // namespace signorini::view
