#include "view/picture_checks.hpp"

#include "base/error.hpp"
#include "view/sheet.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace signorini::view {
namespace {

/// "state 2," of several.
Message where(std::size_t count, std::size_t number) {
  return count > 1 ? Message("view.sheet.state", {{"number", number}}) : Message();
}

void check(const Surface& surface, const Message& name) {
  require(surface.points.allFinite() && surface.normals.allFinite(), "view.body.points", {{"body", name}});
  require(surface.triangles.size() == 0 ||
              (surface.triangles.minCoeff() >= 0 && surface.triangles.maxCoeff() < surface.points.cols()),
          "view.body.triangles", {{"body", name}, {"most", surface.points.cols() - 1}});
  require(surface.values.size() == 0 || surface.values.size() == surface.points.cols(), "view.body.values",
          {{"body", name}, {"values", surface.values.size()}, {"points", surface.points.cols()}});
  require(surface.values.allFinite(), "view.body.field", {{"body", name}});
}

void check_net(const Points& control_points, const std::vector<std::array<int, 2>>& lines, const Message& name) {
  require(control_points.allFinite(), "view.body.points", {{"body", name}});
  for (const auto& [from, to] : lines)
    require(std::min(from, to) >= 0 && std::max(from, to) < control_points.cols(), "view.body.net",
            {{"body", name}, {"most", control_points.cols() - 1}});
}

void check(const Body& body, const Message& name) {
  check(static_cast<const Surface&>(body), name);
  check_net(body.control_points, body.net_lines, name);
  bool finite = true;
  for (const MeshLine& line : body.mesh_lines) finite &= line.points.allFinite() && line.spacing >= 0;
  for (const auto* lines : {&body.rim, &body.undeformed})
    for (const Points& line : *lines) finite &= line.allFinite();
  require(finite, "view.body.lines", {{"body", name}});
}

void check(const Solid& body, const Message& name) {
  for (const Surface* surface : {&body.skin, &body.undeformed}) {
    check(*surface, name);
    require(surface->normals.cols() == surface->points.cols(), "view.body.normals",
            {{"body", name}, {"normals", surface->normals.cols()}, {"points", surface->points.cols()}});
  }
  check_net(body.control_points, body.net_lines, name);
  bool finite = true;
  for (const auto* lines : {&body.mesh_lines, &body.rim, &body.undeformed_rim})
    for (const SurfaceLine& line : *lines) finite &= line.points.allFinite() && line.normals.allFinite();
  for (const Lattice& lattice : body.inside) finite &= lattice.points.allFinite() && lattice.values.allFinite();
  require(finite, "view.body.inside", {{"body", name}});
}

template <class Panel> void check_all(const std::vector<Panel>& panels) {
  require(!panels.empty(), "view.sheet.empty");
  for (std::size_t p = 0; p < panels.size(); ++p) {
    const Message state = where(panels.size(), p);
    for (std::size_t b = 0; b < panels[p].bodies.size(); ++b)
      check(panels[p].bodies[b], Message("view.sheet.body", {{"state", state}, {"number", b}}));
    for (const PointMark& mark : panels[p].marks)
      require(mark.at.allFinite(), "view.sheet.mark", {{"state", state}, {"mark", mark.text}});
  }
}

std::array<double, 6> corners(const Bounds& box) {
  return {box.low[0], box.high[0], box.low[1], box.high[1], box.low[2], box.high[2]};
}

std::array<double, 2> range_of(const Bounds& box, int axis) {
  return {box.low[axis], box.high[axis]};
}

/// Of all bodies in all states.
Bounds bounds_of(const std::vector<SolidPanel>& panels) {
  Bounds all;
  for (const SolidPanel& panel : panels)
    for (const Solid& body : panel.bodies) {
      const Bounds own = bounds(body);
      all.take(own.low);
      all.take(own.high);
    }
  return all;
}

} // namespace

void check(const std::vector<Panel>& panels) {
  check_all(panels);
  for (std::size_t p = 0; p < panels.size(); ++p)
    for (const Outline& outline : panels[p].obstacles)
      require(outline.line.allFinite(), "view.sheet.obstacle", {{"state", where(panels.size(), p)}});
}

void check(const std::vector<SolidPanel>& panels) {
  check_all(panels);
  for (std::size_t p = 0; p < panels.size(); ++p)
    if (const auto& cut = panels[p].cut)
      require(cut->point.allFinite() && cut->normal.allFinite() && cut->normal.norm() > 0, "view.sheet.cut",
              {{"state", where(panels.size(), p)}});
}

void check_region(const Box& box, const std::string& argument) {
  require(std::all_of(box.begin(), box.end(), [](double v) { return std::isfinite(v); }) && box[0] < box[1] &&
              box[2] < box[3],
          "view.picture.box", {{"argument", argument}, {"box", box}});
}

void check_region(const Bounds& region, const std::string& argument) {
  require(region.low.allFinite() && region.high.allFinite() && (region.low.array() < region.high.array()).all(),
          "view.solids.region", {{"argument", argument}, {"box", corners(region)}});
}

void check_part(const std::vector<Panel>& panels, const PictureOptions& options, const std::string& argument) {
  if (!options.crop) return;
  check(panels);
  const Box &part = *options.crop, all = hull(model_boxes(panels, {}));
  check_region(part, argument);
  require(
      part[0] < all[1] && all[0] < part[1] && part[2] < all[3] && all[2] < part[3], "view.picture.outside",
      {{"argument", argument}, {"box", part}, {"x", std::array{all[0], all[1]}}, {"y", std::array{all[2], all[3]}}});
}

void check_part(const std::vector<SolidPanel>& panels, const SolidOptions& options, const std::string& argument) {
  if (!options.region) return;
  const Bounds &part = *options.region, all = bounds_of(panels);
  check_region(part, argument);
  require((part.low.array() < all.high.array()).all() && (all.low.array() < part.high.array()).all(),
          "view.solids.outside",
          {{"argument", argument},
           {"box", corners(part)},
           {"x", range_of(all, 0)},
           {"y", range_of(all, 1)},
           {"z", range_of(all, 2)}});
}

void check_cuts(const std::vector<SolidPanel>& panels) {
  const Bounds all = bounds_of(panels);
  for (const SolidPanel& panel : panels) {
    if (!panel.cut) return;
    const Vec<3> normal = panel.cut->normal.normalized();
    for (const Solid& body : panel.bodies)
      if (body.skin.points.cols() > 0 &&
          (normal.transpose() * (body.skin.points.colwise() - panel.cut->point)).maxCoeff() > 1e-9 * all.size())
        return;
  }
  fail("view.solids.idle_cut", {{"x", range_of(all, 0)}, {"y", range_of(all, 1)}, {"z", range_of(all, 2)}});
}

} // namespace signorini::view
