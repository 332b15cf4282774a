#include "view/solid_checks.hpp"

#include "base/error.hpp"
#include "view/extent_text.hpp"

#include <algorithm>

namespace signorini::view {
namespace {

std::string text_of(const Bounds& box) {
  return text("{", box.low[0], ", ", box.high[0], ", ", box.low[1], ", ", box.high[1], ", ", box.low[2], ", ",
              box.high[2], "}");
}

std::string extent_of(const Bounds& box) {
  return text(extent_text("x", box.low[0], box.high[0]), ", ", extent_text("y", box.low[1], box.high[1]), ", ",
              extent_text("z", box.low[2], box.high[2]));
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

void check(const Surface& surface, const std::string& name) {
  require(surface.points.allFinite() && surface.normals.allFinite(), name,
          " has coordinates that are not finite; nothing can be drawn");
  require(surface.normals.cols() == surface.points.cols(), name, " has ", surface.normals.cols(), " normals for ",
          surface.points.cols(), " points; give one per point");
  require(surface.triangles.size() == 0 ||
              (surface.triangles.minCoeff() >= 0 && surface.triangles.maxCoeff() < surface.points.cols()),
          name, " has triangles that name points outside 0 … ", surface.points.cols() - 1);
  require(surface.values.size() == 0 || surface.values.size() == surface.points.cols(), name, " has ",
          surface.values.size(), " values for ", surface.points.cols(), " points; give one per point or none");
  require(surface.values.allFinite(), name,
          " has field values that are not finite; solve the state first, or choose another field");
}

} // namespace

void check(const std::vector<SolidPanel>& panels) {
  require(!panels.empty(), "a sheet needs at least one state, none came");
  for (std::size_t p = 0; p < panels.size(); ++p) {
    const std::string where = panels.size() > 1 ? text("state ", p + 1, ", ") : "";
    for (std::size_t b = 0; b < panels[p].bodies.size(); ++b) {
      const Solid& body = panels[p].bodies[b];
      const std::string name = text(where, "body ", b + 1);
      check(body.skin, name);
      check(body.undeformed, name);
      bool finite = body.control_points.allFinite();
      for (const auto* lines : {&body.mesh_lines, &body.rim, &body.undeformed_rim})
        for (const SurfaceLine& line : *lines) finite &= line.points.allFinite() && line.normals.allFinite();
      for (const Lattice& lattice : body.inside) finite &= lattice.points.allFinite() && lattice.values.allFinite();
      for (const auto& line : body.net_lines)
        require(std::min(line[0], line[1]) >= 0 && std::max(line[0], line[1]) < body.control_points.cols(), name,
                " has a net line that names control points outside 0 … ", body.control_points.cols() - 1);
      require(finite, name, " has lines or insides that are not finite; nothing can be drawn");
    }
    for (const PointMark& mark : panels[p].marks)
      require(mark.at.allFinite(), where, "the mark '", mark.text, "' stands at a place that is not finite");
    if (const auto& cut = panels[p].cut)
      require(cut->point.allFinite() && cut->normal.allFinite() && cut->normal.norm() > 0, where,
              "a cut needs a finite point and a normal that is not zero");
  }
}

void check_region(const Bounds& region, const std::string& argument) {
  require(region.low.allFinite() && region.high.allFinite() && (region.low.array() < region.high.array()).all(),
          argument, " is ", text_of(region), "; expected {xmin, xmax, ymin, ymax, zmin, zmax} with min below max");
}

void check_part(const std::vector<SolidPanel>& panels, const SolidOptions& options, const std::string& argument) {
  if (!options.region) return;
  const Bounds &part = *options.region, all = bounds_of(panels);
  check_region(part, argument);
  require((part.low.array() < all.high.array()).all() && (all.low.array() < part.high.array()).all(), argument, " = ",
          text_of(part), " shows nothing: the bodies lie in ", extent_of(all));
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
  fail("cut takes nothing away: the bodies lie in ", extent_of(all),
       ", none of them on the side that its normal points to; move its plane, or turn its normal round");
}

} // namespace signorini::view
